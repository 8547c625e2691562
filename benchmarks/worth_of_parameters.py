"""Which design parameters are worth reading better in pictures.

``python benchmarks/worth_of_parameters.py DRAPES/validation --patterns validation.jsonl.gz --look plain``

One picture of each garment is read and drafted as in drafts_of_pictures.py. Then each design parameter has
its true value in every draft, all others as they were read: what the metrics gain is what is lost by reading
it wrongly. Patterns have their designs beside them (``design``), as those of scripts/sample_garmentcode.py.
The last row is of drafts of which every parameter is true.
"""

from __future__ import annotations

import argparse
import gzip
import json
from pathlib import Path
from typing import Any

from drafts_of_pictures import SHOWN, read
from machine import describe
from swifttailor.evaluation.maker.looks import LOOKS
from swifttailor.evaluation.patterns.pattern_table import summarize_patterns
from swifttailor.parameter_reader import ParameterReader
from swifttailor.parameter_reader.placed_designs import PlacedDesigns
from swifttailor.pattern import Pattern
from swifttailor.picture_reader.reader import PictureReader
from swifttailor.programs import DesignError, make_pattern
from swifttailor.tailor import Tailor
from swifttailor.tailor.designed import DesignedCandidate
from swifttailor.tailor.reading import Wanted
from swifttailor.tailor.second_reading import SecondReading

Design = dict[str, Any]


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("data", type=Path, help="a split of sewn or draped garments")
    parser.add_argument("--patterns", type=Path, required=True, help=".jsonl.gz with id and design")
    parser.add_argument("--look", choices=LOOKS, default="plain")
    parser.add_argument("--view", choices=("front", "back", "free"), default="front")
    parser.add_argument("--limit", type=int, default=141, help="garments, from all over the split")
    parser.add_argument("--again", action="store_true", help="drafts are drawn and read again first")
    parser.add_argument("--rows", type=int, default=20, help="parameters to show, those worth most first")
    options = parser.parse_args()
    parameters, eyes = ParameterReader.load(), PictureReader.load()
    truths = true_designs(options.patterns, parameters)
    tailor = Tailor(picture_reader=eyes)
    again = SecondReading(tailor.garment_sewer, eyes) if options.again else None
    shown = []
    for pattern, wanted in read(tailor, options):
        design = None if wanted is None else design_of(parameters, wanted, again)
        if design is not None and pattern.name in truths:
            shown.append((pattern, design, truths[pattern.name]))
    patterns = [pattern for pattern, _, _ in shown]
    as_read = means([drafted(said) for _, said, _ in shown], patterns)
    print(describe())
    print(f"{len(shown)} garments, {options.look}, {options.view}")
    print("as read: " + row(as_read))
    found = []
    for one in parameters.parameters:
        name = one.name
        wrong = sum(name in true and true[name] != said.get(name) for _, said, true in shown)
        if wrong:
            drafts = [drafted(said | {name: true[name]} if name in true else said) for _, said, true in shown]
            gained = {key: value - as_read[key] for key, value in means(drafts, patterns).items()}
            found.append((gained, name, wrong, sum(name in true for _, _, true in shown)))
    for gained, name, wrong, asked in sorted(found, key=lambda each: -worth(each[0]))[: options.rows]:
        print(f"{name}, read wrongly in {wrong} of {asked}: " + row(gained))
    print("all true: " + row(means([drafted(said | true) for _, said, true in shown], patterns)))


def true_designs(path: Path, reader: ParameterReader) -> dict[str, Design]:
    """By id: the values of the parameters that a garment follows from, as far as they are read."""
    with gzip.open(path, "rt", encoding="utf-8") as file:
        designs = {line["id"]: line["design"] for line in map(json.loads, file)}
    placed = PlacedDesigns.of(designs, reader.parameters)
    return {
        id: {
            one.name: one.values[place]
            for one, place, matters in zip(placed.parameters, placed.places[k], placed.matter[k], strict=True)
            if matters
        }
        for id, k in placed.rows.items()
    }


def design_of(reader: ParameterReader, wanted: Wanted, second: SecondReading | None) -> Design | None:
    """The first design of what is read that GarmentCode's rules accept."""
    made = DesignedCandidate(reader, wanted, 0, second)
    return dict(made.take(0).design or {}) if len(made) else None


def drafted(design: Design) -> Pattern | None:
    """Its pattern; None where GarmentCode's rules refuse it."""
    try:
        return make_pattern(design).canonical()
    except DesignError:
        return None


def means(drafts: list[Pattern | None], patterns: list[Pattern]) -> dict[str, float]:
    """What is shown of drafts beside the patterns that were pictured."""
    found = summarize_patterns(drafts, patterns).aipparel
    return {key: found[key].mean * by for key, (_, by) in SHOWN.items()}


def worth(gained: dict[str, float]) -> float:
    """What rows are sorted by: points of panels, edges and stitches."""
    return gained["panels_right"] + gained["edges_in_order"] + gained["stitches"]


def row(values: dict[str, float]) -> str:
    """In one line."""
    return ", ".join(f"{SHOWN[key][0]} {value:.1f}" for key, value in values.items())


if __name__ == "__main__":
    main()
