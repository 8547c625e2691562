"""Cloth drawn over the left shoulder of saris and togas, from the right of the waist and down the back."""

from __future__ import annotations

import numpy as np

from swifttailor.arrays import Floats
from swifttailor.pattern.trims.chalk import Chalk
from swifttailor.pattern.trims.front_view import FrontView
from swifttailor.pattern.trims.shapes import Trim

_FRONTS = ("right_ftorso", "left_ftorso")
_BACK = "left_btorso"
_AT_WAIST, _AT_SHOULDER = 0.98, 0.66
"""Where its middle lies: at the waist, as a part of the way to the right side, and on the shoulder, as a part
of the way from the middle to the left tip."""
_WIDE_BELOW, _WIDE_ABOVE = 24.0, 11.0
"""How wide it is there, cm."""
_ROWS, _LEAST, _FEWEST = 40, 0.4, 6
"""Of rows in which it is laid on a panel; how wide a row is at least, cm; and how many a piece has."""
_INSIDE, _IN_MIDDLE, _MIDDLE = 0.45, 0.05, 3.0
"""How far it stays inside of a panel, and nearer to the middle than the last, cm."""
_BARE = 4.0
"""A front that ends so far below the shoulder has none to hold it, cm."""
_FOLDS, _FOLD = (0.25, 0.5, 0.75), 0.1
"""Where its folds lie, as parts of its width, and half the width of the lines that are these, cm."""


def shoulder_drape(chalk: Chalk, name: str) -> list[Trim]:
    """Across both fronts to the left shoulder, and from there down the back to the waist."""
    right, left = [chalk.views.get(panel) for panel in _FRONTS]
    back = chalk.views.get(_BACK)
    if left is None or back is None or left.high < chalk.shoulder - _BARE * chalk.size:
        return []
    fronts = [left] if right is None else [right, left]
    low = max(chalk.waist, *[view.low for view in fronts])  # below it lies cloth of the same colour
    spans = [view.span(low + 0.5) for view in fronts]
    side = _AT_WAIST * min([span[0] for span in spans if span is not None], default=0.0)
    tip = float(left.outline[left.outline[:, 1] > left.high - 6.0, 0].max())
    shoulder = _AT_SHOULDER * tip
    across = np.array([[side, low], [shoulder, left.high]])
    down = np.array([[shoulder, low], [shoulder, back.high]])
    wide, narrow = _WIDE_BELOW * chalk.size, _WIDE_ABOVE * chalk.size
    on_left = _piece(chalk, name, left, across, (wide, narrow))
    on_back = _piece(chalk, name, back, down, (narrow, narrow))
    if not on_left or not on_back:
        return []
    on_right = [] if right is None else _piece(chalk, name, right, across, (wide, narrow))
    return [*on_right, *on_left, *on_back]


def _piece(
    chalk: Chalk, name: str, view: FrontView, middle: Floats, widths: tuple[float, float]
) -> list[Trim]:
    """What of it lies on one panel, with the folds in it.

    Args:
        chalk: Of the pattern.
        name: Of the trim.
        view: Of the panel.
        middle: (2, 2) the ends of its middle line in the view, the lower first, cm.
        widths: How wide it is there, cm.
    """
    heights = np.linspace(max(view.low, middle[0, 1]) + _INSIDE, view.high - _INSIDE, _ROWS)
    rows: list[tuple[float, float, float, float, float]] = []
    for y in heights:
        share = float(np.clip((y - middle[0, 1]) / (middle[1, 1] - middle[0, 1]), 0.0, 1.0))
        x = float(middle[0, 0] + share * (middle[1, 0] - middle[0, 0]))
        half = float(widths[0] + share * (widths[1] - widths[0])) / 2
        span = view.span(float(y))
        if span is None:
            continue
        left, right = max(span[0] + _inside(span[0]), x - half), min(span[1] - _inside(span[1]), x + half)
        if right - left >= _LEAST and view.holds([(left, y), (right, y)]):
            rows.append((float(y), left, right, x - half, x + half))
    if len(rows) < _FEWEST:
        return []
    first = [(left, y) for y, left, *_ in rows]
    second = [(right, y) for y, _, right, *_ in rows]
    if not view.carries([*first, *second[::-1]]):
        return []
    found = chalk.ruled(name, view.panel.name, first, second, to_the_edge=True)
    for share in _FOLDS if found else ():
        fold = [(a + share * (b - a), y) for y, _, _, a, b in rows]
        within = [p for p, (_, lo, hi, *_) in zip(fold, rows, strict=True) if lo + 0.5 < p[0] < hi - 0.5]
        found += chalk.line(name, view.panel.name, within, width=_FOLD) if len(within) > 2 else []
    return found


def _inside(x: float) -> float:
    return _IN_MIDDLE if abs(x) <= _MIDDLE else _INSIDE
