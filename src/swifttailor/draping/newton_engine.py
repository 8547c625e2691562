"""The last stage of a drape on Newton's Style3D cloth solver (extra `newton`), on a CPU or a GPU.

Newton has no sewing stage: started from flat panels its solvers pull the body through the cloth. So our
XPBD sews and lets the garment fall, and Newton takes it over and brings it to rest.
"""

from __future__ import annotations

import contextlib
import importlib
from collections.abc import Generator
from dataclasses import replace
from typing import Any

import numpy as np

from swifttailor.draping.engine import Settled, SewnGarment
from swifttailor.draping.newton_stage import advance_frame, build_stage, widen_clearance
from swifttailor.draping.simulation import Simulation, settle
from swifttailor.errors import MissingExtraError
from swifttailor.progress import StageProgress

HANDOVER_FRAMES = 60
"""Frames of 1/60 s for which XPBD lets the sewn garment fall before Newton takes over."""
_MIN_FRAMES = 30


def require_newton() -> None:
    """Makes sure that Newton can be imported; costs what importing it costs.

    Raises:
        MissingExtraError: It cannot.
    """
    try:
        with _quiet():
            importlib.import_module("newton")
    except ImportError:
        raise MissingExtraError("newton", "newton", "The newton engine") from None


class NewtonEngine:
    """Lets a sewn garment hang to rest, in the end on Newton's Style3D solver.

    Style3D's fixed number of iterations acts like a thick liquid: a circle skirt falls a tenth as fast as it
    should and would pass for resting on the way. So XPBD lets the garment fall for `HANDOVER_FRAMES`, with
    stretched edges held off the body between their vertices, and Style3D goes on from there with the same
    velocities. What becomes of our model in Newton's:

    - Mass: `cloth.mass`, kg, vertex by vertex.
    - Stretch: `Fabric.stretch`, N/m, but at most `newton_stage.MAX_STRETCH` for each kg/m^2 of density, is
      Style3D's stiffness along both thread directions; shear gets `SHEAR_SHARE` of it. That is softer than
      on XPBD; the strains measured afterwards are about the same, the largest ones smaller.
      Rest shapes are the flat panels' triangles; next to a seam they are bent to `cloth.arrays.rest`, so
      that at a gather the shorter side holds (see `newton_stage.rest_triangles`).
    - Bending: `Fabric.bending` in N m as it is; both use the energy of Bergou et al. 2006.
    - Thickness: cm to m; kept from the body by the particle radius, between layers by the contact radius
      (when `settings.self_collision`).
    - Friction: `Fabric.friction` is the Coulomb coefficient on the body. Cloth on cloth has none.
    - Body: its triangles. Vertices over the legs see a second body whose arms are cut off: Newton cannot
      choose per vertex, so the contacts it finds with the wrong one of the two are thrown away.
    - Held vertices: a frictionless floor under each, at the level `Simulation.hold` gives it.
    - Damping: as in the XPBD engine, velocities decay by 2 per second and more when it takes long.

    The solver runs on Warp's default device; on a CPU the result is the same every time. The first run on
    a machine compiles Newton's kernels, which takes half a minute and is kept on disk.
    """

    def __init__(self) -> None:
        """Makes sure that Newton is there.

        Raises:
            MissingExtraError: It is not installed.
        """
        require_newton()

    def settle(self, sewn: SewnGarment, progress: StageProgress) -> Settled:
        """See `Engine`; the positions of `sewn.simulation` are replaced."""
        simulation, body = sewn.simulation, sewn.body
        settings = simulation.settings
        first = _fall(simulation, progress)
        simulation.let_go()
        with _quiet():
            stage = build_stage(simulation, sewn.cloth, sewn.mesh, body)
            for k in range(first, settings.max_frames):
                # As in the XPBD engine: what will not rest within two seconds only chatters.
                damping = 2.0 + 8.0 * min(max(k - 90, 0) / 200, 1.0)
                before = simulation.positions
                simulation.positions = advance_frame(stage, damping)
                if not np.isfinite(simulation.positions).all():
                    return Settled(simulation.positions, k + 1, static=False)
                moved = np.abs(simulation.positions - before).sum(axis=1)
                simulation.moving = float((moved > settings.still_cm).mean())
                widen_clearance(stage, simulation, body)
                progress("draping", min((k + 1) / (first + 60), 0.99))
                if k + 1 >= first + _MIN_FRAMES and simulation.moving <= settings.still_share:
                    return Settled(simulation.positions, k + 1, static=True)
        return Settled(simulation.positions, settings.max_frames, static=False)


def _fall(simulation: Simulation, progress: StageProgress) -> int:
    """Lets the garment fall on our own solver. Returns the frames that took."""
    settings = simulation.settings
    simulation.settings = replace(settings, max_frames=min(HANDOVER_FRAMES, settings.max_frames))
    try:
        frames, _ = settle(simulation, lambda stage, share: progress(stage, min(share, 0.5)))
    finally:
        simulation.settings = settings
    return frames


@contextlib.contextmanager
def _quiet() -> Generator[None]:
    """Keeps Warp's banner and compiler notes off stdout; warnings still show."""
    warp: Any = importlib.import_module("warp")
    with warp.ScopedLogLevel(warp.LOG_WARNING):
        yield
