"""Progress of long work on many items, with rate and time left; on stderr."""

from __future__ import annotations

import sys
import time
from types import TracebackType
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from rich.progress import Progress, TaskID

_SECONDS_BETWEEN_LINES = 30.0


class BuildProgress:
    """A bar in a terminal; elsewhere a line every half minute and one for each pattern without a sample."""

    def __init__(self, total: int) -> None:
        """Use as a context manager.

        Args:
            total: Patterns in the input, about.
        """
        self._total = total
        self._done_before = 0
        self._done = 0
        self._accepted = 0
        self._started = self._last_line = time.monotonic()
        self._bar: Progress | None = None
        self._task: TaskID | None = None

    def __enter__(self) -> BuildProgress:
        if sys.stderr.isatty():
            from rich.console import Console
            from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn

            columns = BarColumn(), MofNCompleteColumn(), TextColumn("{task.description}")
            self._bar = Progress(*columns, console=Console(stderr=True), transient=True)
            self._task = self._bar.add_task("", total=self._total)
            self._bar.start()
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        if self._bar is not None:
            self._bar.stop()
        if kind is not None and self._done:
            self._note(f"{self._done} done in this run; the same command goes on from here")

    def start(self, done_before: int, note: str) -> None:
        """Says what the build starts from."""
        from swifttailor.draping.compiled_code import COMPILE_NOTE, solver_is_compiled

        self._done_before = done_before
        self._started = self._last_line = time.monotonic()
        if done_before:
            self._note(f"going on: {done_before} were done before")
        if note:
            self._note(note)
        if not solver_is_compiled():
            self._note(COMPILE_NOTE)

    def show(self, record: dict[str, Any]) -> None:
        """Takes note of a pattern that is done."""
        self._done += 1
        self._accepted += record["status"] == "accepted"
        if record["status"] != "accepted":
            self._note(f"{record['id']}: {record['status']}: {'; '.join(record['reasons'])}")
        if self._bar is not None and self._task is not None:
            self._bar.update(
                self._task, completed=self._done_before + self._done, description=self.describe()
            )
        elif (
            time.monotonic() - self._last_line >= _SECONDS_BETWEEN_LINES
            or self._done_before + self._done == self._total
        ):
            self._last_line = time.monotonic()
            self._note(f"{self._done_before + self._done}/{self._total} {self.describe()}")

    def describe(self) -> str:
        """Rate, share of accepted patterns and time left, in this run."""
        seconds = max(time.monotonic() - self._started, 1e-3)
        rate = self._done / seconds
        left = max(self._total - self._done_before - self._done, 0)
        return (
            f"{rate * 60:.1f} a minute, {self._accepted / self._done:.0%} accepted, "
            f"{_duration(left / rate)} left"
        )

    def _note(self, text: str) -> None:
        if self._bar is not None:
            self._bar.console.print(text, markup=False, highlight=False)
        else:
            sys.stderr.write(text + "\n")
            sys.stderr.flush()


def _duration(seconds: float) -> str:
    minutes = round(seconds / 60)
    return f"{minutes // 60} h {minutes % 60:02d} min" if minutes >= 60 else f"{minutes} min"
