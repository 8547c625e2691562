"""The most memory that this process holds while something runs, where the system tells (Linux)."""

from __future__ import annotations

from pathlib import Path
from types import TracebackType

_STATUS, _RESET = Path("/proc/self/status"), Path("/proc/self/clear_refs")


class PeakMemory:
    """Enter it as often as needed: it remembers the most of all times.

    What was loaded before counts as well: it is what a process needs that does this alone, at most.
    """

    def __init__(self) -> None:
        """Nothing is measured yet."""
        self.mebibytes: int | None = None

    def __enter__(self) -> PeakMemory:
        """Begins anew at what is held now."""
        try:
            _RESET.write_text("5")  # see proc(5)
            self._can = True
        except OSError:
            self._can = False
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        """Takes note of the peak."""
        if self._can:
            now = _peak()
            if now is not None:
                self.mebibytes = max(now, self.mebibytes or 0)


def _peak() -> int | None:
    try:
        lines = _STATUS.read_text().splitlines()
    except OSError:
        return None
    found = [line for line in lines if line.startswith("VmHWM:")]
    return int(found[0].split()[1]) // 1024 if found else None
