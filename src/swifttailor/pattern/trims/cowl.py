"""The folds that hang in arcs below the neck of what has a cowl."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise

import numpy as np

from swifttailor.arrays import Floats
from swifttailor.pattern.trims.chalk import Chalk
from swifttailor.pattern.trims.shapes import Patch, Trim

_FEWEST = 2
"""Fewer folds on a half are none."""
_BELOW, _DEEP = 0.5, (3.4, 4.0, 4.6)
"""How far the uppermost fold begins below the neckline in the middle, and how deep each is there, cm."""
_RISING = 0.42
"""The same at their ends, as a part of that."""
_REACH, _FREE = 11.5, 1.0
"""How far folds reach from the middle, and what stays free above them at their ends, cm."""
_BEND = 1.8
"""Folds are flat in the middle and steep at their ends: a power of the way."""
_BESIDE, _SWELL = 0.02, 1.8
"""How near the middle folds begin, and how far they stand off there, cm."""
_STEPS = 16


def cowl_folds(chalk: Chalk, name: str) -> list[Trim]:
    """Folds from shoulder to shoulder, or from strap to strap, that hang one below the other."""
    pieces: list[Trim] = []
    for side, sign in (("left", 1), ("right", -1)):
        view = chalk.views.get(f"{side}_ftorso")
        if view is None:
            return []
        inner = abs(chalk.middle(sign, view.high)) + _BESIDE  # seams of slips slant
        middle, end = view.column(sign * inner), view.column(sign * _REACH * chalk.size)
        if middle is None or end is None:
            return []
        xs = np.linspace(inner, _REACH * chalk.size, _STEPS)
        drops = chalk.size * np.cumsum([_BELOW, *_DEEP])
        arcs = [_arc(xs, middle[1] - drop, end[1] - _FREE - _RISING * drop) for drop in drops]
        found: list[Trim] = []
        for upper, lower in pairwise(arcs):
            first, second = (np.stack([sign * line[:, 0], line[:, 1]], axis=1) for line in (upper, lower))
            held = np.logical_and(view.held(first), view.held(second))
            inside = len(first) if held.all() else int(np.argmin(held))
            if inside < _STEPS // 3:
                continue
            folds = chalk.ruled(
                name, view.panel.name, first[:inside].tolist(), second[:inside].tolist(), is_cut=False
            )
            found += [replace(fold, swell=_SWELL * chalk.size) for fold in folds if isinstance(fold, Patch)]
        if len(found) < _FEWEST:
            return []
        pieces += found
    return pieces


def _arc(xs: Floats, low: float, high: float) -> Floats:
    """(n, 2) points from `low` in the middle to `high` at the end, at distances `xs` from the middle, cm."""
    share = (xs - xs[0]) / (xs[-1] - xs[0])
    return np.stack([xs, low + (high - low) * share**_BEND], axis=1)
