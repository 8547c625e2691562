"""What closes a garment: buttons and zips, where a tailor would chalk them."""

from __future__ import annotations

import numpy as np

from swifttailor.pattern.trims.chalk import Chalk
from swifttailor.pattern.trims.front_view import edge_at, front_edge
from swifttailor.pattern.trims.shapes import Button, Trim

_BUTTON, _COAT_BUTTON = 0.6, 1.0
"""Radii, cm."""
_SPACING, _COAT_SPACING = 8.5, 11.0
_FROM_NECK, _FROM_HEM = 1.6, 2.5
_BAND = 1.6
"""Half the width of a front band, cm."""
_DOUBLE_AT = 6.5
"""Distance of each of two rows of buttons from the middle, cm."""
_POLO, _HALF_ZIP = 14.0, 24.0
"""How far down they reach from the neck, cm."""
_ZIP = 0.55
"""Half the width of the teeth, cm."""


def buttons(chalk: Chalk, name: str) -> list[Trim]:
    """One row down the middle, with a band under it or without."""
    seam = front_edge(chalk.pattern)
    if seam is None:
        return _buttons_of_skirt(chalk, name)
    right, left, low, high = seam
    coat = name == "buttons"
    spacing, radius = (_COAT_SPACING, _COAT_BUTTON) if coat else (_SPACING, _BUTTON)
    spacing, radius = spacing * chalk.size, radius * chalk.size
    if name == "polo placket":
        low = max(low, high - _POLO * chalk.size)
    pieces: list[Trim] = []
    if not coat:
        for ref, sign in ((right, -1), (left, 1)):
            view = chalk.views[ref.panel]
            top, bottom = high - 0.3, low + 0.3
            inner = edge_at(chalk.pattern, ref, top) + sign * _BAND
            top = chalk.height_within(view, inner, top, bottom)
            heights = np.linspace(bottom, top, max(int((top - bottom) / 2), 2))
            middle = [(edge_at(chalk.pattern, ref, y), y) for y in heights]
            pieces += chalk.ruled(name, ref.panel, middle, [(x + sign * _BAND, y) for x, y in middle])
    low, high = low + _FROM_HEM, high - _FROM_NECK
    count = max(round((high - low) / spacing), 1) + 1
    for y in np.linspace(low, high, count):
        pieces += chalk.button(name, right.panel, (edge_at(chalk.pattern, right, y), float(y)), radius)
    return [*pieces, *(_buttons_of_skirt(chalk, name) if name != "polo placket" else [])]


def _buttons_of_skirt(chalk: Chalk, name: str) -> list[Trim]:
    """Down the middle of a skirt in one piece: shirt dresses, skirts that are buttoned."""
    view = chalk.views.get("skirt_front")
    span = None if view is None else view.span(view.low + 1)
    if view is None or span is None or not span[0] < -2 < 2 < span[1]:
        return []
    middle = view.column(0.0)
    if middle is None:
        return []
    low, high = middle
    heights = np.arange(high - 4, low + 7, -_SPACING * chalk.size)
    ends = np.linspace(low + 0.3, high - 0.3, max(int((high - low) / 2), 2))
    pieces: list[Trim] = []
    for sign in (-1, 1):
        pieces += chalk.ruled(
            name, view.panel.name, [(0.0, y) for y in ends], [(sign * _BAND, y) for y in ends]
        )
    return pieces + [
        each
        for y in heights
        for each in chalk.button(name, view.panel.name, (0.0, float(y)), _BUTTON * chalk.size)
    ]


def double_breasted(chalk: Chalk, name: str) -> list[Trim]:
    """Two rows, and the edge of the front that lies above the other one."""
    seam = front_edge(chalk.pattern)
    if seam is None:
        return []
    right, left, low, high = seam
    at, top = _DOUBLE_AT * chalk.size, high - 2
    heights = np.linspace(low + 0.5, top, 8)
    edge = [(edge_at(chalk.pattern, left, y) + at + 2.5, y) for y in heights]
    pieces = chalk.line(name, left.panel, edge)
    rows = max(round((top - low) / (_COAT_SPACING * chalk.size)), 1)
    for y in np.linspace(low + 3, top - 2, rows + 1):
        for ref, sign in ((right, -1), (left, 1)):
            x = edge_at(chalk.pattern, ref, y) + sign * at
            pieces += chalk.button(name, ref.panel, (x, float(y)), _COAT_BUTTON * chalk.size)
    return pieces if any(isinstance(piece, Button) for piece in pieces) else []


def front_zip(chalk: Chalk, name: str) -> list[Trim]:
    """Down the seam in the middle."""
    seam = front_edge(chalk.pattern)
    if seam is None:
        return []
    right, left, low, high = seam
    if name == "half zip":
        low = max(low, high - _HALF_ZIP * chalk.size)
    heights = np.linspace(low + 0.2, high - 0.4, max(int((high - low) / 2), 2))
    pieces: list[Trim] = []
    for ref, sign in ((right, -1), (left, 1)):
        middle = [(edge_at(chalk.pattern, ref, y), y) for y in heights]
        teeth = [(x + sign * _ZIP, y) for x, y in middle]
        pieces += chalk.ruled(name, ref.panel, middle, teeth, "metal", is_cut=False)
        pieces += chalk.line(name, ref.panel, [(x + sign * 1.6, y) for x, y in middle[:-1]])
    return pieces


def back_zip(chalk: Chalk, name: str) -> list[Trim]:
    """Down the seam in the middle of the back, or from the waist down it."""
    for panel in ("left_btorso", "skirt_back"):
        view = chalk.views.get(panel)
        column = None if view is None else view.column(0.3)
        if view is None or column is None:
            continue
        low = max(column[0] + 0.5, column[1] - (18 if panel == "skirt_back" else 50) * chalk.size)
        heights = np.linspace(low, column[1] - 0.4, 12)
        return chalk.ruled(
            name, panel, [(0.0, y) for y in heights], [(_ZIP, y) for y in heights], "metal", is_cut=False
        )
    return []


def side_zip(chalk: Chalk, name: str) -> list[Trim]:
    """In the left side seam, below the waist."""
    return chalk.beside_side_seam(name, 0.5, 18.0, both=False)


def fly(chalk: Chalk, name: str) -> list[Trim]:
    """The stitches of a fly on the left front, and the button above."""
    view, band = chalk.views.get("pant_f_l"), chalk.views.get("wb_front")
    if view is None or chalk.views.get("pant_f_r") is None:
        return []
    middle = view.span(view.high - 3)
    top = view.high if middle is None else chalk.top_at(view, middle[0] + 1.0)
    if middle is None:
        return []
    x, s = middle[0], chalk.size
    curve = [
        (x + 3.6 * s, top - 0.5),
        (x + 3.6 * s, top - 9 * s),
        (x + 3.2 * s, top - 12 * s),
        (x + 2 * s, top - 14 * s),
    ]
    curve.append((x + 0.6 * s, top - 15 * s))
    pieces = chalk.line(name, "pant_f_l", curve)
    if pieces and band is not None:
        pieces += chalk.button(name, "wb_front", (0.8, (band.low + band.high) / 2), 0.8 * s)
    return pieces
