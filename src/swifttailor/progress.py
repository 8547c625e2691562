"""How long work says how far it has come: two kinds of functions that callers may give it."""

from __future__ import annotations

from collections.abc import Callable

StageProgress = Callable[[str, float], None]
"""Called with the name of a stage and the share of it that is done, 0 to 1."""
CountProgress = Callable[[int], None]
"""Called with the number of items that were done since the last call."""


def unwatched(count: int) -> None:
    """A `CountProgress` where nobody looks."""
