"""The folds that hang in arcs below the neck of what has a cowl."""

from __future__ import annotations

import numpy as np

from swifttailor.pattern.trims.chalk import Chalk
from swifttailor.pattern.trims.shapes import Trim

_COUNT, _FEWEST = 4, 2
_BELOW, _APART = 1.4, 2.9
"""How far the uppermost arc hangs below the neckline, and each below the one above it, in the middle, cm."""
_RISING = 0.75
"""The same at their ends, as a part of that."""
_REACH, _FREE = 11.5, 1.2
"""How far arcs reach from the middle, and what stays free at their ends, cm."""
_BEND = 2.2
"""Arcs are flat in the middle and steep at their ends: a power of the way."""
_BESIDE, _LINE = 0.2, 0.16
"""How near the middle arcs begin, and half the width of what is drawn of one, cm."""


def cowl_folds(chalk: Chalk, name: str) -> list[Trim]:
    """Arcs from shoulder to shoulder, or from strap to strap, one below the other."""
    pieces: list[Trim] = []
    for side, sign in (("left", 1), ("right", -1)):
        view = chalk.views.get(f"{side}_ftorso")
        if view is None:
            return []
        inner = abs(chalk.middle(sign, view.high)) + _BESIDE  # seams of slips slant
        middle = view.column(sign * inner)
        if middle is None:
            return []
        reach = _REACH * chalk.size
        end = view.column(sign * reach)
        if end is None:
            return []
        xs = np.linspace(inner, reach, 14)
        found: list[Trim] = []
        for k in range(_COUNT):
            drop = (_BELOW + k * _APART) * chalk.size
            low, high = middle[1] - drop, end[1] - _FREE - _RISING * drop
            points = np.stack([sign * xs, low + (high - low) * (xs / reach) ** _BEND], axis=1)
            held = view.held(points)
            inside = len(points) if held.all() else int(np.argmin(held))
            found += chalk.line(name, view.panel.name, points[: max(inside - 1, 0)].tolist(), width=_LINE)
        if len(found) < _FEWEST:
            return []
        pieces += found
    return pieces
