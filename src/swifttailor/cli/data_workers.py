"""How many processes the commands of ``swifttailor data`` use."""

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
    if not 1 <= asked <= MAX_WORKERS:
        raise InputError(f"--workers is {asked}; from 1 to {MAX_WORKERS} is accepted.")
    return asked
