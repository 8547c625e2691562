"""Lines of quilting across torso and sleeves, where a tailor would chalk them."""

from __future__ import annotations

import re

import numpy as np

from swifttailor.arrays import Floats
from swifttailor.pattern.panel import Panel
from swifttailor.pattern.trims.chalk import Chalk
from swifttailor.pattern.trims.shapes import Patch, Trim

_APART, _HALF, _INSIDE = 8.5, 0.14, 0.3
"""Distance of the lines, half their width, and what stays free beside the outline, cm."""
_QUILTED = re.compile(r"(left|right)_(ftorso|btorso|sleeve_[fb])|skirt_(front|back)")


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
        first = high.max() - _APART * chalk.size
        for at in np.arange(first, high.min() + 3.0, -_APART * chalk.size):
            ends = _crossed(outline, axis, across, float(at))
            if ends is None or ends[1] - ends[0] < 3.0:
                continue
            places = np.linspace(ends[0] + _INSIDE, ends[1] - _INSIDE, 8)[:, None] * across
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
    up = panel.placement.matrix()[1, :2]
    return axis if axis @ up >= 0 else -axis


def _crossed(outline: Floats, axis: Floats, across: Floats, at: float) -> tuple[float, float] | None:
    """Where a line across the panel enters and leaves it; None where it does not meet it."""
    heights, places = outline @ axis, outline @ across
    after, beyond = np.roll(heights, -1), np.roll(places, -1)
    crossing = ((heights - at) * (after - at) <= 0) & (heights != after)
    if crossing.sum() < 2:
        return None
    share = (at - heights[crossing]) / (after[crossing] - heights[crossing])
    found = places[crossing] + share * (beyond[crossing] - places[crossing])
    return float(found.min()), float(found.max())
