"""How near drafts of the design parameters that are read in pictures are to the patterns that were pictured.

``python benchmarks/drafts_of_pictures.py DRAPES/validation --look people --limit 100 --seen 0 0.5 1``

One picture of each garment is read, the part of the body that the garment covers is drafted, and nothing is
cut or compared with the picture: the first design that the programs accept. A row for each weight of what a
picture shows of a parameter itself, beside what follows from its reading (`parameter_reader.SEEN`). Edges and
on: of the drafts with the right number of panels.
"""

from __future__ import annotations

import argparse
from itertools import islice
from pathlib import Path
from typing import Any

from machine import describe
from swifttailor.data.reader import SplitReader
from swifttailor.describing.measuring import measure_facts
from swifttailor.evaluation.maker.looks import LOOKS, LookPictures
from swifttailor.evaluation.patterns.pattern_table import summarize_patterns
from swifttailor.parameter_reader import ParameterReader, reader
from swifttailor.pattern import Pattern
from swifttailor.pattern_library.sought import Sought
from swifttailor.picture_reader.labels import PARTS
from swifttailor.picture_reader.reader import SHIPPED_PLAIN, PictureReader
from swifttailor.picture_reader.reading import PartReading
from swifttailor.picture_reader.truth import Truth
from swifttailor.programs import DesignError, make_pattern
from swifttailor.tailor.designed import MOST_DESIGNS

SHOWN = {
    "panels_right": ("panels %", 100),
    "edges_in_order": ("edges %", 100),
    "vertex_cm": ("vertex cm", 1),
    "translation_cm": ("translation cm", 1),
    "stitches": ("stitches %", 100),
}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("data", type=Path, help="a split of sewn or draped garments")
    parser.add_argument("--look", choices=LOOKS, default="plain")
    parser.add_argument("--view", choices=("front", "back", "free"), default="front")
    parser.add_argument("--limit", type=int, default=100, help="garments, from all over the split")
    parser.add_argument("--seen", type=float, nargs="+", default=[0.0, reader.SEEN])
    parser.add_argument("--weights", type=Path, help="another picture reader")
    parser.add_argument("--plain-reader-weights", type=Path, help="another one for plain pictures")
    options = parser.parse_args()
    eyes = PictureReader.load()
    if options.weights or options.plain_reader_weights:
        plain = [options.plain_reader_weights or SHIPPED_PLAIN[0], *SHIPPED_PLAIN[1:]]
        eyes = PictureReader.load(options.weights, plain=plain)
    shown = read(eyes, options)
    print(describe())
    print(f"{len(shown)} garments, {options.look}, {options.view}")
    parameters = ParameterReader.load()
    for weight in options.seen:
        reader.SEEN = weight
        drafts = [draft(parameters, part) for _, _, part in shown]
        means = summarize_patterns(drafts, [pattern for _, pattern, _ in shown]).aipparel
        rows = ", ".join(f"{name} {means[key].mean * by:.1f}" for key, (name, by) in SHOWN.items())
        print(f"seen {weight}: {rows}")


def read(eyes: PictureReader, options: Any) -> list[tuple[str, Pattern, PartReading | None]]:
    """Ids and patterns, and what is read of the part that each covers; None where nothing is seen there."""
    samples, pictures = SplitReader(options.data), LookPictures(options.data, 0, options.look, options.view)
    step = max(1, len(samples.ids) // options.limit)
    found = []
    for id in samples.ids[::step][: options.limit]:
        pattern = samples.sample(id).pattern
        covers = PARTS[Truth.of(pattern, measure_facts(pattern)).part]
        seen = eyes.read(pictures.picture(id)[1][0]).parts
        found.append((id, pattern, next((one for one in seen if one.part == covers), None)))
    return found


def draft(parameters: ParameterReader, part: PartReading | None) -> Pattern | None:
    """The first design that is accepted."""
    if part is None:
        return None
    for design in islice(parameters.designs(Sought.of_reading(part), part.design, seed=0), MOST_DESIGNS):
        try:
            return make_pattern(design).canonical()
        except DesignError:
            continue
    return None


if __name__ == "__main__":
    main()
