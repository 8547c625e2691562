"""Lines of quilting across torso and sleeves, where a tailor would chalk them."""

from __future__ import annotations

import re

import numpy as np

from swifttailor.arrays import Floats
from swifttailor.pattern.panel import Panel
from swifttailor.pattern.pattern import Pattern
from swifttailor.pattern.trims.chalk import Chalk
from swifttailor.pattern.trims.shapes import Patch, Trim

APART = 8.5
"""Distance of the lines, cm."""
_HALF, _INSIDE = 0.14, 0.6
"""Half their width, and what stays free beside the outline, cm."""
_SHORTEST = 3.0
"""Shorter lines are left out, cm."""
_QUILTED = re.compile(r"(left|right)_(ftorso|btorso|sleeve_[fb])|skirt_(front|back)")


QUILTING = "quilting"
"""Its name among trims."""


def lines_apart(pattern: Pattern) -> float:
    """Distance of the lines on a garment, cm: as for its wearer."""
    return APART * Chalk(pattern).size


def heights_of_lines(panel: Panel, points: Floats) -> Floats | None:
    """(n,) heights of points (n, 2) above the lower end of a quilted panel, from where lines are counted.

    None of a panel that has no such lines.
    """
    if _QUILTED.fullmatch(panel.name) is None:
        return None
    outline = panel.outline(0.1)
    axis = _along(panel, outline)
    return points @ axis - float((outline @ axis).min())


def quilted(chalk: Chalk, name: str) -> list[Trim]:
    """Lines around the body and the arms."""
    pieces: list[Trim] = []
    for panel in chalk.pattern.panels:
        if _QUILTED.fullmatch(panel.name) is None:
            continue
        outline = panel.outline(0.1)
        axis = _along(panel, outline)
        across = np.array([-axis[1], axis[0]])
        high = outline @ axis
        # From below, as prints are: so the cushions that are drawn between lie (`garment.cloth_print`).
        step = APART * chalk.size
        for at in np.arange(high.min() + step, high.max() - _SHORTEST, step):
            for begins, ends in _clear(outline, axis, across, float(at)):
                if ends - begins < _SHORTEST:
                    continue
                places = np.linspace(begins + _INSIDE, ends - _INSIDE, 8)[:, None] * across
                sides = [places + (at + side * _HALF) * axis for side in (1.0, -1.0)]
                pieces.append(Patch(name, panel.name, sides[0], sides[1], "dark", is_cut=False))
    return pieces


def _along(panel: Panel, outline: Floats) -> Floats:
    """(2,) unit vector up the body, or up the arm, in panel-local coordinates."""
    if "sleeve" not in panel.name:
        up = panel.placement.matrix()[1, :2]
        return up / max(float(np.linalg.norm(up)), 1e-6)
    middle = outline - outline.mean(axis=0)
    axis = np.linalg.eigh(middle.T @ middle)[1][:, 1]
    axis = np.round(axis / np.abs(axis).max())  # along the grain
    axis = axis if np.abs(axis).sum() == 1.0 else np.array([0.0, 1.0])
    up = panel.placement.matrix()[1, :2]
    return axis if axis @ up >= 0 else -axis


def _clear(outline: Floats, axis: Floats, across: Floats, at: float) -> list[tuple[float, float]]:
    """Where the panel is as wide a little above a line and a little below it."""
    found = _crossed(outline, axis, across, at)
    for beside in (-_INSIDE, _INSIDE):
        others = _crossed(outline, axis, across, at + beside)
        shared = [(max(a, c), min(b, d)) for a, b in found for c, d in others]
        found = [(begins, ends) for begins, ends in shared if begins < ends]
    return found


def _crossed(outline: Floats, axis: Floats, across: Floats, at: float) -> list[tuple[float, float]]:
    """Where a line across the panel enters and leaves it, as often as it does."""
    heights, places = outline @ axis - at, outline @ across
    after, beyond = np.roll(heights, -1), np.roll(places, -1)
    crossing = (heights > 0) != (after > 0)
    share = heights[crossing] / (heights[crossing] - after[crossing])
    found = np.sort(places[crossing] + share * (beyond[crossing] - places[crossing])).tolist()
    return list(zip(found[::2], found[1::2], strict=False))
