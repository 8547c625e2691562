"""Numbers that several commands of ``swifttailor data`` ask for."""

from __future__ import annotations

import os

from swifttailor.errors import InputError

MAX_WORKERS = 1024


def worker_count(asked: int | None) -> int:
    """As many as were asked for, or one per processor core that this process may use.

    Raises:
        InputError: Fewer than one, or absurdly many.
    """
    if asked is None:
        if hasattr(os, "sched_getaffinity"):
            return max(1, len(os.sched_getaffinity(0)))
        return os.cpu_count() or 1
    in_range("--workers", asked, 1, MAX_WORKERS)
    return asked


def in_range(option: str, value: int, low: int, high: int) -> None:
    """Refuses a number that is out of range.

    Raises:
        InputError: It is.
    """
    if not low <= value <= high:
        raise InputError(f"{option} is {value}; from {low} to {high} is accepted.")
