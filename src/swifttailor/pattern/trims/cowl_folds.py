"""Folds of a cowl: soft curves that hang from both shoulders or straps below the neckline."""

from __future__ import annotations

import numpy as np

from swifttailor.pattern.trims.chalk import Chalk
from swifttailor.pattern.trims.front_view import FrontView
from swifttailor.pattern.trims.shapes import Trim

_HALVES = (("left", 1), ("right", -1))
_FOLDS: tuple[tuple[float, float], ...] = ((2.2, 0.0), (5.4, 0.9), (9.2, 2.0))
"""How far below the edge each hangs in the middle, and how much farther out it begins than the first, cm."""
_BEGINS, _STRAP = 2.0, 1.6
"""The first begins so far outside of the neckline, where that is highest; and so far inside of a strap's
outer side where there is less room, cm."""
_LINE, _MIDDLE, _UPPER = 0.24, 0.1, 0.5
"""Half the width of what is drawn of a fold, how near to the middle it comes, what stays free above, cm."""
_TURN = 0.44 * np.pi
"""How far round a fold is followed, of a quarter of a circle and a little less."""
_SHORTEST = 6.0


def cowl_folds(chalk: Chalk, name: str) -> list[Trim]:
    """Curves that the cloth of a cowl falls in, nested below the edge of the neck."""
    if any("collar" in panel.name or "hood" in panel.name for panel in chalk.pattern.panels):
        return []
    pieces: list[Trim] = []
    for half, sign in _HALVES:
        view = chalk.views.get(f"{half}_ftorso")
        found = [] if view is None else _on_half(chalk, name, view, sign)
        if not found:
            return []
        pieces += found
    return pieces


def _on_half(chalk: Chalk, name: str, view: FrontView, sign: int) -> list[Trim]:
    s = chalk.size
    middle = view.column(sign * 1.2)
    widest = view.span(view.high - _UPPER * s)
    if middle is None or widest is None or view.high - middle[1] < 1.0 * s:
        return []  # strapless, or straight across
    inner, outer = sorted(abs(x) for x in widest)
    pieces: list[Trim] = []
    for below, out in _FOLDS:
        begins = min(inner + (_BEGINS + out) * s, max(outer - _STRAP * s, inner + 0.3 * s) + out * s)
        low, turns = middle[1] - below * s, np.linspace(0.0, _TURN, 16)
        top = view.column(sign * begins)
        if top is None:
            continue
        rise = (top[1] - _UPPER * s - low) / (1.0 - np.cos(_TURN))
        across = _MIDDLE + (begins - _MIDDLE) * np.sin(turns) / np.sin(_TURN)
        heights = low + rise * (1.0 - np.cos(turns))
        line = [(sign * float(x), float(y)) for x, y in zip(across, heights, strict=True)]
        held = [point for point in line if view.holds([point])]
        if len(held) >= 4 and abs(held[-1][0]) >= _SHORTEST * s:
            pieces += chalk.line(name, view.panel.name, held, _LINE)
    return pieces
