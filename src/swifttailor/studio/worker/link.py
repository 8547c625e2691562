"""What a task in a worker process may say to the server while it runs."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from swifttailor.arrays import Floats
from swifttailor.studio.mesh_record import MeshRecord

FRAMES_A_SECOND = 12.0
"""Of a drape, at most."""
_STAGE_EVERY = 0.1
"""Seconds between two messages about the same stage."""


class StoppedError(Exception):
    """The task was asked to stop."""


@dataclass
class Link:
    """From a task to the server: how far it is; from the server: whether to stop."""

    send: Callable[[tuple[Any, ...]], None]
    stop_asked: Callable[[], bool]
    _stage: str = field(default="", init=False)
    _stage_sent: float = field(default=0.0, init=False)
    _frame_sent: float = field(default=0.0, init=False)

    def stage(self, name: str, share: float) -> None:
        """Tells how far a stage is.

        Raises:
            StoppedError: The server asks to stop.
        """
        now = time.monotonic()
        if name != self._stage or now - self._stage_sent >= _STAGE_EVERY or share >= 1.0:
            self._stage, self._stage_sent = name, now
            self.send(("stage", name, float(share)))
            if self.stop_asked():
                raise StoppedError

    def meshes(self, *records: MeshRecord) -> None:
        """Hands over meshes before the task is done: those that frames are of."""
        self.send(("meshes", records))

    def frame(self, mesh: str, positions: Floats) -> None:
        """Shows positions (v, 3) in cm of a mesh's welded vertices, some times a second.

        Raises:
            StoppedError: The server asks to stop.
        """
        now = time.monotonic()
        if now - self._frame_sent < 1.0 / FRAMES_A_SECOND:
            return
        self._frame_sent = now
        if np.isfinite(positions).all():
            self.send(("frame", mesh, np.ascontiguousarray(positions, dtype="<f4").tobytes()))
        if self.stop_asked():
            raise StoppedError
