"""The folder of a batch: which settings it was made with and what became of each pattern."""

from __future__ import annotations

import json
import os
import shutil
from pathlib import Path
from types import TracebackType
from typing import IO, Any

from swifttailor.atomic_files import write_text
from swifttailor.draping.batch.make_garment import UNFINISHED_PREFIX
from swifttailor.draping.batch.settings import BatchSettings
from swifttailor.errors import InputError
from swifttailor.garment_files.folder import plain

SETTINGS, RESULTS, LOCK = "batch.json", "results.jsonl", ".lock"


class Ledger:
    """Use as a context manager: nobody else can work on the folder meanwhile.

    Each record is on disk before `add` returns, so that a killed batch goes on where it stopped.
    """

    def __init__(self, folder: Path, settings: BatchSettings) -> None:
        """Opens the folder of a batch, or makes it.

        Raises:
            InputError: It holds other things, was made with other settings, or cannot be written.
        """
        self.folder = folder
        self.records: dict[str, dict[str, Any]] = {}
        """The last record of each id."""
        self._settings = settings
        self._stream: IO[bytes] | None = None
        self._lock: IO[bytes] | None = None

    def __enter__(self) -> Ledger:
        try:
            self._check_settings()
            self._lock = _lock(self.folder)
            for unfinished in self.folder.glob(f"{UNFINISHED_PREFIX}*"):
                shutil.rmtree(unfinished, ignore_errors=True)
            self._read_results()
            self._stream = (self.folder / RESULTS).open("ab")
        except OSError as error:
            self._close()
            raise InputError(
                f"The batch folder '{self.folder}' cannot be used: {error.strerror or error}."
            ) from error
        except BaseException:
            self._close()
            raise
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._close()

    def add(self, record: dict[str, Any]) -> None:
        """Writes a record to results.jsonl, all the way to the disk."""
        assert self._stream is not None
        self._stream.write(json.dumps(plain(record), allow_nan=False).encode() + b"\n")
        self._stream.flush()
        os.fsync(self._stream.fileno())
        self.records[record["id"]] = record

    def is_done(self, id: str, *, retry_failed: bool) -> bool:
        """Whether a pattern needs no more work."""
        record = self.records.get(id)
        if record is None:
            return False
        if record["status"] == "failed":
            return not retry_failed
        return (self.folder / record["folder"] / "report.json").is_file()

    def _check_settings(self) -> None:
        identity = self._settings.identity()
        path = self.folder / SETTINGS
        if path.exists():
            before = _read_settings(path)
            if before != identity:
                raise InputError(
                    f"The batch in '{self.folder}' was made with other settings: "
                    f"{_differences(before, identity)}. "
                    "Use the same settings to go on with it, or another --out."
                )
            return
        if self.folder.exists() and any(self.folder.iterdir()):
            raise InputError(
                f"'{self.folder}' is not empty and holds no batch ({SETTINGS} is missing). "
                "Choose a new or empty folder for --out."
            )
        write_text(path, json.dumps({"settings": identity}, indent=2) + "\n")

    def _read_results(self) -> None:
        """Reads what was done before; a last line cut short by a crash is removed."""
        path = self.folder / RESULTS
        if not path.exists():
            return
        sound = 0
        with path.open("rb") as stream:
            for line in stream:
                if not line.endswith(b"\n"):
                    break
                sound += len(line)
                record = _parse_record(line)
                if record is not None:
                    self.records[record["id"]] = record
        if sound < path.stat().st_size:
            os.truncate(path, sound)

    def _close(self) -> None:
        for stream in (self._stream, self._lock):
            if stream is not None:
                stream.close()


def _read_settings(path: Path) -> dict[str, Any]:
    try:
        return dict(json.loads(path.read_text(encoding="utf-8"))["settings"])
    except (ValueError, KeyError, TypeError) as error:
        raise InputError(f"'{path}' is damaged. Choose another --out for this batch.") from error


def _differences(before: dict[str, Any], now: dict[str, Any]) -> str:
    names = [n for n in {**before, **now} if before.get(n) != now.get(n)]
    return ", ".join(f"{n} was {before.get(n)!r}, now {now.get(n)!r}" for n in names)


def _parse_record(line: bytes) -> dict[str, Any] | None:
    """A record, or None where the line is not one: that pattern is then made again."""
    try:
        record = json.loads(line)
    except ValueError:
        return None
    sound = (
        isinstance(record, dict)
        and isinstance(record.get("id"), str)
        and isinstance(record.get("folder"), str)
        and record.get("status") in ("made", "failed")
    )
    return record if sound else None


def _lock(folder: Path) -> IO[bytes]:
    stream = (folder / LOCK).open("wb")
    try:
        import fcntl
    except ImportError:  # Windows: two batches on one folder are not noticed
        return stream
    try:
        fcntl.flock(stream, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except OSError as error:
        stream.close()
        raise InputError(
            f"Another batch is at work in '{folder}'. Wait for it or choose another --out."
        ) from error
    return stream
