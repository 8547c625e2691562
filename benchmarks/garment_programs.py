"""Drafts the designs of GarmentCode samples anew and compares the patterns with those that GarmentCode made.

    python -m benchmarks.garment_programs ../shared/garmentcode/train*.jsonl.gz
    python -m benchmarks.garment_programs FILE.jsonl.gz --every 50 --timing

Each line of a file has `id`, `design` (flat parameters) and `pattern` (GarmentCode's format), drafted for its
mean body. Printed are how many patterns are the same, and for the others what differs and, where panels,
edges and stitches are the same ones, how far apart the outlines are; with --timing, milliseconds of processor
time that a pattern takes.

GarmentCode seeks the curves of sleeves and hoods by a search that ends elsewhere when the last digit of a sum
changes, so it does not make these twice alike itself: see docs/garment-programs.md.
"""

from __future__ import annotations

import argparse
import gzip
import json
import math
import time
from collections import Counter
from collections.abc import Iterator, Sequence
from itertools import islice
from pathlib import Path
from typing import Any

import numpy as np

from swifttailor.arrays import Floats
from swifttailor.errors import SwiftTailorError
from swifttailor.pattern import Arc, Cubic, Curve, Panel, Pattern, Quadratic, read_specification
from swifttailor.programs import make_pattern

VERTEX_CM, CURVE, RADIUS, TRANSLATION_CM, ROTATION_DEGREES = 0.01, 0.002, 0.002, 0.02, 0.05
"""What may differ; of radii it is a fraction."""


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("files", nargs="+", type=Path, help="samples of GarmentCode (.jsonl.gz)")
    parser.add_argument("--every", type=int, default=1, help="take every n-th line")
    parser.add_argument("--timing", action="store_true", help="print the time that a pattern takes")
    options = parser.parse_args()
    kinds: Counter[str] = Counter()
    same: Counter[str] = Counter()
    seconds: list[float] = []
    apart: list[float] = []
    for line in read_lines(options.files, options.every):
        kind = kind_of(line["design"])
        began = time.process_time()
        try:
            pattern = make_pattern(line["design"])
        except SwiftTailorError as error:
            found = [str(error)]
        else:
            seconds.append(time.process_time() - began)
            expected = read_specification(line["pattern"]).pattern
            found = differences(pattern, expected)
            if found and alike(pattern, expected):
                apart.append(distance(pattern, expected))
                found.insert(0, f"outlines within {apart[-1]:.2g} cm")
        kinds[kind] += 1
        same[kind] += not found
        if found:
            print(f"{line['id']} ({kind}): {'; '.join(found[:4])}{' ...' if len(found) > 4 else ''}")
    for kind, count in sorted(kinds.items()):
        print(f"{kind:50} {same[kind]:6} of {count:6} the same")
    for name, wanted in (("all without sleeves and hood", False), ("all with sleeves or hood", True)):
        there = [kind for kind in kinds if kind.endswith(", sleeves or hood") == wanted]
        print(f"{name:50} {sum(same[k] for k in there):6} of {sum(kinds[k] for k in there):6} the same")
    print(f"{'all':50} {same.total():6} of {kinds.total():6} the same")
    if apart:
        middle, late, most = np.percentile(apart, [50, 95, 100])
        print(
            f"{len(apart)} others have the same panels, edges and stitches; largest distance of outlines: "
            f"median {middle:.2g} cm, 95 % below {late:.2g} cm, all below {most:.2g} cm"
        )
    if options.timing and seconds:
        middle, late = np.percentile(seconds, [50, 95]) * 1000
        print(f"processor time of a pattern: median {middle:.1f} ms, 95 % below {late:.1f} ms")


def read_lines(files: Sequence[Path], every: int = 1) -> Iterator[dict[str, Any]]:
    """Every n-th line of the files."""
    for path in files:
        with gzip.open(path, "rt") as file:
            for line in islice(file, 0, None, every):
                yield json.loads(line)


def kind_of(design: dict[str, Any]) -> str:
    """Upper and lower part of a garment."""
    parts = " + ".join(str(design[name]) for name in ("meta.upper", "meta.bottom") if design[name])
    return f"{parts}, sleeves or hood" if has_searched_curves(design) else parts


def has_searched_curves(design: dict[str, Any]) -> bool:
    """Whether a garment has sleeves or a hood, with curves that GarmentCode finds by its search."""
    if not design["meta.upper"]:
        return False
    sides = [""] + ["left."] * design["left.enable_asym"]
    hood = not design["left.enable_asym"] and design["collar.component.style"] == "Hood2Panels"
    return hood or any(not design[f"{side}sleeve.sleeveless"] for side in sides)


def differences(drafted: Pattern, expected: Pattern) -> list[str]:
    """What differs between a pattern and one of GarmentCode; nothing where they are the same.

    Compared are the order of the panels, their edges from the same start on, curves, labels, places, and
    stitches in any order: GarmentCode lists them as its sets happen to be.
    """
    ours, theirs = ([p.name for p in pattern.panels] for pattern in (drafted, expected))
    if sorted(ours) != sorted(theirs):
        return [f"panels {sorted(set(ours) ^ set(theirs))} are in one only"]
    found = [] if ours == theirs else ["order of panels"]
    for panel in expected.panels:
        found += [f"{panel.name}: {what}" for what in _of_panel(drafted.panel(panel.name), panel)]
    if _stitches(drafted) != _stitches(expected):
        found.append("stitches")
    return found


def alike(a: Pattern, b: Pattern) -> bool:
    """Whether two patterns have the same panels, edges of the same kinds, and stitches."""
    kinds = [{p.name: [type(e.curve) for e in p.edges] for p in pattern.panels} for pattern in (a, b)]
    return kinds[0] == kinds[1] and _stitches(a) == _stitches(b)


def distance(a: Pattern, b: Pattern) -> float:
    """How far apart the panels of two like patterns are at most, start laid on start, cm."""
    return max(
        float(np.linalg.norm(_outline(panel) - _outline(a.panel(panel.name)), axis=1).max())
        for panel in b.panels
    )


def _outline(panel: Panel) -> Floats:
    points = [panel.sample_edge(k, 17) for k in range(len(panel.edges))]
    return np.concatenate(points) - panel.vertices[0]


def _of_panel(a: Panel, b: Panel) -> Iterator[str]:
    if len(a.edges) != len(b.edges):
        yield f"{len(a.edges)} edges in place of {len(b.edges)}"
        return
    off = float(np.abs(a.vertices - b.vertices).max())
    if off > VERTEX_CM:
        yield f"vertices by {off:.3g} cm"
    for k, (one, two) in enumerate(zip(a.edges, b.edges, strict=True)):
        if not same_curve(one.curve, two.curve):
            yield f"edge {k} is {one.curve} in place of {two.curve}"
        if one.label != two.label:
            yield f"edge {k} is labelled {one.label!r} in place of {two.label!r}"
    off = float(np.abs(np.subtract(a.placement.translation, b.placement.translation)).max())
    if off > TRANSLATION_CM:
        yield f"translation by {off:.3g} cm"
    turn = a.placement.matrix().T @ b.placement.matrix()
    off = math.degrees(math.acos(min(1.0, (np.trace(turn) - 1) / 2)))
    if off > ROTATION_DEGREES:
        yield f"rotation by {off:.3g} degrees"
    if a.label != b.label:
        yield f"label {a.label!r} in place of {b.label!r}"


def same_curve(a: Curve, b: Curve) -> bool:
    """Whether two edges are of one shape, within what may differ."""
    if type(a) is not type(b):
        return False
    if isinstance(a, Arc) and isinstance(b, Arc):
        alike = (a.large, a.right) == (b.large, b.right)
        return alike and abs(a.radius - b.radius) <= RADIUS * b.radius
    return bool(np.all(np.abs(np.subtract(_controls(a), _controls(b))) <= CURVE))


def _controls(curve: Curve) -> tuple[float, ...]:
    if isinstance(curve, Quadratic):
        return curve.control
    return (*curve.control_1, *curve.control_2) if isinstance(curve, Cubic) else ()


def _stitches(pattern: Pattern) -> Counter[Any]:
    return Counter((frozenset(stitch.sides), stitch.right_wrong) for stitch in pattern.stitches)


if __name__ == "__main__":
    main()
