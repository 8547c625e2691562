"""Bands of reflecting tape around body, sleeves and legs, as working clothes have them."""

from __future__ import annotations

import numpy as np

from swifttailor.pattern.trims.chalk import Chalk
from swifttailor.pattern.trims.front_view import FrontView
from swifttailor.pattern.trims.shapes import Trim

_WIDE = 5.0
"""Of each band, cm."""
_ABOVE_HEM, _APART = 7.0, 9.0
"""How far the lower band of a torso lies above its hem, and the upper band above the lower one, cm."""
_BELOW_KNEE: tuple[float, float] = (0.42, 0.24)
"""Where the lower edges of both bands of a leg lie, as parts of the way from its end to the crotch."""
_TORSO = ("left_ftorso", "right_ftorso", "left_btorso", "right_btorso")
_LEGS = ("pant_f_l", "pant_f_r", "pant_b_l", "pant_b_r")
_BELOW_ARMHOLE = 2.0
"""Bands of a torso stay so far below its underarm, cm."""
_ROWS, _ACROSS = 11, 24
"""Of the places at which a band is looked at, whether it lies on its panel."""


def reflecting_bands(chalk: Chalk, name: str) -> list[Trim]:
    """Two around the body, or around each leg of trousers."""
    return _around(chalk, name, _TORSO) or _around(chalk, name, _LEGS)  # bibs go around no torso


def _around(chalk: Chalk, name: str, panels: tuple[str, ...]) -> list[Trim]:
    views = [chalk.views.get(panel) for panel in panels]
    if any(view is None for view in views):
        return []
    pieces: list[Trim] = []
    # One height for all panels, or the bands would not meet at the seams.
    low = max(view.low for view in views if view is not None)
    heights = _on_torso(chalk, low) if panels == _TORSO else _on_legs(chalk, low)
    for view in views:
        for height in heights:
            found = [] if view is None else _band(chalk, name, view, height)
            if not found:
                return []
            pieces += found
    return pieces


def _on_torso(chalk: Chalk, low: float) -> list[float]:
    """Lower edges of the bands, cm above the floor."""
    view, s = chalk.views[_TORSO[0]], chalk.size
    outer = view.outline[:, 0] > view.outline[:, 0].max() - 0.5
    highest = float(view.outline[outer, 1].max()) - (_WIDE + _BELOW_ARMHOLE) * s
    low += _ABOVE_HEM * s
    return [y for y in (low, low + (_WIDE + _APART) * s) if y <= highest]


def _on_legs(chalk: Chalk, low: float) -> list[float]:
    reach = chalk.crotch - low
    return [low + share * reach for share in _BELOW_KNEE if reach > 6 * _WIDE * chalk.size]


def _band(chalk: Chalk, name: str, view: FrontView, low: float) -> list[Trim]:
    """Across one panel, from seam to seam."""
    heights = np.linspace(low, low + _WIDE * chalk.size, _ROWS)
    spans = [view.span(float(y)) for y in heights]
    if any(span is None for span in spans):
        return []
    sides = [
        [(span[side] + inward * 0.05, float(y)) for span, y in zip(spans, heights, strict=True) if span]
        for side, inward in ((0, 1), (1, -1))
    ]
    ends = np.array(sides)
    shares = np.linspace(0.0, 1.0, _ACROSS)[:, None, None]
    if not view.bridges(((1.0 - shares) * ends[0] + shares * ends[1]).reshape(-1, 2)):
        return []
    return chalk.ruled(name, view.panel.name, sides[0], sides[1], to_the_edge=True)
