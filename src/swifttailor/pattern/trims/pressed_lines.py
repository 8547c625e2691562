"""What is pressed into cloth and seen as lines: creases of trousers, the edges of pleats."""

from __future__ import annotations

import numpy as np

from swifttailor.pattern.trims.chalk import Chalk
from swifttailor.pattern.trims.shapes import Trim

_FRONTS, _LEGS = ("pant_f_l", "pant_f_r"), ("pant_f_l", "pant_b_l", "pant_f_r", "pant_b_r")
_CREASE = 0.11
"""Half the width of a crease as it is drawn, cm."""
_BELOW_WAIST, _OF_SEAT = 5.0, 0.36
"""Creases begin so far below the waist in front, cm, and behind below the seat: at a part of the height."""
_PLEATS = (0.24, 0.5, 0.76)
"""Where pleats lie in each front, as parts of its width."""


def creases(chalk: Chalk, name: str) -> list[Trim]:
    """A pressed line down the middle of each leg, in front from the waist and behind from below the seat."""
    return _down_the_legs(chalk, name, _LEGS, (0.5,))


def pleat_lines(chalk: Chalk, name: str) -> list[Trim]:
    """The pressed edges of three pleats in each front of wide trousers."""
    return _down_the_legs(chalk, name, _FRONTS, _PLEATS)


def _down_the_legs(chalk: Chalk, name: str, panels: tuple[str, ...], places: tuple[float, ...]) -> list[Trim]:
    pieces: list[Trim] = []
    for panel in panels:
        view = chalk.views.get(panel)
        if view is None:
            return []
        height = view.high - view.low
        top = view.high - (_BELOW_WAIST * chalk.size if panel in _FRONTS else _OF_SEAT * height)
        heights = np.linspace(view.low + 1.5, top, 12)
        # Above the crotch the middle of a panel is not that of the leg: the line runs on straight.
        legs = [(float(y), view.span(float(y))) for y in heights if y < view.high - 0.42 * height]
        known = [(y, span) for y, span in legs if span is not None]
        if len(known) < 2:
            return []
        for place in places:
            xs = [low + place * (high - low) for _, (low, high) in known]
            slope, start = np.polyfit([y for y, _ in known], xs, 1)
            found = chalk.line(name, panel, [(float(slope * y + start), float(y)) for y in heights], _CREASE)
            if not found and place == places[len(places) // 2]:
                return []
            pieces += found
    return pieces
