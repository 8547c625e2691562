"""The folder of a batch: which settings it was made with and what became of each pattern."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

from swifttailor.atomic_files import write_text
from swifttailor.draping.batch.settings import BatchSettings
from swifttailor.errors import InputError
from swifttailor.garment.folder import plain
from swifttailor.output_folder import LOCK, FolderLock, OutputFolder
from swifttailor.workers.work_folder import RecordFile, WorkFolder, differences

SETTINGS, RESULTS, SUMMARY = "batch.json", "results.jsonl", "summary.json"


class Ledger(WorkFolder):
    """Use as a context manager: nobody else can work on the folder meanwhile.

    Each record is on disk before `add` returns, so that a killed batch goes on where it stopped.
    """

    def __init__(self, folder: Path, settings: BatchSettings, *, overwrite: bool = False) -> None:
        """Nothing is touched before the context is entered, which refuses a folder of other things.

        Args:
            folder: Of the batch; made when missing.
            settings: What the garments are made with.
            overwrite: Whether files in it are replaced that were changed by somebody else.
        """
        super().__init__(folder)
        self.output = OutputFolder(folder, overwrite=overwrite)
        """For what is said of the whole batch."""
        self.records: dict[str, dict[str, Any]] = {}
        """The last record of each id."""
        self._settings, self._overwrite = settings, overwrite
        self._changed: dict[str, list[str]] = {}

    def _open(self) -> None:
        self._lock = FolderLock(self.folder, "batch")
        self._check_settings()
        self.output.require_own([SUMMARY])
        self._file = RecordFile(self.folder / RESULTS)
        self.records |= {r["id"]: r for r in self._file.found if _is_record(r)}

    def add(self, record: dict[str, Any]) -> None:
        """Writes a record to results.jsonl, all the way to the disk."""
        assert self._file is not None
        self._file.add(plain(record))
        self.records[record["id"]] = record

    def is_done(self, id: str, *, retry_failed: bool) -> bool:
        """Whether a pattern needs no more work."""
        record = self.records.get(id)
        if record is None:
            return False
        if record["status"] == "failed":
            return not retry_failed
        if not (self.folder / record["folder"] / "report.json").is_file():
            return False
        # Who has changed a file may want to keep it: it is made again only where that was asked for.
        return not (self._overwrite and self.changed(id))

    def changed(self, id: str) -> list[str]:
        """Files of a garment from an earlier call that are not as they were written.

        Reading them takes a few milliseconds, making them seconds.
        """
        if id not in self._changed:
            self._changed[id] = OutputFolder(self.folder / self.records[id]["folder"]).changed()
        return self._changed[id]

    def _check_settings(self) -> None:
        identity = self._settings.identity()
        path = self.folder / SETTINGS
        if path.exists():
            before = _read_settings(path)
            if before != identity:
                raise InputError(
                    f"The batch in '{self.folder}' was made with other settings: "
                    f"{differences(before, identity)}. "
                    "Use the same settings to go on with it, or another --out."
                )
            return
        if any(path.name != LOCK for path in self.folder.iterdir()):
            raise InputError(
                f"'{self.folder}' is not empty and holds no batch ({SETTINGS} is missing). "
                "Choose a new or empty folder for --out."
            )
        write_text(path, json.dumps({"settings": identity}, indent=2) + "\n")


def _read_settings(path: Path) -> dict[str, Any]:
    try:
        return dict(json.loads(path.read_text(encoding="utf-8"))["settings"])
    except (ValueError, KeyError, TypeError, RecursionError) as error:
        raise InputError(f"'{path}' is damaged. Choose another --out for this batch.") from error


def _is_record(value: dict[str, Any]) -> bool:
    """Whether a line is a record; the pattern of any other is made again."""
    return (
        isinstance(value.get("id"), str)
        and isinstance(value.get("folder"), str)
        and value.get("status") in ("made", "failed")
    )
