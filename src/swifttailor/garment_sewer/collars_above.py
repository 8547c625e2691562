"""Collars that are turned down, kept above the cloth of front and back while they fall.

They are lifted off it before (`layers.py`) and snap back faster than contacts are searched for: half of all
shirts would have a collar below their shoulders.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from scipy.spatial import KDTree

from swifttailor.arrays import Bools, Floats, Ints
from swifttailor.body import Body
from swifttailor.garment_sewer.pixels.body_distance import BodyDistance
from swifttailor.panel_mesh.pattern_mesh import PatternMesh

if TYPE_CHECKING:
    from swifttailor.draping.simulation import Simulation

_COLLAR, _FALL = "collar", "collar_fall"
_ABOVE_CM = 0.45
"""So far above the cloth beside it each of its vertices stays, away from the body, cm."""
_BESIDE, _BESIDE_CM = 6, 3.0
"""Of that cloth so many vertices count that lie so near, cm."""
_BELOW_CM = 20.0
"""Cloth so far below the lowest of the collar has nothing to do with it, cm."""


@dataclass(frozen=True, eq=False)
class CollarAbove:
    """What is turned down of a collar, and the cloth below."""

    collar: Ints
    """(k,) welded vertices of what is turned down."""
    cloth: Ints
    """(m,) of the cloth that it lies on."""
    distance: BodyDistance

    def __call__(self, simulation: Simulation, share: float) -> None:
        """Lifts what has sunk into the cloth below; `share` of the time is over."""
        points = simulation.positions[self.collar]
        below = simulation.positions[self.cloth]
        off = np.append(self.distance.sample(below, np.zeros(len(below), dtype=bool))[0], -np.inf)
        near = KDTree(below).query(points, k=_BESIDE, distance_upper_bound=_BESIDE_CM)[1]
        own, ways = self.distance.sample(points, np.zeros(len(points), dtype=bool))
        lift = off[near].max(axis=1) + _ABOVE_CM - own
        sunk = lift > 0.0
        rows = self.collar[sunk]
        simulation.positions[rows] += lift[sunk, None] * ways[sunk]
        speed = simulation.velocities[rows]
        inward = np.minimum((speed * ways[sunk]).sum(axis=1, keepdims=True), 0.0)
        simulation.velocities[rows] = speed - inward * ways[sunk]


def collar_above(mesh: PatternMesh, vertices: Floats, body: Body) -> CollarAbove | None:
    """What keeps a turned-down collar above the cloth; None where a garment has none.

    Args:
        mesh: Of the garment.
        vertices: (v, 3) where it begins to fall, cm.
        body: Who wears it.
    """
    names = [panel.name for panel in mesh.pattern.panels]
    others = _vertices_of(mesh, np.array([_COLLAR not in name for name in names]))
    stands = _vertices_of(mesh, np.array([_COLLAR in name and _FALL not in name for name in names]))
    falls = _vertices_of(mesh, np.array([_FALL in name for name in names]))
    collar = np.flatnonzero(falls & ~stands & ~others).astype(np.int32)
    if not len(collar):
        return None
    near = vertices[:, 1] > float(vertices[collar, 1].min()) - _BELOW_CM
    cloth = np.flatnonzero(others & near).astype(np.int32)
    return CollarAbove(collar, cloth, BodyDistance.of(body))


def _vertices_of(mesh: PatternMesh, chosen: Bools) -> Bools:
    """(v,) vertices of chosen panels (p,)."""
    found = np.zeros(mesh.vertex_count, dtype=bool)
    found[mesh.weld[chosen[mesh.flat_panel]]] = True
    return found
