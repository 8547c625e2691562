"""Gives up on a drape that would take too long, and says so."""

from __future__ import annotations

import time

from swifttailor.errors import TimeLimitError
from swifttailor.progress import StageProgress

USUAL_SECONDS = 22.0
"""Of physics, enough for garments of usual size at `_USUAL_EDGE_CM`, which take two to five."""
_USUAL_EDGE_CM = 2.0
_STAGES = ("sewing", "draping")


def usual_time_limit(edge_length: float) -> float:
    """Seconds after which a drape is given up where nothing else is said; a finer mesh (cm) has more."""
    return USUAL_SECONDS * max(1.0, _USUAL_EDGE_CM / edge_length) ** 2


class TimeLimit:
    """A `StageProgress` that ends the simulation after some seconds of computing.

    Seconds are those that this process computes, so that a busy machine changes nothing. They count from the
    meshing on; where the first frame has to compile the solver, from there.
    """

    def __init__(
        self, seconds: float, progress: StageProgress, *, instead: str, compiled: bool = False
    ) -> None:
        """Makes it ready.

        Args:
            seconds: How long it may take.
            progress: Every call is passed on to it.
            instead: What a person can do where it takes longer, as a sentence.
            compiled: Whether the solver is compiled already.
        """
        self._instead = instead
        self._seconds = seconds
        self._progress = progress
        self._compiled = compiled
        self._started: float | None = None

    def __call__(self, stage: str, share: float) -> None:
        """Takes note of how far a stage has come.

        Raises:
            TimeLimitError: The time is over.
        """
        self._progress(stage, share)
        counts = stage in _STAGES and share > 0.0
        if not counts and not self._compiled:
            return
        now = time.process_time()
        self._started = now if self._started is None else self._started
        if counts and now - self._started > self._seconds and share < 1.0:
            raise TimeLimitError(
                f"Gave up {stage} after {self._seconds:g} seconds: more cloth than in usual garments, "
                f"or more tangled. {self._instead} What may be wrong with the pattern: "
                "swifttailor check PATTERN"
            )
