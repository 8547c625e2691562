"""What a physics engine is: a sewn garment in, the garment at rest out (docs/engines.md)."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Protocol, runtime_checkable

import numpy as np

from swifttailor.arrays import Floats
from swifttailor.errors import SimulationError
from swifttailor.progress import StageProgress

if TYPE_CHECKING:
    from swifttailor.body import Body
    from swifttailor.draping.cloth import ClothModel
    from swifttailor.draping.fabric import Fabric
    from swifttailor.draping.simulation import Simulation
    from swifttailor.panel_mesh.pattern_mesh import PatternMesh


@dataclass(frozen=True, eq=False)
class SewnGarment:
    """A garment whose seams are closed around the body, before it hangs to rest."""

    mesh: PatternMesh
    """Faces, seams and the flat panels: the rest shape of the cloth."""
    body: Body
    fabric: Fabric
    cloth: ClothModel
    """Masses in kg, and springs with their rest lengths in cm."""
    simulation: Simulation
    """Our own solver, in the state that sewing left it in; an engine may let it go on."""

    @property
    def positions(self) -> Floats:
        """(v, 3) cm, of the welded vertices; a copy."""
        return self.simulation.positions.copy()


@dataclass(frozen=True, eq=False)
class Settled:
    """Where an engine leaves a garment."""

    positions: Floats
    """(v, 3) cm, of the welded vertices."""
    frames: int
    """Of 1/60 s that were simulated."""
    static: bool
    """Whether the garment came to rest."""


@runtime_checkable
class Engine(Protocol):
    """Lets a garment hang to rest."""

    def settle(self, sewn: SewnGarment, progress: StageProgress) -> Settled:
        """Lets a garment hang to rest.

        Args:
            sewn: What it begins with.
            progress: To be called with "draping" and the share that is done.
        """
        ...


def require_settled(settled: Settled, sewn: SewnGarment) -> Settled:
    """What an engine returned, if it can be the same garment.

    Raises:
        SimulationError: Positions are missing or not finite.
    """
    positions = np.asarray(settled.positions)
    if positions.shape != (sewn.mesh.vertex_count, 3):
        raise SimulationError(
            f"The engine returned positions of shape {positions.shape}; ({sewn.mesh.vertex_count}, 3) is "
            "expected: one for each welded vertex, in cm."
        )
    if not np.isfinite(positions).all():
        raise SimulationError(
            "The cloth moved to infinity. Check the pattern for degenerate panels with "
            "'swifttailor check', or use a longer edge length or a softer fabric."
        )
    return settled
