"""The seams of cups: an arc below each breast, and one from its middle to the upper edge."""

from __future__ import annotations

import numpy as np
import shapely

from swifttailor.pattern.drafts.figure import Figure
from swifttailor.pattern.drafts.measurements import DraftMeasurements
from swifttailor.pattern.trims.chalk import Chalk, Point
from swifttailor.pattern.trims.front_view import over_darts
from swifttailor.pattern.trims.shapes import Patch, Trim

_BELOW_BUST, _RISE = 6.0, 3.5
"""How far below the fullest part of the bust a cup ends, and how much higher it does at its ends, cm."""
_BESIDE_MIDDLE, _BESIDE_SIDE = 0.8, 1.0
"""How far a cup stays from the middle of the front and from the side, cm."""
_SEAM = 0.15
"""Half the width of a seam as it is drawn, cm."""
_NARROWEST, _SHORTEST = 3.0, 2.0
"""Smaller cups are none, cm."""
_HIGHEST = 9.0
"""A cup ends so far above the fullest part of the bust at most, cm."""


def cups(chalk: Chalk, name: str) -> list[Trim]:
    """On both halves of the front; nothing where it has no room for them."""
    figure, s = Figure.of(DraftMeasurements()), chalk.size
    bust = s * figure.bust_y
    pieces: list[Trim] = []
    for side, sign in (("left", 1), ("right", -1)):
        view = chalk.views.get(f"{side}_ftorso")
        span = None if view is None else view.span(bust)
        if view is None or span is None or view.low > bust - _BELOW_BUST * s:
            return []
        inner, outer = sorted((sign * span[0], sign * span[1]))
        inner, outer = inner + _BESIDE_MIDDLE * s, outer - _BESIDE_SIDE * s
        middle = (inner + outer) / 2
        across = np.linspace(-1.0, 1.0, 24)
        arc: list[Point] = [
            (sign * (middle + t * (outer - inner) / 2), bust - _BELOW_BUST * s + _RISE * s * t**2)
            for t in across.tolist()
        ]
        top = min(chalk.top_at(view, sign * middle) - 0.7, bust + _HIGHEST * s)
        up: list[Point] = [
            (sign * middle, y) for y in np.linspace(bust - (_BELOW_BUST - 0.3) * s, top, 10).tolist()
        ]
        if outer - inner < _NARROWEST * s or up[-1][1] - up[0][1] < _SHORTEST * s:
            return []
        for line in (arc, up):
            found = chalk.line(name, view.panel.name, over_darts(view, line), _SEAM)
            # Darts that meet below a cup would fold its seam over itself.
            seams = [piece for piece in found if isinstance(piece, Patch)]
            if not seams or not all(shapely.Polygon(seam.outline).is_valid for seam in seams):
                return []
            pieces += found
    return pieces
