"""Some of many, evenly spread."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TypeVar

import numpy as np

T = TypeVar("T")


def spread(ordered: Sequence[T], count: int) -> list[T]:
    """At most `count` of some things, evenly from the first to the last."""
    if not ordered or count < 1:
        return []
    places = np.linspace(0, len(ordered) - 1, min(count, len(ordered))).round().astype(int)
    return [ordered[k] for k in np.unique(places).tolist()]
