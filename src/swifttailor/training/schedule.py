"""The learning rate: a short rise, then half a cosine to the end of the steps or of the time."""

from __future__ import annotations

import math
from dataclasses import dataclass


@dataclass(frozen=True)
class Schedule:
    """How far a training is, and the learning rate there."""

    steps: int
    warmup_steps: int
    final_rate: float
    """Share of the learning rate left at the end."""
    max_seconds: float | None = None
    """Of training; where the time ends first, the cosine ends with it."""

    def progress(self, step: int, seconds: float) -> float:
        """Share of the training that is over, 0 to 1: of the steps or of the time, whichever is further."""
        share = step / self.steps
        if self.max_seconds is not None:
            share = max(share, seconds / self.max_seconds)
        return min(share, 1.0)

    def rate(self, step: int, seconds: float) -> float:
        """Factor on the learning rate for an optimiser step, from 0."""
        rise = min(1.0, (step + 1) / self.warmup_steps) if self.warmup_steps else 1.0
        cosine = 0.5 * (1 + math.cos(math.pi * self.progress(step, seconds)))
        return rise * (self.final_rate + (1 - self.final_rate) * cosine)
