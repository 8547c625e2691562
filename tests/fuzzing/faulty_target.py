"""A target that fails in every way there is, by the number in its input."""

from __future__ import annotations

import os
import signal
import time
from pathlib import Path

from fuzzing.target import File, Target
from swifttailor.errors import InputError

KINDS = ("accepted", "refused", "raises", "talks", "dies", "hangs", "grows", "exits")


def _seeds():
    return [File(b"accepted", ".txt")]


def _mutate(file, random):
    return random.choice(KINDS).encode() + b" " * random.randrange(9)


def _load():
    def feed(path: Path) -> None:
        kind = path.read_text().strip()
        if kind == "refused":
            raise InputError("it is refused")
        if kind == "raises":
            raise KeyError(kind)
        if kind == "talks":
            raise LongError("x" * 5000)
        if kind == "dies":
            os.kill(os.getpid(), signal.SIGSEGV)
        if kind == "exits":
            os._exit(3)
        while kind == "hangs":
            pass
        while kind == "waits":
            time.sleep(9)
        if kind == "grows":
            bytearray(10**12)

    return feed


class LongError(InputError):
    def __str__(self) -> str:
        return "x" * 5000


TARGETS = (Target("faulty", "fails", _seeds, _mutate, _load, seconds=0.3, megabytes=100),)
