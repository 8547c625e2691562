"""An illusion neckline: fine net above a heart-shaped edge, through which one sees the skin."""

from __future__ import annotations

import numpy as np

from swifttailor.pattern.trims.chalk import Chalk
from swifttailor.pattern.trims.front_view import FrontView
from swifttailor.pattern.trims.shapes import Trim

_EDGE = ((0.0, 14.0), (3.0, 12.2), (6.0, 10.2), (9.5, 9.2), (13.0, 9.6), (17.0, 11.2), (24.0, 12.6))
"""The edge of the bodice in front: how far aside, and how far below the shoulders, cm."""
_BEHIND = 10.0
"""That of the back, which runs straight, cm."""
_FIRST, _STEP, _BETWEEN, _LEAST, _TALLEST = 0.05, 0.3, 4, 0.4, 4.0
"""Where it begins beside the middle, distance of the places at which its height is taken, of how many between
them the lowest counts, and how high it is there and in all at least, cm."""
_LEVELS = 6
"""At so many heights it is looked at whether a place lies on the panel."""


def illusion_yoke(chalk: Chalk, name: str) -> list[Trim]:
    """Above the bodice on both fronts and both backs; nothing where the neckline goes deeper."""
    pieces: list[Trim] = []
    for side, sign in (("left", 1), ("right", -1)):
        for part in ("ftorso", "btorso"):
            view = chalk.views.get(f"{side}_{part}")
            if view is None or view.high < chalk.shoulder - chalk.size:
                return []
            found = _half(chalk, name, view, sign, front=part == "ftorso")
            if not found and part == "ftorso":
                return []
            pieces += found
    return pieces


def _half(chalk: Chalk, name: str, view: FrontView, sign: int, *, front: bool) -> list[Trim]:
    """The net on one panel."""
    s = chalk.size
    aside, below = np.transpose(_EDGE)
    first, second = [], []
    for x in np.arange(_FIRST, 40.0 * s, _STEP * s):
        edge = chalk.shoulder - s * (float(np.interp(x / s, aside, below)) if front else _BEHIND)
        top = _top(view, sign, float(x), _STEP * s)
        held = top is not None and top > edge + _LEAST * s
        if top is None or not held or not _on_panel(view, sign * float(x), edge, top):
            if first:
                break
            continue
        first.append((sign * float(x), edge))
        second.append((sign * float(x), top))
    if len(first) < 4 or max(b[1] - a[1] for a, b in zip(first, second, strict=True)) < _TALLEST * s:
        return []
    if front and first[0][0] * sign > 8.0 * s:  # so deep a neckline leaves no net in the middle
        return []
    return chalk.ruled(name, view.panel.name, first, second, to_the_edge=True)


def _top(view: FrontView, sign: int, x: float, step: float) -> float | None:
    """The lowest upper edge of a panel within a step of a place, cm: none between lies above it."""
    near = np.linspace(max(x - step, 0.5 * _FIRST), x + step, 2 * _BETWEEN + 1)
    columns = [view.column(sign * float(one)) for one in near]
    return None if None in columns else min(column[1] for column in columns if column is not None)


def _on_panel(view: FrontView, x: float, low: float, high: float) -> bool:
    """Whether all between two heights is cloth, and no dart or armhole."""
    return all(view.on_cloth([(x, float(y)) for y in np.linspace(low, high, _LEVELS)]))
