"""Whether the loops still have to be compiled on this machine, and having those of the coarse drape ready."""

from __future__ import annotations

import hashlib
import os
import sys
from pathlib import Path
from threading import Thread

import numpy as np

from swifttailor.body import BodyMeasurements, DistanceField
from swifttailor.pattern import EdgeRef, Panel, Pattern, Stitch
from swifttailor.pattern.panel import Edge, Placement

COMPILE_NOTE = "compiling the solver (first time only, about 20 s)"
COARSE_COMPILE_NOTE = "compiling the coarse drape (first time only, about 8 s)"


def solver_is_compiled() -> bool:
    """Whether numba finds the solver's compiled code on disk, so that a drape starts at once."""
    return _is_compiled("xpbd_kernels", "advance_frame")


def coarse_drape_is_compiled() -> bool:
    """The same of the coarse drape."""
    return _is_compiled("coarse_kernels", "sew_and_hang")


class CoarseDrapeLoading:
    """The coarse drape's loops, being loaded or compiled in the background.

    The thread ends with the program: an error elsewhere, or Ctrl-C, does not wait for the compiler.
    """

    def __init__(self, full: DistanceField, armless: DistanceField, measurements: BodyMeasurements) -> None:
        """Begins; see `load_coarse_drape`."""
        self._error: Exception | None = None
        self._thread = Thread(
            target=self._load, args=(full, armless, measurements), name="coarse drape", daemon=True
        )
        self._thread.start()

    def wait(self) -> None:
        """Returns when the loops are ready.

        Raises:
            Exception: Whatever kept them from being loaded.
        """
        self._thread.join()
        if self._error is not None:
            raise self._error

    def _load(self, full: DistanceField, armless: DistanceField, measurements: BodyMeasurements) -> None:
        try:
            _drape_two_squares(full, armless, measurements)
        except Exception as error:  # told to whoever waits
            self._error = error


def load_coarse_drape(
    full: DistanceField, armless: DistanceField, measurements: BodyMeasurements
) -> CoarseDrapeLoading:
    """Begins to load the coarse drape's loops, or to compile them, in the background.

    Compiling takes several seconds of the first garment ever, loading a few hundredths of one: meanwhile a
    network can write the pattern, since it does not hold Python's lock while it runs.

    Args:
        full: Distance to the body, as the drape will be given it: what the loops are called with decides what
            is compiled.
        armless: The same without the arms.
        measurements: Of the body.

    Returns:
        What is to be waited for before the first garment is draped.
    """
    return CoarseDrapeLoading(full, armless, measurements)


def _drape_two_squares(full: DistanceField, armless: DistanceField, measurements: BodyMeasurements) -> None:
    """Drapes two squares that are sewn together along one edge, for no time at all."""
    from swifttailor.draping.coarse import CoarseSettings, drape_coarsely
    from swifttailor.panel_mesh import mesh_pattern

    corners = np.array([[-20.0, 100.0], [20.0, 100.0], [20.0, 140.0], [-20.0, 140.0]])
    squares = tuple(
        Panel(name, corners, (Edge(),) * 4, Placement((0.0, 0.0, z)))
        for name, z in (("a", 30.0), ("b", -30.0))
    )
    pattern = Pattern(squares, (Stitch(EdgeRef("a", 0), EdgeRef("b", 0), right_wrong=True),))
    no_time = CoarseSettings(closing_frames=0, calming_frames=0, hanging_frames=0)
    drape_coarsely(mesh_pattern(pattern, 20.0), full, armless, measurements, settings=no_time)


def _is_compiled(module: str, function: str) -> bool:
    """Whether numba has kept what it compiled of a function, and the source is not newer.

    Used only to say what the wait is for. numba has no public question for this, and loading it to ask takes
    a third of a second; so its index is looked for where numba keeps it, unread. Folders that several
    programs share have one for each folder of sources, named by its path: another copy of the package counts
    for nothing.
    """
    source = Path(__file__).with_name(f"{module}.py")
    folder = os.path.abspath(source.parent)
    own = f"{source.parent.name}_{hashlib.sha1(folder.encode(), usedforsecurity=False).hexdigest()}"
    if kept := os.environ.get("NUMBA_CACHE_DIR"):
        places = [Path(kept) / own]
    else:
        shared = Path(os.environ.get("XDG_CACHE_HOME") or os.path.expanduser("~/.cache"))
        places = [source.parent / "__pycache__", shared / "numba" / own]
    name = f"{module}.{function}-*.py{sys.version_info.major}{sys.version_info.minor}*.nbi"
    written = source.stat().st_mtime
    return any(index.stat().st_mtime >= written for place in places for index in place.glob(name))
