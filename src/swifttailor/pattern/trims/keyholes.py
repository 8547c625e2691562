"""Keyholes: openings shaped like a drop below the neck, in the middle of the front or the back."""

from __future__ import annotations

import numpy as np

from swifttailor.pattern.trims.chalk import Chalk
from swifttailor.pattern.trims.shapes import Trim

_HALVES = (("left", 1), ("right", -1))
_BELOW_NECK, _HEIGHT, _HALF_WIDTH = 1.3, 10.0, 3.2
"""Where it begins below the neck, how high it is, and half its width, cm."""
_BUTTON, _LEAST = 0.55, 0.06
_SHORTEST = 14.0
"""Least height of the seam in the middle, cm."""
_BESIDE = 1.2
"""How far beside the middle a half is looked at, cm."""


def keyhole(chalk: Chalk, name: str) -> list[Trim]:
    """A drop below the neck that shows the wearer, closed above by a button."""
    side = "btorso" if name == "back keyhole" else "ftorso"
    if any("collar" in panel.name or "hood" in panel.name for panel in chalk.pattern.panels):
        return []
    columns = []
    for half, sign in _HALVES:
        view = chalk.views.get(f"{half}_{side}")
        column = None if view is None else view.column(sign * _BESIDE)
        if column is None:
            return []
        columns.append(column)
    low, high = max(column[0] for column in columns), min(column[1] for column in columns)
    s = chalk.size
    if high - low < _SHORTEST * s or high < chalk.shoulder - 22.0 * s:
        return []
    top = high - _BELOW_NECK * s
    shares = np.linspace(0.0, 1.0, 15)
    # Of a drop: narrow above, widest below its middle, round at its lower end.
    wide = np.maximum(2.6 * shares**1.4 * np.sqrt(1.0 - shares) * 0.66, 0.0) * _HALF_WIDTH * s
    heights = top - shares * _HEIGHT * s
    pieces: list[Trim] = []
    for half, sign in _HALVES:
        view = chalk.views[f"{half}_{side}"]
        inner = [_inner(view.span(float(y))) + 0.02 for y in heights]
        first = [(sign * x, float(y)) for x, y in zip(inner, heights, strict=True)]
        second = [
            (sign * (x + max(float(w), _LEAST)), float(y))
            for x, w, y in zip(inner, wide, heights, strict=True)
        ]
        if not view.bridges([*first, *second]):
            return []
        found = chalk.ruled(name, f"{half}_{side}", first, second, "hole", is_cut=False, to_the_edge=True)
        pieces += found
    view = chalk.views[f"left_{side}"]
    at = (_inner(view.span(high - 0.9 * s)) + 0.05, high - 0.9 * s)
    return [*pieces, *chalk.button(name, f"left_{side}", at, _BUTTON * s)]


def _inner(span: tuple[float, float] | None) -> float:
    """How far from the middle of the body a half begins, cm."""
    return 0.0 if span is None or span[0] * span[1] <= 0.0 else min(abs(span[0]), abs(span[1]))
