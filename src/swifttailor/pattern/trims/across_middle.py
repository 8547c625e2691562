"""Pockets that lie across the middle: one in front, three in a row on the lower back."""

from __future__ import annotations

from collections.abc import Sequence

from swifttailor.pattern.trims.chalk import Chalk
from swifttailor.pattern.trims.shapes import Trim

_WIDE, _HIGH = 13.0, 17.0
"""Half the width of the one in front, and its height, cm."""
_BACK, _BACK_HIGH, _ABOVE_HEM = 14.5, 14.0, 2.5
"""The same of those behind, and how far they lie above the hem, cm."""
_LEAST = 9.0
"""Lower ones hold nothing, cm."""


def front_pocket(chalk: Chalk, name: str) -> list[Trim]:
    """In the middle below the waist, of a top, an apron or a skirt."""
    s = chalk.size
    skirt = chalk.views.get("skirt_front")
    if skirt is not None:
        column, top = skirt.column(0.0), min(skirt.high, chalk.waist) - 7 * s
        if column is None or top - column[0] < (_LEAST + 3) * s or not chalk.is_even(skirt, top):
            return []
        height = min(_HIGH * s, top - column[0] - 3)
        return chalk.pocket(name, "skirt_front", (0.0, top), 2 * _WIDE * s, height)
    torso = chalk.views.get("left_ftorso")
    column = None if torso is None else torso.column(1.0)
    if column is None:
        return []
    top = min(max(chalk.waist - 2 * s, column[0] + (_HIGH + 3) * s), column[1] - 14 * s)
    height = min(_HIGH * s, top - column[0] - 2.5)
    return [] if height < _LEAST * s else _halves(chalk, name, "ftorso", _WIDE * s, top, height)


def lower_back_pockets(chalk: Chalk, name: str) -> list[Trim]:
    """Three side by side above the hem behind, as cyclists have them."""
    s, torso = chalk.size, chalk.views.get("left_btorso")
    column = None if torso is None else torso.column(1.0)
    span = None if torso is None or column is None else torso.span(column[0] + _ABOVE_HEM + 1)
    if torso is None or column is None or span is None:
        return []
    bottom = column[0] + _ABOVE_HEM
    half = min(_BACK * s, max(abs(span[0]), abs(span[1])) - 2.0)
    top = min(bottom + _BACK_HIGH * s, torso.high - 22 * s)
    if top - bottom < _LEAST * s or half < 9 * s:
        return []
    pieces = _halves(chalk, name, "btorso", half, top, top - bottom)
    for side, sign in (("left", 1), ("right", -1)) if pieces else ():
        x = sign * half / 3
        pieces += chalk.line(name, f"{side}_btorso", [(x, bottom + 0.3), (x, top - 0.3)])
    return pieces


def _halves(
    chalk: Chalk, name: str, part: str, half: float, top: float, height: float, step: float = 2.0
) -> list[Trim]:
    """A pocket whose halves meet in the middle, with the hem of its opening; measures in cm."""
    pieces: list[Trim] = []
    for side, sign in (("left", 1), ("right", -1)):
        panel = f"{side}_{part}"
        if panel not in chalk.views:
            return []
        low, high = (_edge(chalk, part, sign, y) for y in (top - height, top))
        first: Sequence[tuple[float, float]] = [(low, top - height), (sign * half, top - height)]
        found = chalk.ruled(name, panel, first, [(high, top), (sign * half, top)])
        hem = chalk.line(name, panel, [(high + sign * 0.2, top - step), (sign * (half - 0.2), top - step)])
        if not found or not hem:
            return []
        pieces += [*found, *hem]
    return pieces


def _edge(chalk: Chalk, part: str, sign: int, y: float) -> float:
    """The x of a half's edge in the middle at a height, cm; that of a back may be drawn in at the waist."""
    if part == "ftorso":
        return chalk.middle(sign, y)
    span = chalk.views[f"{'left' if sign > 0 else 'right'}_{part}"].span(y)
    return 0.0 if span is None else sign * min(abs(x) for x in span)
