"""How long something takes, on a machine that may be doing other things too."""

from __future__ import annotations

import time
from collections.abc import Callable
from typing import TypeVar

Result = TypeVar("Result")


def least(run: Callable[[], Result], times: int = 3) -> tuple[float, Result]:
    """Processor seconds of the fastest of several runs, and what the last of them returned."""
    seconds = []
    for _ in range(times):
        started = time.process_time()
        result = run()
        seconds.append(time.process_time() - started)
    return min(seconds), result
