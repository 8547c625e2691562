"""What a worker has done so far, in memory that outlives it."""

from __future__ import annotations

import mmap
import struct
from dataclasses import dataclass
from pathlib import Path

_LAYOUT = struct.Struct("<4q")


@dataclass(frozen=True)
class Tally:
    """Counts of one worker."""

    at: int = -1
    """The number of the input that is being read; -1 while the reader is loaded."""
    accepted: int = 0
    refused: int = 0
    failed: int = 0


class SharedTally:
    """A `Tally` in a small file that two processes see at once."""

    def __init__(self, path: Path) -> None:
        """Opens the file; it is made when missing."""
        if not path.exists():
            path.write_bytes(_LAYOUT.pack(-1, 0, 0, 0))
        with path.open("r+b") as file:
            self._memory = mmap.mmap(file.fileno(), _LAYOUT.size)

    def read(self) -> Tally:
        """The counts now."""
        return Tally(*_LAYOUT.unpack(self._memory[:]))

    def write(self, tally: Tally) -> None:
        """Replaces the counts."""
        self._memory[:] = _LAYOUT.pack(tally.at, tally.accepted, tally.refused, tally.failed)
