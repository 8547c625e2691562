"""Means that say of how many they are."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True)
class Mean:
    """Of one measure over those that have it."""

    mean: float
    median: float
    count: int


Means = dict[str, Mean]


def mean_of(values: Iterable[float | bool | None]) -> Mean | None:
    """The mean of the numbers among some values; None where there are none."""
    numbers = [float(v) for v in values if v is not None]
    if not numbers:
        return None
    return Mean(float(np.mean(numbers)), float(np.median(numbers)), len(numbers))
