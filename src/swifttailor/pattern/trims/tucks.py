"""Tucks: narrow folds that are sewn down beside the middle of the front, as of evening shirts."""

from __future__ import annotations

import numpy as np

from swifttailor.pattern.trims.chalk import Chalk
from swifttailor.pattern.trims.shapes import Trim

_HALVES = (("left", 1), ("right", -1))
_BESIDE, _APART, _COUNT = 2.8, 1.4, 4
"""How far from the middle the first lies, how far from one to the next, cm, and how many there are."""
_INSIDE, _ABOVE_WAIST, _LONGEST, _LINE = 1.2, 2.0, 34.0, 0.12
"""What stays free above and below, how far above the waist they end, how long they are at most, and half
the width of what is drawn of one, cm."""
_SHORTEST = 8.0
_FEWEST = 2


def tucks(chalk: Chalk, name: str) -> list[Trim]:
    """The edges of the folds on both sides of the middle, from below the neck to above the waist."""
    pieces: list[Trim] = []
    s = chalk.size
    for half, sign in _HALVES:
        view = chalk.views.get(f"{half}_ftorso")
        if view is None:
            return []
        found: list[Trim] = []
        for number in range(_COUNT):
            x = sign * (_BESIDE + number * _APART) * s
            column = view.column(x)
            if column is None:
                continue
            top = column[1] - _INSIDE * s
            low = max(column[0] + _INSIDE * s, chalk.waist + _ABOVE_WAIST * s, top - _LONGEST * s)
            if top - low >= _SHORTEST * s:
                heights = np.linspace(low, top, 8)
                found += chalk.line(name, f"{half}_ftorso", [(x, float(y)) for y in heights], _LINE)
        if len(found) < _FEWEST:
            return []
        pieces += found
    return pieces
