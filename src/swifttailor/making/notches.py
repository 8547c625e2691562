"""Notches: small marks on the sew line that tell which points of two edges are sewn to each other."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from swifttailor.making.sewn_pattern import FlatPanel, SewnPattern
from swifttailor.pattern import EdgeRef

EVERY_CM = 20.0
"""Longest stretch of a seam without a notch, on its longer edge."""
_SMOOTH_DEGREES = 30.0
"""Where the outline turns by less there is no corner to go by, so a notch marks the end of an edge."""
_CLEAR_CM = 1.2
"""A notch is left out where a corner is closer than this on either edge."""


@dataclass(frozen=True, order=True)
class Notch:
    """A mark on an edge of a panel."""

    edge: int
    fraction: float
    """Of the edge's length, from its start."""
    teeth: int
    """1 or 2: double notches are for seams between two back panels."""


@dataclass(frozen=True)
class NotchPair:
    """Two points that are sewn together."""

    stitch: int
    fractions: tuple[float, float]
    """On both edges, each from its own start."""
    teeth: int
    marked: tuple[bool, bool]
    """Whether each side has a notch there; where it has none, it has a corner."""


def pair_notches(sewn: SewnPattern) -> tuple[NotchPair, ...]:
    """Finds the points of all seams that need marking, darts aside.

    Seams get notches at least every `EVERY_CM`, at equal shares of both edges, so that they also match
    where one edge is gathered; and where one seam ends and another begins on an outline without a corner.
    """
    dart_edges = {ref for dart in sewn.darts for ref in dart.legs}
    pairs = []
    for number, stitch in enumerate(sewn.pattern.stitches):
        if stitch.first in dart_edges or sewn.partner.get(stitch.first) != stitch.second:
            continue
        panels = [sewn.panel(side.panel) for side in stitch.sides]
        teeth = 2 if all(p.placed.face == "back" for p in panels) else 1
        longest = max(sewn.length(side) for side in stitch.sides)
        count = max(math.ceil(longest / EVERY_CM - 1e-9), 1)
        for k in range(1, count):
            there = k / count
            back = there if stitch.right_wrong else 1.0 - there
            pairs.append(NotchPair(number, (there, back), teeth, (True, True)))
        for end in (0.0, 1.0):
            ends = (end, end if stitch.right_wrong else 1.0 - end)
            smooth = [_is_smooth(p, s.edge, e) for p, s, e in zip(panels, stitch.sides, ends, strict=True)]
            clear = all(
                _is_clear(p, s, e)
                for p, s, e, is_smooth in zip(panels, stitch.sides, ends, smooth, strict=True)
                if is_smooth
            )
            if any(smooth) and clear:
                pairs.append(NotchPair(number, ends, teeth, (smooth[0], smooth[1])))
    return tuple(pairs)


def panel_notches(sewn: SewnPattern, pairs: Sequence[NotchPair]) -> dict[str, tuple[Notch, ...]]:
    """The notches of every panel, each place once (with more teeth where two seams meet there)."""
    found: dict[str, dict[tuple[int, float], int]] = {p.name: {} for p in sewn.panels}
    for pair in pairs:
        sides = sewn.pattern.stitches[pair.stitch].sides
        for side, fraction, marked in zip(sides, pair.fractions, pair.marked, strict=True):
            if marked:
                place = _place(sewn.panel(side.panel), side, fraction)
                known = found[side.panel].get(place, 0)
                found[side.panel][place] = max(known, pair.teeth)
    return {
        name: tuple(sorted(Notch(edge, fraction, teeth) for (edge, fraction), teeth in places.items()))
        for name, places in found.items()
    }


def _place(panel: FlatPanel, side: EdgeRef, fraction: float) -> tuple[int, float]:
    """An edge's end is the start of the next edge."""
    if fraction == 1.0:
        return (side.edge + 1) % len(panel.edges), 0.0
    return side.edge, round(fraction, 6)


def _is_smooth(panel: FlatPanel, edge: int, end: float) -> bool:
    """Whether the outline goes on without a corner at an end of an edge."""
    count = len(panel.edges)
    before, after = (edge - 1, edge) if end == 0.0 else (edge, edge + 1)
    coming = np.diff(panel.edges[before % count][-2:], axis=0)[0]
    going = np.diff(panel.edges[after % count][:2], axis=0)[0]
    turn = np.arctan2(coming[0] * going[1] - coming[1] * going[0], float(coming @ going))
    return abs(float(np.degrees(turn))) < _SMOOTH_DEGREES


def _is_clear(panel: FlatPanel, side: EdgeRef, end: float) -> bool:
    count = len(panel.edges)
    before = side.edge - 1 if end == 0.0 else side.edge
    return min(panel.lengths[before % count], panel.lengths[(before + 1) % count]) >= _CLEAR_CM
