"""How long the stages of a garment take."""

from __future__ import annotations

import time
from collections.abc import Mapping

DIGITS = 4
"""Of the seconds that are reported."""


class Clock:
    """Seconds by stage, in the order in which stages first came."""

    def __init__(self) -> None:
        self._seconds: dict[str, float] = {}
        self._last = time.perf_counter()

    @property
    def seconds(self) -> dict[str, float]:
        """By stage, rounded."""
        return {stage: round(value, DIGITS) for stage, value in self._seconds.items()}

    def restart(self) -> None:
        """The next stage begins now."""
        self._last = time.perf_counter()

    def stop(self, stage: str) -> float:
        """What has passed since the last stop was of this stage; returns how much that is."""
        now = time.perf_counter()
        passed, self._last = now - self._last, now
        self.add({stage: passed})
        return passed

    def add(self, seconds: Mapping[str, float]) -> None:
        """Counts what others have measured."""
        for stage, value in seconds.items():
            self._seconds[stage] = self._seconds.get(stage, 0.0) + value
