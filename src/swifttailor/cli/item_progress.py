"""Progress of work on many items that say nothing about themselves; on stderr."""

from __future__ import annotations

import time

from swifttailor.cli.progress import CountProgress

_SECONDS_BETWEEN_LINES = 30.0


class ItemProgress(CountProgress):
    """A bar in a terminal, a line every half minute elsewhere."""

    def __init__(self, total: int, what: str) -> None:
        """Use as a context manager.

        Args:
            total: How many items there are.
            what: Their name, in the plural.
        """
        super().__init__(total)
        self._what = what
        self._last_line = time.monotonic()

    def add(self, count: int) -> None:
        """Takes note of more that are done."""
        self.done += count
        if not self.advance(self._what) and time.monotonic() - self._last_line >= _SECONDS_BETWEEN_LINES:
            self._last_line = time.monotonic()
            self.note(f"{self.done}/{self._total} {self._what}")
