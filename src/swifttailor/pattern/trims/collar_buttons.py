"""Small buttons that hold the points of a shirt collar down: button-down collars."""

from __future__ import annotations

import numpy as np

from swifttailor.pattern.trims.chalk import Chalk
from swifttailor.pattern.trims.front_view import is_closed_to_the_neck
from swifttailor.pattern.trims.shapes import Trim

_ABOVE_POINT, _INSIDE, _RADIUS = 1.5, 0.9, 0.42
"""How far above the point a button is, how far inside the front edge, and its radius, cm."""


def collar_buttons(chalk: Chalk, name: str) -> list[Trim]:
    """One at each point of what is turned down."""
    if not is_closed_to_the_neck(chalk.pattern):  # lapels
        return []
    pieces: list[Trim] = []
    for side, sign in (("left", 1.0), ("right", -1.0)):
        view = chalk.views.get(f"{side}_collar_fall_front")
        if view is None:
            return []
        x, y = view.outline[int(np.argmin(view.outline[:, 1]))]
        at = (float(x) + sign * _INSIDE, float(y) + _ABOVE_POINT)
        pieces += chalk.button(name, view.panel.name, at, _RADIUS * chalk.size)
    return pieces if len(pieces) == 2 else []
