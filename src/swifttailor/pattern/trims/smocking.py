"""Smocking and shirring: rows of stitches around a bodice that draw its cloth together."""

from __future__ import annotations

import numpy as np

from swifttailor.pattern.trims.chalk import Chalk, Point
from swifttailor.pattern.trims.front_view import FrontView, over_darts
from swifttailor.pattern.trims.shapes import Trim

_SIDES = (("left", 1.0), ("right", -1.0))
_APART, _BESIDE, _ABOVE = 1.7, 0.9, 1.2
"""Distance of the rows, and how far they stay from sides and from upper and lower edges, cm."""
_WAVE, _SWING, _STITCH = 0.9, 0.22, 0.09
"""Half the length of the zigzag of a row, how far it swings, and half the width of what is drawn, cm."""
_FEWEST, _NARROWEST = 4, 5.0
_BELOW_WAIST = 1.0
"""Tops that hang lower are smocked down to here below the waist, cm."""
_IN_MIDDLE = 0.15


def smocking(chalk: Chalk, name: str) -> list[Trim]:
    """Rows from the neckline down to the waist; nothing where there is no room for a few."""
    fronts = [chalk.views.get(f"{side}_ftorso") for side, _ in _SIDES]
    backs = [chalk.views.get(f"{side}_btorso") for side, _ in _SIDES]
    if any(view is None for view in (*fronts, *backs)):
        return []
    s = chalk.size
    neck = [column[1] for view in fronts if view is not None and (column := _middle(view)) is not None]
    low = max(view.low for view in (*fronts, *backs) if view is not None)
    low = max(low + _ABOVE * s, chalk.waist - _BELOW_WAIST * s)
    top = min(neck, default=low) - _ABOVE * s
    count = int((top - low) / (_APART * s)) + 1
    if count < _FEWEST:
        return []
    pieces: list[Trim] = []
    for y in low + _APART * s * np.arange(count):
        for part in ("ftorso", "btorso"):
            row = [_row(chalk, name, f"{side}_{part}", sign, float(y)) for side, sign in _SIDES]
            if all(row):
                pieces += [piece for half in row for piece in half]
    return pieces if len(pieces) >= 4 * _FEWEST else []


def _middle(view: FrontView) -> tuple[float, float] | None:
    """Lowest and greatest height beside the middle of the body."""
    x = float(view.outline[np.abs(view.outline[:, 0]).argmin(), 0])
    return view.column(x + np.sign(view.outline[:, 0].mean()) * 0.5)


def _row(chalk: Chalk, name: str, panel: str, sign: float, y: float) -> list[Trim]:
    """A zigzag from the middle of the body to the side seam or the armhole."""
    view, s = chalk.views[panel], chalk.size
    span = view.span(y)
    if span is None:
        return []
    inner, outer = sorted((sign * span[0], sign * span[1]))
    inner, outer = inner + _IN_MIDDLE, outer - _BESIDE * s
    if outer - inner < _NARROWEST * s:
        return []
    count = max(round((outer - inner) / (_WAVE * s)), 4)
    line: list[Point] = [
        (sign * (inner + (outer - inner) * k / count), y + _SWING * s * (-1) ** k) for k in range(count + 1)
    ]
    return chalk.line(name, panel, over_darts(view, line), _STITCH * s)
