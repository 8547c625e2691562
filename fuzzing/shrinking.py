"""Smaller inputs that fail in the same way, as far as that is cheap."""

from __future__ import annotations

import json
import time
from collections.abc import Callable, Iterator
from typing import Any

_TRIES = 400
_SECONDS = 20.0


def shrunk(data: bytes, fails: Callable[[bytes], bool]) -> bytes:
    """The smallest input that was found: entries of JSON are left out, or stretches of bytes.

    Args:
        data: The input that fails.
        fails: Whether another one fails in the same way.
    """
    ends = time.process_time() + _SECONDS
    tries = 0

    def still(candidate: bytes) -> bool:
        nonlocal tries
        tries += 1
        return tries <= _TRIES and time.process_time() < ends and fails(candidate)

    try:
        value = json.loads(data)
    except (ValueError, RecursionError):
        return _fewer_bytes(data, still)
    if not isinstance(value, dict | list) or not still(json.dumps(value).encode()):
        return _fewer_bytes(data, still)
    try:
        return json.dumps(_fewer_entries(value, still)).encode()
    except RecursionError:
        return data


def _fewer_entries(value: Any, still: Callable[[bytes], bool]) -> Any:
    """Leaves out entries, outermost first, as long as one can be spared."""
    again = True
    while again:
        again = False
        for holder, key in list(_places(value)):
            if isinstance(holder, dict) and key in holder:
                kept = dict(holder)
                del holder[key]
                if still(json.dumps(value).encode()):
                    again = True
                else:
                    holder.clear()
                    holder.update(kept)
            elif isinstance(holder, list) and key < len(holder):
                kept_list = list(holder)
                del holder[key]
                if still(json.dumps(value).encode()):
                    again = True
                else:
                    holder[:] = kept_list
    return value


def _places(value: Any) -> Iterator[tuple[Any, Any]]:
    level = [value]
    while level:
        inner = []
        for holder in level:
            # From the back, so that leaving one entry of a list out does not move those still to come.
            keys = list(holder) if isinstance(holder, dict) else list(range(len(holder)))[::-1]
            for key in keys:
                yield holder, key
            inner += [holder[k] for k in keys if isinstance(holder[k], dict | list)]
        level = inner


def _fewer_bytes(data: bytes, still: Callable[[bytes], bool]) -> bytes:
    """Leaves out halves, quarters, eighths, ... of the bytes."""
    size = len(data) // 2
    while size >= 1:
        start = 0
        while start < len(data):
            candidate = data[:start] + data[start + size :]
            if still(candidate):
                data = candidate
            else:
                start += size
        size //= 2
    return data
