"""How near drafts of the design parameters that are read in pictures are to the patterns that were pictured.

``python benchmarks/drafts_of_pictures.py DRAPES/validation --look people --limit 100 --seen 0 0.5 1``

One picture of each garment is read (or a front and a back), the part of the body that the garment covers is
drafted, and nothing is cut or compared with the picture: the first design that the programs accept. A row for
each weight of what a picture shows of a parameter itself, beside what follows from its reading
(`parameter_reader.SEEN`); with ``--again`` another after the second reading (`tailor.second_reading`). Edges
and on: of the drafts with the right number of panels; "by name": of all. ``--by-edges`` tells what panels
with another number of edges than the true one cost, whose points are compared with those of other corners.
"""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import Any

import numpy as np

from machine import describe
from swifttailor.data.reader import SplitReader
from swifttailor.describing.measuring import measure_facts
from swifttailor.errors import NothingSeenError
from swifttailor.evaluation.maker.looks import LOOKS, LookPictures
from swifttailor.evaluation.patterns.aipparel import aipparel_score
from swifttailor.evaluation.patterns.panel_geometry import vertex_distance
from swifttailor.evaluation.patterns.pattern_table import summarize_patterns
from swifttailor.parameter_reader import reader
from swifttailor.pattern import Pattern
from swifttailor.picture_reader.labels import PARTS
from swifttailor.picture_reader.reader import SHIPPED_PLAIN, PictureReader
from swifttailor.picture_reader.truth import Truth
from swifttailor.tailor import Order, Tailor
from swifttailor.tailor.designed import DesignedCandidate
from swifttailor.tailor.reading import Wanted
from swifttailor.tailor.second_reading import SecondReading

SHOWN = {
    "panels_right": ("panels %", 100),
    "edges_in_order": ("edges %", 100),
    "vertex_cm": ("vertex cm", 1),
    "translation_cm": ("translation cm", 1),
    "stitches": ("stitches %", 100),
}
BY_NAME = {
    "edges": ("edges %", 100),
    "vertex_cm": ("vertex cm", 1),
    "translation_cm": ("translation cm", 1),
    "stitch_f1": ("stitches F1 %", 100),
}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("data", type=Path, help="a split of sewn or draped garments")
    parser.add_argument("--look", choices=LOOKS, default="plain")
    parser.add_argument("--view", choices=("front", "back", "free", "both"), default="front")
    parser.add_argument("--limit", type=int, default=100, help="garments, from all over the split")
    parser.add_argument("--seen", type=float, nargs="+", default=[0.0, reader.SEEN])
    parser.add_argument("--again", action="store_true", help="also as they are after the second reading")
    parser.add_argument("--by-edges", action="store_true", help="also by whether edges are as many")
    parser.add_argument("--weights", type=Path, help="another picture reader")
    parser.add_argument("--plain-reader-weights", type=Path, help="another one for plain pictures")
    parser.add_argument("--plain-neck-weights", type=Path, help="another one for necks of plain pictures")
    options = parser.parse_args()
    eyes = PictureReader.load()
    others = (options.plain_reader_weights, options.plain_neck_weights, None)
    if options.weights or any(others):
        plain = [other or shipped for other, shipped in zip(others, SHIPPED_PLAIN, strict=True)]
        eyes = PictureReader.load(options.weights, plain=plain)
    tailor = Tailor(picture_reader=eyes)
    shown = read(tailor, options)
    print(describe())
    print(f"{len(shown)} garments, {options.look}, {options.view}")
    again = SecondReading(tailor.garment_sewer, eyes)
    for weight in options.seen:
        reader.SEEN = weight
        for name, second in {"": None, ", read again": again}.items():
            if second is None or options.again:
                drafts = [draft(tailor, wanted, second) for _, wanted in shown]
                patterns = [pattern for pattern, _ in shown]
                print(f"seen {weight}{name}: {row(drafts, patterns)}", flush=True)
                if options.by_edges:
                    print(by_edges(drafts, patterns), flush=True)


def read(tailor: Tailor, options: Any) -> list[tuple[Pattern, Wanted | None]]:
    """Patterns, and what is wanted of those who show them; None where nothing is seen there."""
    samples, pictures = SplitReader(options.data), LookPictures(options.data, 0, options.look, options.view)
    step = max(1, len(samples.ids) // options.limit)
    found: list[tuple[Pattern, Wanted | None]] = []
    for id in samples.ids[::step][: options.limit]:
        pattern = samples.sample(id).pattern
        covers = PARTS[Truth.of(pattern, measure_facts(pattern)).part]
        try:
            found.append((pattern, tailor.read(Order(image=pictures.picture(id)[1], part=covers))))
        except NothingSeenError:
            found.append((pattern, None))
    return found


def draft(tailor: Tailor, wanted: Wanted | None, second: SecondReading | None) -> Pattern | None:
    """The first design that is accepted, as it is drafted."""
    parameters = tailor.parameter_reader
    if wanted is None or parameters is None:
        return None
    made = DesignedCandidate(parameters, wanted, 0, second)
    return made.take(0).written.pattern if len(made) else None


def row(drafts: list[Pattern | None], patterns: list[Pattern]) -> str:
    """Metrics of all drafts."""
    means = summarize_patterns(drafts, patterns)
    first = [f"{name} {means.aipparel[key].mean * by:.1f}" for key, (name, by) in SHOWN.items()]
    second = [f"{name} {means.by_name[key].mean * by:.1f}" for key, (name, by) in BY_NAME.items()]
    return f"{', '.join(first)}; by name {', '.join(second)}"


def by_edges(drafts: list[Pattern | None], patterns: list[Pattern]) -> str:
    """Distances of panels with as many edges as the true ones, and of the others; of stitches by garments."""
    shapes: dict[bool, list[tuple[float, float]]] = {True: [], False: []}
    stitches: dict[bool, list[float]] = {True: [], False: []}
    garments = 0
    for draft, pattern in zip(drafts, patterns, strict=True):
        score = aipparel_score(draft, pattern)
        if draft is None or score.stitches is None:
            continue
        garments += 1
        pairs = list(zip(draft.panels, pattern.canonical().panels, strict=True))
        alike = [len(made.edges) == len(true.edges) for made, true in pairs]
        for (made, true), same in zip(pairs, alike, strict=True):
            shapes[same].append((vertex_distance(made, true), 1.0 / len(pairs)))
        stitches[all(alike)].append(score.stitches)
    parts = []
    for same, what in ((True, "as many edges"), (False, "other numbers of edges")):
        distance, share = np.array(shapes[same]).reshape(-1, 2).T
        mean, total = distance @ share / share.sum(), distance @ share / garments
        parts.append(
            f"panels with {what}: {share.sum() / garments:.1%}, vertices {mean:.1f} cm, {total:.2f} of all; "
            f"garments with {'them alone' if same else 'one'}: {len(stitches[same])}, "
            f"stitches {np.mean(stitches[same]):.1%}"
        )
    return "\n".join(parts)


if __name__ == "__main__":
    main()
