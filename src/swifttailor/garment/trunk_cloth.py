"""Which cloth of a garment goes around the trunk, and not around an arm."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from swifttailor.arrays import Bools
from swifttailor.pattern import body_region

if TYPE_CHECKING:
    from swifttailor.garment.garment import Garment

_HEM_CM = 3.0
"""Height of what counts as the lower end of a torso panel."""
_WINGED = 1.4
"""A torso panel that reaches so many times as far out as its hem has a sleeve of the same cloth."""


def around_trunk(garment: Garment) -> Bools:
    """(m,) which flat vertices are neither in a sleeve nor in one that is cut in one with the torso."""
    mesh = garment.mesh
    panels = garment.pattern.panels
    found = np.array([body_region(p.name, p.label) != "arm" for p in panels])[mesh.flat_panel]
    for number, panel in enumerate(panels):
        if body_region(panel.name, panel.label) != "body":
            continue
        outline = panel.to_world(panel.outline(0.5))
        out, height = np.abs(outline[:, 0]), outline[:, 1]
        hem = float(out[height < height.min() + _HEM_CM].max())
        if out.max() > _WINGED * hem:
            own = mesh.flat_panel == number
            found[own] = np.abs(panel.to_world(mesh.flat_vertices[own])[:, 0]) <= hem
    return found
