"""Progress on stderr: a moving bar in a terminal, a line per stage elsewhere."""

from __future__ import annotations

import sys
from types import TracebackType
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from rich.progress import Progress, TaskID


class StageProgress:
    """Shows the stages of one drape; use as a context manager and call with (stage, share done)."""

    def __init__(self) -> None:
        self._bar: Progress | None = None
        self._task: TaskID | None = None
        self._stage = ""

    def __enter__(self) -> StageProgress:
        if sys.stderr.isatty():
            from rich.console import Console
            from rich.progress import BarColumn, Progress, TextColumn, TimeElapsedColumn

            columns = TextColumn("{task.description:<10}"), BarColumn(), TimeElapsedColumn()
            self._bar = Progress(*columns, console=Console(stderr=True), transient=True)
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
