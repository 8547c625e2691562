"""Checks of the options that several commands have, made before anything is loaded."""

from __future__ import annotations

import math
import os
from pathlib import Path

from swifttailor.errors import InputError

MAX_WORKERS = 1024
MAX_THREADS = 256
MAX_SEED = 2**63 - 1
MIN_EDGE_CM, MAX_EDGE_CM = 0.5, 10.0


def in_range(option: str, value: float | None, low: float, high: float, hint: str = "is accepted.") -> None:
    """Refuses a number that is out of range, or none (NaN).

    Args:
        option: As it is typed, ``--threads``.
        value: None, where the option was not given, is accepted.
        low: Smallest number accepted.
        high: Largest number accepted.
        hint: End of the message, with the unit.

    Raises:
        InputError: It is out of range.
    """
    if value is not None and not low <= value <= high:
        shown, least, most = (f"{v:g}" if isinstance(v, float) else str(v) for v in (value, low, high))
        raise InputError(f"{option} is {shown}; from {least} to {most} {hint}")


def require_threads(threads: int | None) -> None:
    """Refuses numbers of processor cores that no machine has."""
    in_range("--threads", threads, 1, MAX_THREADS)


def require_edge_length(edge_length: float) -> None:
    """Refuses meshes too fine to hold in memory or too coarse for a garment."""
    hint = "cm is accepted. 2 is usual, 1 fine, 4 coarse."
    in_range("--edge-length", edge_length, MIN_EDGE_CM, MAX_EDGE_CM, hint)


def require_seed(seed: int) -> None:
    """Refuses seeds that a random generator does not take."""
    if not 0 <= seed <= MAX_SEED:
        raise InputError(f"--seed is {seed}; a whole number from 0 to 2^63 - 1 is accepted.")


def require_limit(limit: int | None) -> None:
    """Refuses a number of items of which none would be left."""
    if limit is not None and limit < 1:
        raise InputError(f"--limit is {limit}; a whole number of at least 1 is accepted.")


def require_time_limit(seconds: float | None) -> None:
    """Refuses times in which nothing can be done."""
    if seconds is not None and not (math.isfinite(seconds) and seconds >= 1):
        raise InputError(f"--time-limit is {seconds:g}; at least 1 second is accepted.")


def require_max_minutes(minutes: float | None) -> None:
    """Refuses times of no length, or without an end."""
    if minutes is not None and not (math.isfinite(minutes) and minutes > 0):
        raise InputError(f"--max-minutes is {minutes:g}; a time above 0 is accepted.")


def require_writable_folder(folder: Path) -> None:
    """Refuses, before the work is done, a folder that cannot be written after it.

    Raises:
        InputError: It is a file, or it cannot be made or written.
    """
    existing = folder
    try:
        while not existing.exists() and existing != existing.parent:
            existing = existing.parent
        is_folder = existing.is_dir()
    except (OSError, ValueError) as error:
        raise InputError(f"{str(folder)!r} cannot be a folder: {error}. Choose another --out.") from error
    if not is_folder:
        raise InputError(f"'{existing}' is a file, not a folder. Choose another --out.")
    if not os.access(existing, os.W_OK | os.X_OK):
        raise InputError(f"'{existing}' cannot be written to. Choose another --out.")


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
