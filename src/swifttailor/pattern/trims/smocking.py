"""The rows of stitches of a bodice that is smocked or shirred."""

from __future__ import annotations

import numpy as np

from swifttailor.pattern.trims.chalk import Chalk
from swifttailor.pattern.trims.front_view import FrontView
from swifttailor.pattern.trims.shapes import Trim

_FRONTS, _BACKS = ("left_ftorso", "right_ftorso"), ("left_btorso", "right_btorso")
_APART, _BESIDE, _INSIDE = 2.0, 0.9, 0.6
"""Distance of rows, and what stays free beside side seams and at both ends of the bodice, cm."""
_STEP, _RISE = 0.9, 0.55
"""How far each stitch goes along the row and up or down from it, cm."""
_LINE = 0.07
"""Half the width of what is drawn of a row, cm."""
_HIGHEST = 24.0
"""How far above the waist rows reach at most, cm: below the neckline and the armholes."""
_FEWEST = 3


def smocking(chalk: Chalk, name: str) -> list[Trim]:
    """Zigzag rows around the bodice, from the waist up to the neckline or to the height of the chest."""
    fronts = [chalk.views[panel] for panel in _FRONTS if panel in chalk.views]
    backs = [chalk.views[panel] for panel in _BACKS if panel in chalk.views]
    if len(fronts) < len(_FRONTS) or not backs:
        return []
    inner = [(view, view.side * (abs(chalk.middle(view.side, view.high)) + _BESIDE)) for view in fronts]
    middle = [column[1] for view, x in inner if (column := view.column(x)) is not None]
    low = max(*[view.low for view in fronts], chalk.waist) + _INSIDE
    top = min([*middle, low + _HIGHEST * chalk.size]) - _INSIDE
    heights = np.arange(low + _RISE, top - _RISE, _APART * chalk.size)
    pieces: list[Trim] = []
    for view in (*fronts, *backs):
        rows = [row for y in heights if (row := _row(chalk, name, view, float(y)))]
        if len(rows) < _FEWEST:
            return []
        pieces += [piece for row in rows for piece in row]
    return pieces


def _row(chalk: Chalk, name: str, view: FrontView, y: float) -> list[Trim]:
    span = view.span(y)
    if span is None:
        return []
    low, high = sorted(span)
    low, high = (low + (0.1 if view.side > 0 else _BESIDE), high - (_BESIDE if view.side > 0 else 0.1))
    count = max(round((high - low) / _STEP), 2)
    xs = np.linspace(low, high, count + 1)
    points = np.array([(x, y + (_RISE if k % 2 else -_RISE)) for k, x in enumerate(xs)])
    held = view.held(points)  # darts, which are sewn shut, part a row
    held[1:-1] &= held[:-2] & held[2:]
    parts = np.split(np.arange(len(points)), np.flatnonzero(np.diff(held.astype(int))) + 1)
    pieces: list[Trim] = []
    for part in parts:
        if held[part[0]]:
            pieces += chalk.line(name, view.panel.name, points[part].tolist(), width=_LINE)
    return pieces
