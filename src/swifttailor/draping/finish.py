"""Lets a garment that is sewn already hang to rest: it gets its wrinkles and clears the body."""

from __future__ import annotations

import time

import numpy as np

from swifttailor.body import Body
from swifttailor.draping.fabric import Fabric
from swifttailor.draping.quality import measure_quality
from swifttailor.draping.simulation import SimulationSettings
from swifttailor.draping.untangle import settle_untangled
from swifttailor.draping.worn_garment import worn_garment
from swifttailor.errors import SimulationError
from swifttailor.garment.garment import Garment
from swifttailor.progress import StageProgress


def finish(
    garment: Garment,
    *,
    body: Body | None = None,
    fabric: Fabric | str = "cotton",
    settings: SimulationSettings | None = None,
    progress: StageProgress | None = None,
) -> Garment:
    """Drapes a garment from where it is, without sewing it first.

    Args:
        garment: Near where it will come to rest.
        body: What it is worn by; the one that the pattern was drafted for, else the default body, when None.
        fabric: A `Fabric` or the name of a preset.
        settings: How long and how finely to simulate.
        progress: Called with the stage's name and the share of it that is done.

    Returns:
        The garment at rest; its report is the one it had, with `quality` and the seconds it took.

    Raises:
        SimulationError: The cloth went to infinity.
    """
    started = time.perf_counter()
    mesh = garment.mesh
    simulation, cloth, body, fabric = worn_garment(garment, body, fabric, settings or SimulationSettings())
    frames, static = settle_untangled(simulation, progress or (lambda stage, share: None))
    if not np.isfinite(simulation.positions).all():
        raise SimulationError(
            "The cloth moved to infinity. Drape the pattern instead: swifttailor drape PATTERN"
        )
    quality = measure_quality(
        mesh,
        simulation.positions,
        cloth,
        body,
        static=static,
        frames=frames,
        ignores_arms=simulation.field.ignores_arms,
    )
    seconds = garment.report.get("seconds", {}) | {"finishing": round(time.perf_counter() - started, 4)}
    report = garment.report | {"quality": quality.to_json(), "fabric": fabric.name, "seconds": seconds}
    return Garment(mesh, simulation.positions, report)
