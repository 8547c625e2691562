"""Means that say of how many they are."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np


@dataclass(frozen=True)
class Mean:
    """Of one measure over those that have it."""

    mean: float
    median: float
    count: int


Means = dict[str, Mean]


def means_of(rows: Sequence[Mapping[str, Any]], without: Collection[str] = ()) -> Means:
    """The mean of each entry over the rows that have a number there.

    Args:
        rows: Of one kind.
        without: Entries that are no measures.
    """
    names = [name for name in (rows[0] if rows else ()) if name not in without]
    found = {name: mean_of(row[name] for row in rows) for name in names}
    return {name: mean for name, mean in found.items() if mean is not None}


def mean_in(means: Means, name: str, factor: float = 1.0) -> float | None:
    """A mean times a factor, for a table; None where nothing had the measure."""
    return means[name].mean * factor if name in means else None


def mean_of(values: Iterable[float | bool | None]) -> Mean | None:
    """The mean of the numbers among some values; None where there are none."""
    numbers = [float(v) for v in values if v is not None]
    if not numbers:
        return None
    return Mean(float(np.mean(numbers)), float(np.median(numbers)), len(numbers))
