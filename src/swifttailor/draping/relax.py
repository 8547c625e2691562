"""Lets sewn cloth fall for a moment: it gets back its length, and folds as cloth does."""

from __future__ import annotations

import time
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from swifttailor.arrays import Floats
from swifttailor.body import Body
from swifttailor.draping.fabric import Fabric
from swifttailor.draping.simulation import Hold, SimulationSettings, fall, grow, smooth_down
from swifttailor.draping.worn_garment import worn_garment
from swifttailor.errors import SimulationError
from swifttailor.garment.garment import Garment
from swifttailor.progress import StageProgress

FRAMES = 8
"""Of a sixtieth of a second: seams that were predicted rippled are smooth after these, and collars lie."""
GROWING_FRAMES = 16
SUBSTEPS = 18
"""As many as in a drape: with fewer, cloth hangs longer than it is (docs/LOG.md)."""
GROWING_SUBSTEPS = 12
"""While cloth grows nothing hangs yet, so fewer do: what falls afterwards gets its lengths there."""
CONTACT_INTERVAL = 6
"""Searches for contacts are a third of the time; a drape, which falls for longer, makes one in 5 substeps."""
DAMPING = 4.0
"""Per second, as in the third second of a drape: what falls slowly does not pass through itself."""


def relax(
    garment: Garment,
    *,
    body: Body | None = None,
    fabric: Fabric | str = "cotton",
    frames: int = FRAMES,
    smoothed: int = 0,
    grown_from: Floats | None = None,
    carefully: bool = False,
    holds: Sequence[Hold] = (),
    progress: StageProgress | None = None,
) -> Garment:
    """Lets a garment fall for a short while, from where it is; it need not come to rest (see `finish`).

    Args:
        garment: Near where it will come to rest.
        body: What it is worn by; the one that the pattern was drafted for, else the default body, when None.
        fabric: A `Fabric` or the name of a preset.
        frames: For so many sixtieths of a second.
        smoothed: For so many before it is smoothed down over the body.
        grown_from: (v, 3) where its cloth lies smoothly but too short, cm: it grows to its lengths from there
            before it falls, in `GROWING_FRAMES`.
        carefully: Whether it takes as many substeps and searches for contacts as a drape, all the time.
        holds: What moves some of it after every frame in which it falls, as a belt does.
        progress: Called with the stage's name and the share of it that is done.

    Returns:
        The garment; its report is the one it had, with the frames under ``relaxed_frames`` and the seconds
        it took under ``seconds``.

    Raises:
        SimulationError: The cloth went to infinity.
    """
    started = time.perf_counter()
    settings = SimulationSettings(substeps=SUBSTEPS)
    if not carefully:
        settings = replace(settings, contact_interval=CONTACT_INTERVAL)
    worn = worn_garment(garment, body, fabric, settings)
    simulation = worn.simulation
    say = progress or (lambda stage, share: None)
    if grown_from is not None:
        simulation.positions[:] = grown_from
        grow(simulation, GROWING_FRAMES, say, SUBSTEPS if carefully else GROWING_SUBSTEPS)
    if smoothed:
        smooth_down(simulation, smoothed, worn.body.measurements.armpit_level, say)
    fall(simulation, frames, DAMPING, say, holds)
    if not np.isfinite(simulation.positions).all():
        raise SimulationError(
            "The cloth moved to infinity while it was relaxed. Drape the pattern instead: swifttailor drape "
            "PATTERN; or leave it as it was sewn: --no-relax"
        )
    seconds = garment.report.get("seconds", {}) | {"relaxing": round(time.perf_counter() - started, 4)}
    report = garment.report | {"relaxed_frames": frames, "fabric": worn.fabric.name, "seconds": seconds}
    return replace(garment, vertices=simulation.positions, report=report)
