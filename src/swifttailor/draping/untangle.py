"""Pulls cloth that was sewn in tucked through itself out again."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import csr_array

from swifttailor.draping.intersections import crossing_pairs
from swifttailor.draping.simulation import Simulation, settle
from swifttailor.progress import StageProgress

_SHRINK_FRAMES = 12
_GROW_FRAMES = 18
_SHRUNK = 0.35
_RINGS = (3, 3, 6)
_NEARLY_DONE = 0.99

FEW_CROSSINGS = 5
"""So few crossings of single edges cannot be seen; trying again costs more than it brings."""


def untangle(simulation: Simulation, progress: StageProgress, stage: str) -> int:
    """Removes self-crossings around which the cloth can be drawn tight.

    Minimising the line of intersection cannot undo a tuck that ends at a seam, where the two layers join.
    So the neighbourhood of the crossings is shrunk like a rubber membrane, without self-collision: it
    snaps to a small surface that does not cross itself. Then it grows back with self-collision on, and
    buckles without passing through. Rounds widen the neighbourhood.

    Args:
        simulation: Brought on in place.
        progress: Called after every frame.
        stage: Name of the stage that this is the end of.

    Returns:
        The crossings that remain.
    """
    cloth = simulation.cloth
    remaining = _crossings(simulation)
    for rings in _RINGS:
        if remaining <= FEW_CROSSINGS:
            break
        before = simulation.positions.copy()
        region = _neighborhood(simulation, rings)
        share = region[cloth.edges].all(axis=1)
        shrunk = np.where(share, cloth.rest * _SHRUNK, cloth.rest)
        for k in range(_SHRINK_FRAMES):
            a = min(1.0, (k + 1) / 6)
            _calm_frame(simulation, cloth.rest * (1 - a) + shrunk * a, self_collision=False)
            progress(stage, _NEARLY_DONE)
        for k in range(_GROW_FRAMES):
            a = min(1.0, (k + 1) / 12)
            _calm_frame(simulation, shrunk * (1 - a) + cloth.rest * a, self_collision=True)
            progress(stage, _NEARLY_DONE)
        after = _crossings(simulation)
        if after >= remaining:
            simulation.positions[:] = before
            simulation.velocities[:] = 0.0
            break
        remaining = after
    return remaining


def settle_untangled(simulation: Simulation, progress: StageProgress) -> tuple[int, bool]:
    """Lets the garment hang to rest; if it crosses itself there, untangles it and lets it hang again.

    Returns:
        The frames used and whether it came to rest.
    """
    frames, static = settle(simulation, progress)
    if (
        simulation.has_slid_down
        or not simulation.settings.self_collision
        or _crossings(simulation) <= FEW_CROSSINGS
    ):
        return frames, static
    before, crossings = simulation.positions.copy(), _crossings(simulation)
    if untangle(simulation, progress, "draping") < crossings:
        more, again = settle(simulation, progress)
        if _crossings(simulation) < crossings and again >= static:
            return frames + more, again
        simulation.positions[:] = before
    return frames, static


def _crossings(simulation: Simulation) -> int:
    return len(crossing_pairs(simulation.positions, simulation.cloth.edges, simulation.cloth.faces))


def _calm_frame(simulation: Simulation, rest: NDArray[np.float64], *, self_collision: bool) -> None:
    simulation.frame(
        gravity=0.0, damping=20.0, friction=0.2, bending_factor=5.0, self_collision=self_collision, rest=rest
    )


def _neighborhood(simulation: Simulation, rings: int) -> NDArray[np.bool_]:
    """(v,) vertices within so many edges of a crossing."""
    cloth = simulation.cloth
    count = len(simulation.positions)
    pairs = crossing_pairs(simulation.positions, cloth.edges, cloth.faces)
    region = np.zeros(count, dtype=bool)
    region[cloth.edges[pairs[:, 0]]] = True
    region[cloth.faces[pairs[:, 1]]] = True
    links = csr_array(
        (np.ones(len(cloth.neighbors), np.int8), cloth.neighbors, cloth.neighbor_start), shape=(count, count)
    )
    for _ in range(rings):
        region = region | (links @ region.astype(np.int8) > 0)
    return region
