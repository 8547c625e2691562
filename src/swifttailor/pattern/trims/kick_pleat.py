"""The pleat above the hem of a narrow skirt behind, which opens in a stride."""

from __future__ import annotations

from swifttailor.pattern.trims.chalk import Chalk, Point
from swifttailor.pattern.trims.shapes import Trim

_HEIGHT, _OF_SKIRT = 20.0, 0.4
"""How far above the hem it begins, cm, and at most as a part of the skirt."""
_TOP, _HEM, _INSIDE = 0.14, 1.1, 0.4
"""Half its width at both ends as it stands a little open, and how far inside the hem it ends, cm."""
_STITCHES = (3.6, 2.4)
"""How far aside and down the stitches run that hold it at its upper end, cm."""
_SHORTEST, _ROWS = 24.0, 9
"""Shorter skirts have none, cm."""


def kick_pleat(chalk: Chalk, name: str) -> list[Trim]:
    """Both folds, between which the cloth behind them is seen, and the stitches above."""
    view, s = chalk.views.get("skirt_back"), chalk.size
    if view is None or view.high - view.low < _SHORTEST * s:
        return []
    column = view.column(0.0)
    if column is None:
        return []
    low = column[0] + _INSIDE
    high = low + min(_HEIGHT * s, _OF_SKIRT * (view.high - view.low))
    rows = [(k / (_ROWS - 1), high + k / (_ROWS - 1) * (low - high)) for k in range(_ROWS)]
    left, right = (
        [(sign * s * (_TOP + down * (_HEM - _TOP)), y) for down, y in rows] for sign in (-1.0, 1.0)
    )
    pieces = chalk.ruled(name, "skirt_back", left, right, "dark", is_cut=False)
    for sign in (-1.0, 1.0):
        ends: list[Point] = [(0.0, high), (sign * _STITCHES[0] * s, high - _STITCHES[1] * s)]
        stitches = chalk.line(name, "skirt_back", ends, 0.16)
        pieces = [*pieces, *stitches] if pieces and stitches else []
    return pieces
