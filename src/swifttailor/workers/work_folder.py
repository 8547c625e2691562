"""What makes work on a folder resumable: lines that survive a crash, and the same settings."""

from __future__ import annotations

import json
import os
from abc import ABC, abstractmethod
from collections.abc import Generator, Iterator
from contextlib import contextmanager
from pathlib import Path
from types import TracebackType
from typing import Any, Self

from swifttailor.atomic_files import disk_full, is_disk_full
from swifttailor.errors import DiskFullError, InputError
from swifttailor.output_folder import FolderLock

_START_AGAIN = (
    "Make room, and start the same command again: what is done is kept, and it goes on with the rest."
)


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
            InputError: The file cannot be written.
            DiskFullError: There is no room for it.
        """
        line = json.dumps(record, allow_nan=False).encode() + b"\n"
        try:
            self._stream.write(line)
            self._stream.flush()
            os.fsync(self._stream.fileno())
        except OSError as error:
            if is_disk_full(error):
                raise disk_full(self.path) from error
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
    """A folder that one process at a time works on; use as a context manager.

    Where the disk is full, the error that leaves it says how to go on.
    """

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
            if is_disk_full(error):
                raise _to_go_on(disk_full(self.folder)) from error
            raise InputError(
                f"The folder '{self.folder}' cannot be used: {error.strerror or error}."
            ) from error
        except BaseException as error:
            self._close()
            if isinstance(error, DiskFullError):
                raise _to_go_on(error) from error
            raise
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._close()
        if isinstance(error, DiskFullError):
            raise _to_go_on(error) from error

    @abstractmethod
    def _open(self) -> None:
        """Takes the lock and opens the records, setting `_lock` and `_file`."""

    def _close(self) -> None:
        if self._file is not None:
            self._file.close()
        if self._lock is not None:
            self._lock.release()


@contextmanager
def saying_how_to_go_on() -> Generator[None]:
    """Lets the error of a full disk say that the same command resumes, for work that does."""
    try:
        yield
    except DiskFullError as error:
        raise _to_go_on(error) from error


def _to_go_on(error: DiskFullError) -> DiskFullError:
    said = str(error)
    return DiskFullError(said if said.endswith(_START_AGAIN) else f"{said} {_START_AGAIN}")


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
            except (ValueError, RecursionError):
                continue
            if isinstance(record, dict):
                yield record
    if sound < path.stat().st_size:
        os.truncate(path, sound)
