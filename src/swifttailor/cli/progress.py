"""Progress on stderr: a moving bar in a terminal, lines elsewhere."""

from __future__ import annotations

import sys
from abc import ABC, abstractmethod
from types import TracebackType
from typing import TYPE_CHECKING, Self

if TYPE_CHECKING:
    from rich.progress import Progress, ProgressColumn, TaskID


def print_line(text: str) -> None:
    """Prints what a command has to say to standard output, at once."""
    print(text, flush=True)  # noqa: T201


class StderrBar(ABC):
    """A bar while standard error is a terminal, and lines that stay; use as a context manager."""

    def __init__(self) -> None:
        self._bar: Progress | None = None

    def __enter__(self) -> Self:
        if sys.stderr.isatty():
            from rich.console import Console
            from rich.progress import Progress

            self._bar = Progress(*self._columns(), console=Console(stderr=True), transient=True)
            self._bar.start()
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        if self._bar is not None:
            self._bar.stop()

    def note(self, text: str) -> None:
        """Prints a line that stays."""
        if self._bar is not None:
            self._bar.console.print(text, markup=False, highlight=False)
        else:
            sys.stderr.write(text + "\n")
            sys.stderr.flush()

    @abstractmethod
    def _columns(self) -> tuple[ProgressColumn, ...]:
        """What the bar shows."""


class StageProgress(StderrBar):
    """Shows the stages of one drape; called with (stage, share done)."""

    def __init__(self) -> None:
        super().__init__()
        self._task: TaskID | None = None
        self._stage = ""

    def _columns(self) -> tuple[ProgressColumn, ...]:
        from rich.progress import BarColumn, TextColumn, TimeElapsedColumn

        return TextColumn("{task.description:<10}"), BarColumn(), TimeElapsedColumn()

    def __call__(self, stage: str, share: float) -> None:
        """Takes note of how far a stage has come."""
        if self._bar is None:
            if stage != self._stage:
                self._stage = stage
                self.note(f"{stage} ...")
            return
        if stage != self._stage or self._task is None:
            self._stage = stage
            self._finish_task()
            self._task = self._bar.add_task(stage, total=1.0)
        self._bar.update(self._task, completed=min(max(share, 0.0), 1.0))

    def _finish_task(self) -> None:
        if self._bar is not None and self._task is not None:
            self._bar.update(self._task, completed=1.0)


class CountProgress(StderrBar):
    """Shows how many of many items are done; what is said about each is up to the kinds of it."""

    def __init__(self, total: int) -> None:
        """Makes it ready.

        Args:
            total: Items in all, about.
        """
        super().__init__()
        self.done = 0
        """Items done in this run."""
        self._total = total
        self._done_before = 0
        self._task: TaskID | None = None

    def __enter__(self) -> Self:
        super().__enter__()
        if self._bar is not None:
            self._task = self._bar.add_task("", total=self._total)
        return self

    def _columns(self) -> tuple[ProgressColumn, ...]:
        from rich.progress import BarColumn, MofNCompleteColumn, TextColumn, TimeRemainingColumn

        description = TextColumn("{task.description}")
        return BarColumn(), MofNCompleteColumn(), TimeRemainingColumn(), description

    def begin(self, done_before: int, *, compiled: bool) -> None:
        """Says what the work starts from."""
        from swifttailor.draping.compiled_code import COMPILE_NOTE

        self._done_before = done_before
        if done_before:
            self.note(f"going on: {done_before} were done before")
        if not compiled:
            self.note(COMPILE_NOTE)

    @property
    def position(self) -> int:
        """Items done, those of earlier runs included."""
        return self._done_before + self.done

    def advance(self, description: str) -> bool:
        """Moves the bar to `position`; returns whether there is one."""
        if self._bar is None or self._task is None:
            return False
        self._bar.update(self._task, completed=self.position, description=description)
        return True
