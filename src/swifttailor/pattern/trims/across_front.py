"""What lies aslant on a front: a zip from one collarbone to the other hip, a flap against storms."""

from __future__ import annotations

import numpy as np

from swifttailor.arrays import Floats
from swifttailor.pattern.trims.chalk import Chalk
from swifttailor.pattern.trims.shapes import Trim

_ZIP = 0.6
"""Half the width of the teeth, cm."""
_AT_NECK, _AT_HEM = 5.5, 13.0
"""How far from the middle such a zip begins at the neck, and at most how far it ends at the hem, cm."""
_BESIDE_DARTS = 4.5
"""How far it ends there where darts from the hem are in its way, cm."""
_BELOW_NECK, _ABOVE_HEM, _SHORTEST = (1.2, 5.0, 9.0, 13.0, 17.0, 21.0), 1.0, 12.0
_SIDES = (("left", 1), ("right", -1))
_FLAP, _ROUNDED = 17.0, 4.0
"""How far a flap reaches down from the shoulder, and how high its rounded corner is, cm."""
_FROM_EDGE, _FROM_ARMHOLE, _NARROWEST = 2.5, 0.7, 5.0
"""How far it stays away from the edge in the middle and from the armhole, and its least width, cm."""


def asymmetric_zip(chalk: Chalk, name: str) -> list[Trim]:
    """From beside the neck on the wearer's left front down to the hem of the right one."""
    s = chalk.size
    left, right = (chalk.views.get(f"{side}_ftorso") for side, _ in _SIDES)
    begins = None if left is None else left.column(_AT_NECK * s)
    if left is None or right is None or begins is None:
        return []
    span = right.span(right.low + 3.0)
    if span is None:
        return []
    for reach in (min(_AT_HEM * s, 0.6 * abs(span[0])), _BESIDE_DARTS * s):
        hem = right.column(-reach)
        if hem is None:
            continue
        end = np.array([-reach, hem[0] + _ABOVE_HEM])
        for below in _BELOW_NECK:  # on what is cut out deeply it begins lower
            start = np.array([_AT_NECK * s, begins[1] - below * s])
            found = _teeth(chalk, name, start, end) if start[1] - end[1] >= _SHORTEST * s else []
            if found:
                return found
    return []


def _teeth(chalk: Chalk, name: str, start: Floats, end: Floats) -> list[Trim]:
    """From a place on the left front to one on the right front; nothing where one does not hold it."""
    share = float(start[0] / (start[0] - end[0]))
    middle = start + share * (end - start)
    pieces: list[Trim] = []
    for (side, sign), (top, low) in zip(_SIDES, ((start, middle), (middle, end)), strict=True):
        line = [top + t * (low - top) for t in np.linspace(0.0, 1.0, 8)]
        inner = [(max(sign * x, sign * chalk.middle(sign, y) + 0.05) * sign, y) for x, y in line]
        teeth = chalk.ruled(
            name,
            f"{side}_ftorso",
            [(x - _ZIP, y) for x, y in inner],
            [(x + _ZIP, y) for x, y in inner],
            "metal",
            is_cut=False,
        )
        teeth = teeth or _narrowed(chalk, name, f"{side}_ftorso", inner, sign)
        if not teeth:
            return []
        pieces += teeth
    return pieces


def _narrowed(chalk: Chalk, name: str, panel: str, line: list[tuple[float, float]], sign: int) -> list[Trim]:
    """The same strip, cut off where the front ends in the middle."""
    edges = [chalk.middle(sign, y) + sign * 0.05 for _, y in line]
    sides = [
        [
            (sign * max(sign * (x + way * _ZIP), sign * edge), y)
            for (x, y), edge in zip(line, edges, strict=True)
        ]
        for way in (-1, 1)
    ]
    return chalk.ruled(name, panel, sides[0], sides[1], "metal", is_cut=False)


def storm_flap(chalk: Chalk, name: str) -> list[Trim]:
    """A loose piece on the wearer's right front, from the shoulder to the chest."""
    view, s = chalk.views.get("right_ftorso"), chalk.size
    tip = None if view is None else view.span(view.high - 1.0)
    if view is None or tip is None:
        return []
    top = view.high - 1.0
    low = top - _FLAP * s
    rows = []
    for y in np.linspace(low, top, 12):
        span = view.span(float(y))
        if span is None:
            return []
        round_off = max(_ROUNDED * s - (float(y) - low), 0.0)
        corner = _ROUNDED * s - float(np.sqrt(max((_ROUNDED * s) ** 2 - round_off**2, 0.0)))
        edge = min(span[1], chalk.middle(-1, float(y))) - _FROM_EDGE * s - corner
        rows.append(((span[0] + _FROM_ARMHOLE, float(y)), (min(edge, span[1] - 0.3), float(y))))
    wide = [row for row in rows if row[1][0] - row[0][0] > 0.5]
    if len(wide) < 4 or max(row[1][0] - row[0][0] for row in wide) < _NARROWEST * s:
        return []
    return chalk.ruled(name, view.panel.name, [row[0] for row in wide], [row[1] for row in wide])
