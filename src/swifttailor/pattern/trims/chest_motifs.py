"""Figures in the middle of the chest: a heart, a star."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from swifttailor.pattern.trims.chalk import Chalk
from swifttailor.pattern.trims.shapes import Trim

_HIGH, _LEAST = 17.0, 9.0
"""Height of a figure, and of the smallest, cm."""
_BELOW_NECK, _WIDEST = 4.5, 0.85
"""How far below the neck it begins, cm, and how much of the chest it may take."""
_POINTS = 17
_INNER = 0.45
"""Radius of the inner corners of a star, as a part of that of its points."""
_Line = Sequence[tuple[float, float]]


def chest_heart(chalk: Chalk, name: str) -> list[Trim]:
    """A heart below the neck, half of it on each front."""
    turn = np.linspace(0.0, np.pi, _POINTS)
    across = 16.0 * np.sin(turn) ** 3
    up = 13.0 * np.cos(turn) - 5.0 * np.cos(2 * turn) - 2.0 * np.cos(3 * turn) - np.cos(4 * turn)
    middle = np.linspace(up[0], up[-1], _POINTS)
    return _figure(chalk, name, np.column_stack([across, up]), middle)


def chest_star(chalk: Chalk, name: str) -> list[Trim]:
    """A star of five points below the neck, half of it on each front."""
    angle = np.radians([90.0, 54.0, 18.0, -18.0, -54.0, -90.0])
    radius = np.array([1.0, _INNER] * 3)
    corners = radius[:, None] * np.column_stack([np.cos(angle), np.sin(angle)])
    corners[[0, -1], 0] = 0.0
    return _figure(chalk, name, corners, np.array([1.0, 0.45, 0.2, 0.0, -0.2, -_INNER]))


def _figure(chalk: Chalk, name: str, half: np.ndarray, middle: np.ndarray) -> list[Trim]:
    """Both halves of a figure, the right one mirrored.

    Args:
        chalk: Of the pattern.
        name: Of the trim.
        half: (n, 2) outline from above to below, in any unit.
        middle: (n,) heights on the line down its middle, each joined to a point of the outline.
    """
    torso, s = chalk.views.get("left_ftorso"), chalk.size
    column = None if torso is None else torso.column(1.0)
    if torso is None or column is None:
        return []
    top = column[1] - _BELOW_NECK * s
    high, low = half[:, 1].max(), half[:, 1].min()
    span = torso.span(top - 0.4 * _HIGH * s)
    if span is None:
        return []
    room = _WIDEST * max(abs(span[0]), abs(span[1]))
    unit = min(_HIGH * s / (high - low), room / half[:, 0].max(), (top - column[0] - 3.0 * s) / (high - low))
    if unit * (high - low) < _LEAST * s:
        return []
    pieces: list[Trim] = []
    for side, sign in (("left", 1), ("right", -1)):
        if f"{side}_ftorso" not in chalk.views:
            return []
        heights = [float(top + unit * (y - high)) for y in middle]
        first: _Line = [(chalk.middle(sign, y), y) for y in heights]
        second: list[tuple[float, float]] = [
            (sign * float(unit * x), float(top + unit * (y - high))) for x, y in half
        ]
        for end in (0, -1):
            second[end] = first[end]
        found = chalk.ruled(name, f"{side}_ftorso", first, second)
        if not found:
            return []
        pieces += found
    return pieces
