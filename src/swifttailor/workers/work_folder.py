"""What makes work on a folder resumable: lines that survive a crash, and the same settings."""

from __future__ import annotations

import json
import os
from abc import ABC, abstractmethod
from collections.abc import Iterator
from pathlib import Path
from types import TracebackType
from typing import Any, Self

from swifttailor.errors import InputError
from swifttailor.output_folder import FolderLock


class RecordFile:
    """JSON lines that are only ever appended, each on disk before `add` returns."""

    def __init__(self, path: Path) -> None:
        """Opens the file, or makes it; a last line cut short by a crash is removed.

        Raises:
            OSError: It cannot be read or written.
        """
        self.path = path
        self.found = list(_read_records(path))
        """The records of earlier runs, in order. Lines that are no JSON objects are left out."""
        self._stream = path.open("ab")

    def add(self, record: dict[str, Any]) -> None:
        """Writes a record, all the way to the disk.

        Args:
            record: JSON values.

        Raises:
            InputError: The disk is full, or the file cannot be written for another reason.
        """
        line = json.dumps(record, allow_nan=False).encode() + b"\n"
        try:
            self._stream.write(line)
            self._stream.flush()
            os.fsync(self._stream.fileno())
        except OSError as error:
            raise InputError(
                f"Cannot write '{self.path}': {error.strerror or error}. "
                "What was done so far is kept; the same command goes on with it."
            ) from error

    def close(self) -> None:
        """Closes the file."""
        try:
            self._stream.close()
        except OSError:  # a full disk, which `add` has reported
            pass


class WorkFolder(ABC):
    """A folder that one process at a time works on; use as a context manager."""

    def __init__(self, folder: Path) -> None:
        """Nothing is touched before the context is entered."""
        self.folder = folder
        self._file: RecordFile | None = None
        self._lock: FolderLock | None = None

    def __enter__(self) -> Self:
        try:
            self._open()
        except OSError as error:
            self._close()
            raise InputError(
                f"The folder '{self.folder}' cannot be used: {error.strerror or error}."
            ) from error
        except BaseException:
            self._close()
            raise
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._close()

    @abstractmethod
    def _open(self) -> None:
        """Takes the lock and opens the records, setting `_lock` and `_file`."""

    def _close(self) -> None:
        if self._file is not None:
            self._file.close()
        if self._lock is not None:
            self._lock.release()


def differences(before: dict[str, Any], now: dict[str, Any]) -> str:
    """In words what differs between two settings; empty when they are the same."""
    names = [n for n in {**before, **now} if before.get(n) != now.get(n)]
    return ", ".join(f"{n} was {before.get(n)!r}, now {now.get(n)!r}" for n in names)


def _read_records(path: Path) -> Iterator[dict[str, Any]]:
    if not path.exists():
        return
    sound = 0
    with path.open("rb") as stream:
        for line in stream:
            if not line.endswith(b"\n"):
                break
            sound += len(line)
            try:
                record = json.loads(line)
            except ValueError:
                continue
            if isinstance(record, dict):
                yield record
    if sound < path.stat().st_size:
        os.truncate(path, sound)
