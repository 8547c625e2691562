"""Work in another thread beside what this one does: for networks, which let go of the interpreter."""

from __future__ import annotations

import time
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from functools import cache
from typing import ParamSpec, TypeVar

_TAKEN_OVER = 5e-5
"""Seconds in which the other thread begins."""
P = ParamSpec("P")
T = TypeVar("T")


def beside(call: Callable[P, T], *args: P.args, **named: P.kwargs) -> Callable[[], T]:
    """Begins a call, and gives what waits for its result.

    Args:
        call: Must not begin another one beside itself: there is a single thread.
        *args: Of the call.
        **named: Of the call.

    Returns:
        What gives the result, or raises what the call raised.
    """
    result = _thread().submit(call, *args, **named).result
    time.sleep(_TAKEN_OVER)  # else the interpreter is kept for its switch interval of 5 ms
    return result


@cache
def _thread() -> ThreadPoolExecutor:
    return ThreadPoolExecutor(1, thread_name_prefix="beside")
