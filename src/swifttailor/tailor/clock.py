"""How long the stages of a garment take."""

from __future__ import annotations

import time
from collections.abc import Mapping


class Clock:
    """Seconds by stage, in the order in which stages first came."""

    def __init__(self) -> None:
        self.seconds: dict[str, float] = {}
        self._last = time.perf_counter()

    def restart(self) -> None:
        """The next stage begins now."""
        self._last = time.perf_counter()

    def stop(self, stage: str) -> None:
        """What has passed since the last stop was of this stage."""
        now = time.perf_counter()
        self.add({stage: now - self._last})
        self._last = now

    def add(self, seconds: Mapping[str, float]) -> None:
        """Counts what others have measured."""
        for stage, value in seconds.items():
            self.seconds[stage] = self.seconds.get(stage, 0.0) + value
