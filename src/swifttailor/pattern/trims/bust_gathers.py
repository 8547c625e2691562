"""A seam below the bust with gathers under it: tops with room for a belly."""

from __future__ import annotations

import numpy as np

from swifttailor.pattern.trims.chalk import Chalk
from swifttailor.pattern.trims.shapes import Trim

_AT = 0.36
"""Where the seam lies, as a part of the way from the waist to the tips of the shoulders."""
_SEAM, _FOLD = 0.17, 0.13
"""Half the width of the seam and of a fold as they are drawn, cm."""
_APART, _LONG, _INSIDE = 2.1, (11.0, 6.5, 8.5, 5.0), 0.8
"""How far apart the folds are, how long each is in turn, and how far they stay from the sides, cm."""
_BELOW = 20.0
"""So much of the garment hangs below the seam at least, cm."""


def bust_gathers(chalk: Chalk, name: str) -> list[Trim]:
    """Across the front, whose cloth is gathered into the seam; the seam alone behind."""
    s, pieces = chalk.size, []
    y = chalk.waist + _AT * (chalk.shoulder - chalk.waist)
    for part in ("ftorso", "btorso"):
        for side, sign in (("left", 1.0), ("right", -1.0)):
            view = chalk.views.get(f"{side}_{part}")
            span = None if view is None else view.span(y)
            if view is None or span is None or y - view.low < _BELOW * s or view.high < chalk.shoulder - s:
                return []
            inner, outer = sorted((sign * span[0], sign * span[1]))
            ends = np.linspace(inner + 0.1, outer - 0.5, 10)
            seam = chalk.line(name, view.panel.name, [(sign * float(x), y) for x in ends], _SEAM)
            if not seam:
                return []
            pieces += seam
            for k, x in enumerate(np.arange(inner + _INSIDE, outer - _INSIDE, _APART * s)):
                fold = [(sign * float(x), y - 0.3), (sign * float(x) * 1.02, y - _LONG[k % len(_LONG)] * s)]
                pieces += chalk.line(name, view.panel.name, fold, _FOLD) if part == "ftorso" else []
    return pieces
