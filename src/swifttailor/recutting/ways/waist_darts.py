"""Darts at the lower edge of a bodice: they take in below what stays wide at the chest."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from swifttailor.pattern import EdgeRef, Line, Pattern
from swifttailor.recutting.table.workbench import Workbench

_BESIDE_CM = 4.0
"""What stays at least of the lower edge on either side of a dart."""


def add_waist_darts(
    pattern: Pattern, edges: Sequence[EdgeRef], width: float, depth: float, place: float
) -> Pattern | None:
    """Cuts a dart into every lower edge of a bodice, and sews it.

    Args:
        pattern: Any pattern.
        edges: Lower edges, one of each panel; sewn or free.
        width: Of a dart at the edge, cm.
        depth: From the edge to its point, cm.
        place: Distance of the darts from the middle of the body, cm.

    Returns:
        The pattern, its panels narrower below by the width of a dart each; None where an edge is too short,
        or there is another of the same panel.
    """
    bench = Workbench(pattern)
    if len({r.panel for r in edges}) != len(edges):
        return None
    for ref in edges:
        if not _cut(bench, bench.at[ref], width, depth, place):
            return None
    return bench.pattern()


def _cut(bench: Workbench, side: int, width: float, depth: float, place: float) -> bool:
    piece, partner = bench.piece_of(side), bench.partner(side)
    length = piece.length(side)
    x = np.abs(piece.panel.to_world(piece.chord(side))[:, 0])
    way = (place - x[0]) / (x[1] - x[0]) if abs(x[1] - x[0]) > 1.0 else 0.5
    middle = float(np.clip(way, 0.3, 0.7)) * length
    before, after = middle - width / 2, length - middle - width / 2
    if min(before, after) < _BESIDE_CM:
        return False
    last = bench.split(side, (middle + width / 2) / length)
    first_leg = bench.split(side, before / piece.length(side))
    start, end = piece.chord(first_leg)
    along = (end - start) / np.hypot(*(end - start))
    turn = 1.0 if piece.panel.signed_area() >= 0 else -1.0
    point = (start + end) / 2 + depth * turn * np.array([-along[1], along[0]])
    bench.side(first_leg).edge = replace(bench.side(first_leg).edge, curve=Line(), label="")
    second_leg = bench.insert_line(last, point)
    bench.sew(first_leg, second_leg)
    if partner is not None:
        # The seam runs against the partner's direction.
        rest = bench.split(partner, after / (before + after))
        bench.resew(partner, rest)
        bench.sew(last, partner)
    return True
