"""Seams that a pattern has and cloth in a shop has not: they are not drawn."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

import numpy as np

from swifttailor.pattern.curve import Line
from swifttailor.pattern.trims.denim import has_yoke_behind

if TYPE_CHECKING:
    from swifttailor.pattern.pattern import Pattern

_TORSO = re.compile(r"(left|right)_([fb])torso$")
_BACK_LEG = re.compile(r"pant_b_[lr]$")
_STRETCHES, _ASIDE_CM = 0.03, 4.0
"""Cloth that stretches so much needs no seam to be shaped by; how far aside one in the middle runs, cm."""
_CLOSED = (
    "zip",
    "half zip",
    "back zip",
    "buttons",
    "button placket",
    "lacing",
    "back lacing",
    "back buttons",
)


def seams_of_knits(pattern: Pattern) -> frozenset[int]:
    """Indices of the stitches down the middle of close tops and one-pieces of cloth that stretches.

    Such cloth is cut on the fold, and gives where the seam would have been drawn in.
    """
    if pattern.cloth_stretch < _STRETCHES or not set(pattern.trims).isdisjoint(_CLOSED):
        return frozenset()
    found = set()
    for k, stitch in enumerate(pattern.stitches):
        parts = [_TORSO.match(side.panel) for side in stitch.sides]
        sides = {part[1] for part in parts if part}
        if sides == {"left", "right"} and len({part[2] for part in parts if part}) == 1:
            panel = pattern.panel(stitch.first.panel)
            straight = isinstance(panel.edges[stitch.first.edge].curve, Line)
            xs = panel.to_world(panel.chord(stitch.first.edge))[:, 0]
            found |= {k} if straight and float(np.abs(xs).max()) < _ASIDE_CM else set()
    return frozenset(found)


def darts_in_yokes(pattern: Pattern) -> frozenset[int]:
    """Indices of the stitches that close the darts behind of jeans: their yoke takes in what these do."""
    if not has_yoke_behind(pattern):
        return frozenset()
    return frozenset(
        k
        for k, stitch in enumerate(pattern.stitches)
        if stitch.first.panel == stitch.second.panel and _BACK_LEG.match(stitch.first.panel)
    )
