"""The blouse that is seen above the bodice of a dirndl: white cloth between neck and bodice."""

from __future__ import annotations

import numpy as np

from swifttailor.pattern.trims.chalk import Chalk
from swifttailor.pattern.trims.front_view import FrontView
from swifttailor.pattern.trims.shapes import Trim

BLOUSE, BLOUSE_DEPTH = "blouse front", 10.0
"""The name of the trim, and how far below the middle of the neck the bodice begins, cm."""
_STRAP, _INSIDE = 4.5, 0.05
"""How wide the straps of the bodice are, and how near pieces come to edges, cm."""
_SHARES = (1.0, 0.92, 0.84, 0.76, 0.68, 0.6)
"""Widths that are tried, as parts of the widest."""
_LEAST, _ROWS = 6.0, 12
"""Half the width of what is seen between the straps at least, cm."""


def blouse_front(chalk: Chalk, name: str) -> list[Trim]:
    """Between the straps from the neck down to a square edge, in front; nothing without shoulders."""
    s, pieces = chalk.size, []
    for side, sign in (("left", 1), ("right", -1)):
        view = chalk.views.get(f"{side}_ftorso")
        neck = None if view is None else view.column(sign * 0.4)
        if view is None or neck is None or view.high < chalk.shoulder - s:
            return []
        low = neck[1] - BLOUSE_DEPTH * s
        shoulder = view.span(view.high - 0.5)
        if shoulder is None or low - view.low < 12.0 * s:
            return []
        outer = max(abs(shoulder[0]), abs(shoulder[1]), 8.0 * s) + 3.0 * s
        across = view.span(low)
        if across is None:
            return []
        reach = max(abs(across[0]), abs(across[1])) - _STRAP * s
        half = min(outer, reach)
        if half < _LEAST * s:
            return []
        tried = ((share * half, _piece(chalk, name, view, sign, (low, share * half))) for share in _SHARES)
        half, found = next(((wide, piece) for wide, piece in tried if piece), (0.0, []))
        if not found:
            return []
        xs = np.linspace(0.6, half, _ROWS)
        line = chalk.line(name, view.panel.name, [(sign * float(x), low - 0.1) for x in xs])
        pieces += [*found, *line]
    return pieces


def _piece(chalk: Chalk, name: str, view: FrontView, sign: int, corner: tuple[float, float]) -> list[Trim]:
    """One half of it, down to a height and as far from the middle as its lower corner, cm."""
    low, half = corner
    xs = np.linspace(_INSIDE, half, _ROWS)
    tops = [column[1] - 0.3 for x in xs if (column := view.column(sign * float(x))) is not None]
    if len(tops) < len(xs) or min(tops) < low + 1.0:
        return []
    first = [(sign * float(x), low) for x in xs]
    second = [(sign * float(x), y) for x, y in zip(xs, tops, strict=True)]
    first[0], second[0] = ((chalk.middle(sign, y) + sign * _INSIDE, y) for y in (low, tops[0]))
    border = [*first, *second[::-1]]
    if not view.carries(border) or not all(view.on_cloth(border)):
        return []
    return chalk.ruled(name, view.panel.name, first, second, to_the_edge=True)
