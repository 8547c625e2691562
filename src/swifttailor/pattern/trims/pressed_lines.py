"""What is pressed into cloth and seen as lines: creases of trousers, the edges of pleats."""

from __future__ import annotations

import numpy as np

from swifttailor.pattern.trims.chalk import Chalk
from swifttailor.pattern.trims.shapes import Trim

_FRONTS, _LEGS = ("pant_f_l", "pant_f_r"), ("pant_f_l", "pant_b_l", "pant_f_r", "pant_b_r")
_CREASE = 0.2
"""Half the width of a crease as it is drawn, cm."""
_FOLD = 0.22
"""Half the width of the edge of a pleat at the waist as it is drawn, cm."""
_BELOW_WAIST, _OF_SEAT = 2.5, 0.34
"""Creases begin so far below the waist in front, cm, and behind below the seat: at a part of the height."""
_PLEATS = (0.24, 0.5, 0.76)
"""Where pleats lie in each front, as parts of its width."""
_AT_WAIST: tuple[tuple[float, float], ...] = ((0.42, 15.0), (0.64, 11.0))
"""Where the two pleats of each front begin at the waist, as parts of its width from the middle of the body
on, and how far down they are seen, cm."""
_BELOW_BAND, _TOWARDS_CREASE = 0.5, 0.06
"""How far below the waist they begin, cm; how far they lean towards the middle of the leg, times length."""


def creases(chalk: Chalk, name: str) -> list[Trim]:
    """A pressed line down the middle of each leg, in front from the waist and behind from below the seat."""
    return _down_the_legs(chalk, name, _LEGS, (0.5,))


def pleat_lines(chalk: Chalk, name: str) -> list[Trim]:
    """The pressed edges of three pleats in each front of wide trousers."""
    return _down_the_legs(chalk, name, _FRONTS, _PLEATS)


def front_pleats(chalk: Chalk, name: str) -> list[Trim]:
    """The folds of two pleats in each front, from the waistband down as far as they are seen."""
    pieces: list[Trim] = []
    for panel in _FRONTS:
        view = chalk.views.get(panel)
        if view is None:
            return []
        top = view.high - _BELOW_BAND * chalk.size
        for part, length in _AT_WAIST:
            # The first inches below the waist tell how wide the front is there; its corners are not square.
            span = view.span(top - chalk.size)
            if span is None:
                return []
            place = part if panel == "pant_f_l" else 1 - part
            x, down = span[0] + place * (span[1] - span[0]), length * chalk.size
            lean = (_TOWARDS_CREASE if panel == "pant_f_r" else -_TOWARDS_CREASE) * down
            ends = [(x, top), (x + lean / 2, top - down / 2), (x + lean, top - down)]
            found = chalk.line(name, panel, ends, _FOLD)
            if not found:
                return []
            pieces += found
    return pieces


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
