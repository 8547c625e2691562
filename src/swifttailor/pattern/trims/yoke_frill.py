"""A frill around the yoke: a gathered strip across the chest and the upper back, from armhole to armhole."""

from __future__ import annotations

import numpy as np

from swifttailor.pattern.trims.chalk import Chalk
from swifttailor.pattern.trims.front_view import FrontView
from swifttailor.pattern.trims.shapes import Trim

_BELOW_SHOULDER, _DEPTH = 9.0, 5.0
"""How far below the shoulders it is sewn on, and how deep it is, cm."""
_WAVE, _SWING = 3.0, 0.7
"""Length of its waves, and how far its border swings, cm."""
_BESIDE, _FOLD = 0.8, 0.12
"""How far it stays inside of the armhole, and half the width of the lines that are its folds, cm."""
_NARROWEST = 6.0
_LEVELS = 6
"""In so many rows it is looked at how wide a panel is where the frill hangs."""


def yoke_frill(chalk: Chalk, name: str) -> list[Trim]:
    """Across both fronts and both backs; nothing where the neckline or bare shoulders leave no room."""
    pieces: list[Trim] = []
    for side, sign in (("left", 1.0), ("right", -1.0)):
        for part in ("ftorso", "btorso"):
            view = chalk.views.get(f"{side}_{part}")
            found = [] if view is None else _half(chalk, name, view, sign)
            if not found:
                return []
            pieces += found
    return pieces


def _half(chalk: Chalk, name: str, view: FrontView, sign: float) -> list[Trim]:
    """The strip on one panel, with its folds."""
    s, panel = chalk.size, view.panel.name
    top = chalk.shoulder - _BELOW_SHOULDER * s
    low = top - (_DEPTH + _SWING) * s
    spans = [view.span(float(y)) for y in np.linspace(top, low, _LEVELS)]  # armholes may bulge between
    if any(span is None for span in spans):
        return []
    reach = [sorted((sign * span[0], sign * span[1])) for span in spans if span is not None]
    inner, outer = max(near for near, _ in reach) + 0.05, min(far for _, far in reach) - _BESIDE * s
    if inner > 3.0 * s or outer - inner < _NARROWEST * s:
        return []
    waves = max(round((outer - inner) / (_WAVE * s)), 2)
    shares = np.linspace(0.0, 1.0, 8 * waves + 1)
    across = sign * (inner + shares * (outer - inner))
    border = top - _DEPTH * s + _SWING * s * np.cos(2.0 * np.pi * waves * shares)
    upper = [(float(x), top) for x in across]
    lower = [(float(x), float(y)) for x, y in zip(across, border, strict=True)]
    if not view.holds(np.array([*upper[2:], *lower[2:]])):  # all but what runs on to the middle
        return []
    strip = chalk.ruled(name, panel, lower, upper, to_the_edge=True)
    folds: list[Trim] = []
    for at in range(4, 8 * waves, 8):
        ends = [(upper[at][0], top - 0.3 * s), (lower[at][0], lower[at][1] + 0.5 * s)]
        folds += chalk.line(name, panel, ends, width=_FOLD)
    return [*strip, *folds] if strip else []
