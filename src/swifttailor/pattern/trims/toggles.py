"""Toggles: pegs of horn or wood on the edge of a front, held by loops of cord, as duffle coats have them."""

from __future__ import annotations

import math

import numpy as np

from swifttailor.pattern.trims.chalk import Chalk
from swifttailor.pattern.trims.front_view import edge_at, front_edge
from swifttailor.pattern.trims.pockets import patch_pockets
from swifttailor.pattern.trims.shapes import Patch, Trim

_SPACING, _MOST, _LEAST = 13.0, 4, 2
_FROM_NECK, _FROM_END, _SHORTEST = 7.0, 5.0, 16.0
"""How far the uppermost is from the neck and the lowest from where the front opens, cm; and the shortest
front that has toggles."""
_POCKETS, _ABOVE_POCKETS = "patch pockets", 4.0
"""What toggles do not run into, and how far above it the lowest is, cm."""
_HALF = ((0.05, 0.8), (2.3, 0.8), (2.35, 0.3), (6.0, 0.3), (6.05, 1.6), (9.0, 1.6))
"""Of half a peg, its cord and the patch that holds it: distance from the middle and half the height, cm."""


def toggles(chalk: Chalk, name: str) -> list[Trim]:
    """Up to four down the front, as far as it is joined."""
    seam = front_edge(chalk.pattern)
    if seam is None or not all(ref.panel in chalk.views for ref in seam[:2]):
        return []
    right, left, low, high = seam
    s = chalk.size
    top, bottom = high - _FROM_NECK * s, max(low + _FROM_END * s, _above_pockets(chalk))
    if high - low < _SHORTEST * s or top <= bottom:
        return []
    many = min(max(round((top - bottom) / (_SPACING * s)) + 1, _LEAST), _MOST)
    pieces: list[Trim] = []
    for y in np.linspace(top, max(bottom, top - (many - 1) * _SPACING * s), many):
        pair: list[Trim] = []
        for ref, sign in ((right, -1), (left, 1)):
            middle = edge_at(chalk.pattern, ref, float(y))
            above, below = (
                [(middle + sign * x * s, float(y) + way * h * s) for x, h in _HALF] for way in (1, -1)
            )
            pair += chalk.ruled(name, ref.panel, above, below, is_cut=False)
        pieces += pair if len(pair) == 2 else []
    return pieces


def _above_pockets(chalk: Chalk) -> float:
    """How low a toggle may be beside pockets, cm; minus infinity without any."""
    pockets = patch_pockets(chalk, _POCKETS) if _POCKETS in chalk.pattern.trims else []
    tops = [float(chalk.views[p.panel].seen(p.first)[:, 1].max()) for p in pockets if isinstance(p, Patch)]
    return max(tops, default=-math.inf) + _ABOVE_POCKETS * chalk.size
