"""Which cloth of a garment goes around the trunk, and not around an arm."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from swifttailor.arrays import Bools
from swifttailor.pattern import body_region

if TYPE_CHECKING:
    from swifttailor.garment.garment import Garment
    from swifttailor.pattern.panel import Panel

_HEM_CM = 3.0
"""Height of what counts as the lower end of a torso panel."""
_WINGED = 1.4
"""A torso panel that reaches so many times as far out as its hem has a sleeve of the same cloth."""
_WIDER = 1.15
"""Lower ends of the panels of one torso are as wide as each other, but for so much."""


def around_trunk(garment: Garment) -> Bools:
    """(m,) which flat vertices are neither in a sleeve nor in one that is cut in one with the torso."""
    mesh = garment.mesh
    panels = garment.pattern.panels
    found = np.array([body_region(p.name, p.label) != "arm" for p in panels])[mesh.flat_panel]
    reaches = {
        number: _reach(panel)
        for number, panel in enumerate(panels)
        if body_region(panel.name, panel.label) == "body"
    }
    least = min([hem for out, hem in reaches.values() if out > _WINGED * hem], default=0.0)
    for number, (out, hem) in reaches.items():
        if least and out > _WINGED * least:
            own = mesh.flat_panel == number
            # Of crossed fronts one ends beside the sleeve, and is as wide there as that is.
            wide = hem if hem < _WIDER * least else least
            found[own] = np.abs(panels[number].to_world(mesh.flat_vertices[own])[:, 0]) <= wide
    return found


def _reach(panel: Panel) -> tuple[float, float]:
    """How far from the middle a panel reaches, and its lower end does, cm."""
    outline = panel.to_world(panel.outline(0.5))
    out, height = np.abs(outline[:, 0]), outline[:, 1]
    return float(out.max()), float(out[height < height.min() + _HEM_CM].max())
