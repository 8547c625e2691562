"""The folds of a cowl neck: arcs that hang from both shoulders, one below the other."""

from __future__ import annotations

import numpy as np

from swifttailor.pattern.trims.chalk import Chalk
from swifttailor.pattern.trims.shapes import Trim

_HALVES = (("left", 1), ("right", -1))
_BELOW_NECK = (2.2, 5.6, 9.6, 14.2)
"""How far below the neckline each fold hangs in the middle, cm."""
_REACH, _RISE = (0.5, 0.6, 0.68, 0.74), (9.0, 9.5, 9.5, 9.0)
"""Where each begins, as a part of the way from the middle to the side; and how far it rises to there, cm."""
_BELOW_EDGE, _STEEP, _WIDTH = 0.9, 1.9, 0.26
"""Least distance from the upper edge, cm; how its arc bends; half its width in the middle as drawn, cm."""
_LEAST, _BESIDE, _INSIDE = 2, 1.8, 0.04
"""So many folds make a cowl; how far beside the middle a half is looked at, and how far inside of the seam
there a fold begins, cm."""


def neck_folds(chalk: Chalk, name: str) -> list[Trim]:
    """Arcs across the chest; nothing on what has a collar or a hood."""
    if any("collar" in panel.name or "hood" in panel.name for panel in chalk.pattern.panels):
        return []
    s = chalk.size
    views = [(chalk.views.get(f"{half}_ftorso"), sign) for half, sign in _HALVES]
    columns = [None if view is None else view.column(sign * _BESIDE) for view, sign in views]
    ends = [column for column in columns if column is not None]
    if len(ends) < 2:
        return []
    low, high = max(end[0] for end in ends), min(end[1] for end in ends)
    pieces: list[Trim] = []
    count = 0
    for below, reach, rise in zip(_BELOW_NECK, _REACH, _RISE, strict=True):
        bottom, found = high - below * s, []
        if bottom < low + 2.0 * s:
            break
        for view, sign in views:
            assert view is not None
            span = view.span(bottom)
            if span is None:
                break
            side, inner = max(abs(span[0]), abs(span[1])), 0.0
            if span[0] * span[1] > 0:  # the seam in the middle of what hangs on straps slants
                inner = min(abs(span[0]), abs(span[1]))
            xs = np.linspace(inner + _INSIDE, reach * side, 15)
            tops = [column[1] - _BELOW_EDGE * s for x in xs if (column := view.column(sign * x)) is not None]
            if len(tops) < len(xs):
                break
            # No higher than beside a strap, which a fold does not go up.
            near = np.minimum.reduce([tops, [*tops[1:], tops[-1]], [tops[0], *tops[:-1]]])
            ys = np.minimum(bottom + rise * s * ((xs - xs[0]) / (xs[-1] - xs[0])) ** _STEEP, near)
            half = _WIDTH * (1.0 - 0.85 * ((xs - xs[0]) / (xs[-1] - xs[0])) ** 2)
            lines = [
                [(sign * float(x), float(y)) for x, y in zip(xs, ys + off * half, strict=True)]
                for off in (-1, 1)
            ]
            border = [*lines[0], *lines[1][::-1]]
            if view.bridges(border) and view.carries(border):
                found += chalk.ruled(name, view.panel.name, *lines, "dark", is_cut=False, to_the_edge=True)
        if len(found) < 2:
            continue
        pieces, count = [*pieces, *found], count + 1
    return pieces if count >= _LEAST else []
