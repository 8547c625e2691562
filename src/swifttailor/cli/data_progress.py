"""Progress of building a data set, with rate and time left; on stderr."""

from __future__ import annotations

import time
from types import TracebackType
from typing import Any

from swifttailor.cli.progress import CountProgress

_SECONDS_BETWEEN_LINES = 30.0


class BuildProgress(CountProgress):
    """A bar in a terminal; elsewhere a line every half minute and one for each pattern without a sample."""

    def __init__(self, total: int, *, drapes: bool = True) -> None:
        """Use as a context manager.

        Args:
            total: Patterns in all, about.
            drapes: Whether they are draped, which the solver may have to be compiled for.
        """
        super().__init__(total)
        self._drapes = drapes
        self._accepted = 0
        self._started = self._last_line = time.monotonic()

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        super().__exit__(kind, error, trace)
        if kind is not None and self.done:
            self.note(f"{self.done} done in this run; the same command goes on from here")

    def start(self, done_before: int, note: str) -> None:
        """Says what the build starts from."""
        from swifttailor.draping.compiled_code import solver_is_compiled

        self._started = self._last_line = time.monotonic()
        self.begin(done_before, compiled=not self._drapes or solver_is_compiled())
        if note:
            self.note(note)

    def show(self, record: dict[str, Any]) -> None:
        """Takes note of a pattern that is done."""
        self.done += 1
        self._accepted += record["status"] == "accepted"
        if record["status"] != "accepted":
            self.note(f"{record['id']}: {record['status']}: {'; '.join(record['reasons'])}")
        if self.advance(self.describe()):
            return
        now = time.monotonic()
        if now - self._last_line >= _SECONDS_BETWEEN_LINES or self.position == self._total:
            self._last_line = now
            self.note(f"{self.position}/{self._total} {self.describe()}")

    def describe(self) -> str:
        """Rate, share of accepted patterns and time left, in this run."""
        seconds = max(time.monotonic() - self._started, 1e-3)
        rate = self.done / seconds
        left = max(self._total - self.position, 0)
        return (
            f"{rate * 60:.1f} a minute, {self._accepted / self.done:.0%} accepted, "
            f"{_duration(left / rate)} left"
        )


def _duration(seconds: float) -> str:
    minutes = round(seconds / 60)
    return f"{minutes // 60} h {minutes % 60:02d} min" if minutes >= 60 else f"{minutes} min"
