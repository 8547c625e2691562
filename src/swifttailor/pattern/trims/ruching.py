"""The folds of cloth that is gathered along its side seams."""

from __future__ import annotations

import numpy as np

from swifttailor.pattern.trims.chalk import Chalk
from swifttailor.pattern.trims.front_view import FrontView
from swifttailor.pattern.trims.shapes import Trim

_PANELS = ("left_ftorso", "right_ftorso", "left_btorso", "right_btorso", "skirt_front", "skirt_back")
_APART, _BESIDE, _INSIDE = 2.6, 0.7, 2.0
"""Distance of folds, and what stays free beside the seam and at both ends of it, cm."""
_LONG = (10.0, 6.5, 12.0, 7.5, 9.0, 5.5)
"""How far folds run from the seam, one after the other, cm."""
_FALL, _LINE = 0.22, 0.12
"""By how much folds fall on their way, as a part of it, and half the width of what is drawn of one, cm."""
_UNDERARM = 0.75
"""Below this part of the way from the waist to the shoulder a torso has side seams."""
_FEWEST = 3


def ruching(chalk: Chalk, name: str) -> list[Trim]:
    """Short folds from the side seams of bodices and close skirts inward, all the way down."""
    pieces: list[Trim] = []
    for view in [chalk.views[panel] for panel in _PANELS if panel in chalk.views]:
        sides = (1, -1) if view.panel.name.startswith("skirt") else (view.side,)
        for sign in sides:
            found = _beside(chalk, name, view, sign)
            if len(found) < _FEWEST:
                return []
            pieces += found
    return pieces


def _beside(chalk: Chalk, name: str, view: FrontView, sign: int) -> list[Trim]:
    """Folds along one side seam."""
    top = min(view.high, chalk.waist + _UNDERARM * (chalk.shoulder - chalk.waist)) - _INSIDE
    pieces: list[Trim] = []
    for k, y in enumerate(np.arange(top, view.low + _INSIDE, -_APART * chalk.size)):
        outer = chalk.outer(view, float(y), sign)
        if outer is None or outer * sign <= 0:
            continue
        along = np.linspace(0.0, min(_LONG[k % len(_LONG)] * chalk.size, 0.8 * abs(outer)), 5)
        # A fold falls most near the seam and runs out level.
        fall = _FALL * along * (1.4 - along / (2.0 * max(float(along[-1]), 0.1)))
        line = [(outer - sign * (_BESIDE + a), float(y) - d) for a, d in zip(along, fall, strict=True)]
        pieces += chalk.line(name, view.panel.name, line, width=_LINE)
    return pieces
