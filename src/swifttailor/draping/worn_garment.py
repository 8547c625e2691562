"""A garment that is sewn already, ready to be simulated from where it is."""

from __future__ import annotations

from typing import NamedTuple

from swifttailor.body import Body
from swifttailor.body.wearer import body_of
from swifttailor.draping.attachment import find_attachment
from swifttailor.draping.cloth import ClothModel, build_cloth
from swifttailor.draping.fabric import Fabric
from swifttailor.draping.known_fabrics import get_fabric
from swifttailor.draping.simulation import Simulation, SimulationSettings
from swifttailor.garment.garment import Garment


class WornGarment(NamedTuple):
    """A garment's cloth on a body."""

    simulation: Simulation
    cloth: ClothModel
    body: Body
    fabric: Fabric


def worn_garment(
    garment: Garment, body: Body | None, fabric: Fabric | str, settings: SimulationSettings
) -> WornGarment:
    """Puts a garment on.

    Args:
        garment: Near where it will come to rest.
        body: What it is worn by; the one that the pattern was drafted for, else the default body, when None.
        fabric: A `Fabric` or the name of a preset.
        settings: How long and how finely to simulate.
    """
    fabric = get_fabric(fabric)
    body = body_of(garment.pattern.drafted_for) if body is None else body
    mesh = garment.mesh
    cloth = build_cloth(mesh, fabric)
    attachment = find_attachment(mesh, body.measurements)
    simulation = Simulation(mesh, cloth, body, fabric, attachment, garment.vertices, settings)
    return WornGarment(simulation, cloth, body, fabric)
