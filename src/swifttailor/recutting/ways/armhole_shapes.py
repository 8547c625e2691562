"""Cutting free armholes to another shape between the same ends."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Literal

import numpy as np

from swifttailor.pattern import Cubic, Line, Pattern
from swifttailor.pattern.curve import to_relative
from swifttailor.recutting.table.workbench import Workbench
from swifttailor.recutting.ways.sleeves import Hole

HoleShape = Literal["round", "square", "angled"]
_CORNER: dict[HoleShape, tuple[float, float]] = {"square": (0.0, 1.0), "angled": (0.25, 0.75)}
"""Where the corner lies, on the way out to the underarm and on the way down to it."""
_ROUND = 0.6
"""How far from either end towards the corner of a square one the controls of a round one lie."""


def reshape_armholes(pattern: Pattern, holes: Sequence[Hole], shape: HoleShape) -> Pattern:
    """Cuts armholes round, square or at an angle, in front and behind; their ends stay.

    Args:
        pattern: Any pattern.
        holes: Its free armholes.
        shape: Of the cut.
    """
    bench = Workbench(pattern)
    for hole in holes:
        for down in (hole.front, hole.back):
            ids = [bench.at[r] for r in down]
            first, last = (ids[0], ids[-1]) if len(ids) == 1 else _in_loop_order(bench, ids)
            chord = np.array([bench.side(first).start, bench.piece_of(last).end(last)])
            high = chord[:, 1].argmax()
            shoulder, under = chord[high], chord[1 - high]
            out, fall = under - shoulder
            across, along = _CORNER.get(shape, (0.0, 1.0))
            corner = shoulder + np.array([across * out, along * fall])
            for id in ids:
                if id != first:
                    bench.drop(id)
            side = bench.side(first)
            if shape == "round":
                controls = [to_relative(end + _ROUND * (corner - end), chord) for end in chord]
                side.edge = replace(side.edge, curve=Cubic(controls[0], controls[1]))
            else:
                side.edge = replace(side.edge, curve=Line())
                second = bench.insert_line(bench.neighbour(first, 1), corner)
                bench.relabel(second, side.edge.label)
    return bench.pattern()


def _in_loop_order(bench: Workbench, ids: Sequence[int]) -> tuple[int, int]:
    """The first and the last of a run of sides in the order of their loop."""
    own = set(ids)
    first = next(i for i in ids if bench.neighbour(i, -1) not in own)
    last = next(i for i in ids if bench.neighbour(i, 1) not in own)
    return first, last
