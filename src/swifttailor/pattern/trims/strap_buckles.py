"""The buckles of dungarees, where their straps meet the bib, and the buttons at their hips."""

from __future__ import annotations

from swifttailor.pattern.trims.chalk import Chalk
from swifttailor.pattern.trims.shapes import Trim

_HIGH, _HALF, _BORDER = 3.6, 1.7, 0.75
"""Height of a buckle, half its width at most, and how wide its frame is, cm."""
_BELOW, _BUTTON = 1.8, 0.9
"""How far below the edge of the bib its button lies, and the radius of that, cm."""
_HIP_BUTTONS, _HIP_BUTTON, _FROM_SEAM = (2.5, 6.5, 10.5), 0.7, 1.6
"""How far below the waistband those at the hips lie, their radius, and how far from the side seam, cm."""


def strap_buckles(chalk: Chalk, name: str) -> list[Trim]:
    """A frame of metal at the foot of each strap with a button below it; nothing without straps on a bib."""
    s, pieces = chalk.size, []
    if "wb_front" not in chalk.views:
        return []
    for side, sign in (("left", 1), ("right", -1)):
        view = chalk.views.get(f"{side}_ftorso")
        bib = None if view is None else view.column(sign * 1.0)
        strap = None if view is None or bib is None else view.span(bib[1] + 0.6 * _HIGH * s)
        if view is None or bib is None or strap is None or view.high < bib[1] + 2 * _HIGH * s:
            return []
        x, wide = (strap[0] + strap[1]) / 2, (strap[1] - strap[0]) / 2 - 0.45
        if not 0.7 * s < wide < 4.5 * s:
            return []
        half, low = min(wide, _HALF * s), bib[1] - 0.5 * s
        found = _frame(chalk, name, view.panel.name, (x, low), half, _HIGH * s)
        button = chalk.button(name, view.panel.name, (x, low - _BELOW * s), _BUTTON * s)
        if not found or not button:
            return []
        pieces += [*found, *button, *_at_hip(chalk, name, side, sign)]
    return pieces


def _frame(
    chalk: Chalk, name: str, panel: str, at: tuple[float, float], half: float, high: float
) -> list[Trim]:
    """A rectangle of metal that is open in the middle, its lower edge at a place, cm."""
    (x, y), wide = at, _BORDER * chalk.size
    bars = (
        (x - half, x + half, y, y + wide),
        (x - half, x + half, y + high - wide, y + high),
        (x - half, x - half + wide, y + wide, y + high - wide),
        (x + half - wide, x + half, y + wide, y + high - wide),
    )
    pieces: list[Trim] = []
    for left, right, low, top in bars:
        found = chalk.ruled(
            name, panel, [(left, low), (right, low)], [(left, top), (right, top)], "metal", is_cut=False
        )
        if not found:
            return []
        pieces += found
    return pieces


def _at_hip(chalk: Chalk, name: str, side: str, sign: int) -> list[Trim]:
    """The buttons of the opening in one side seam of dungarees; none on skirts."""
    view = chalk.views.get(f"pant_f_{side[0]}")
    if view is None:
        return []
    found = []
    for below in _HIP_BUTTONS:
        y = view.high - below * chalk.size
        outer = chalk.outer(view, y, sign)
        if outer is None:
            return []
        found.append(
            chalk.button(
                name, view.panel.name, (outer - sign * _FROM_SEAM * chalk.size, y), _HIP_BUTTON * chalk.size
            )
        )
    return [button for one in found for button in one] if all(found) else []
