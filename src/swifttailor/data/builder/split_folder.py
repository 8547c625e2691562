"""The folder of a split while it is being built: what is done survives any end of the program.

Patterns have positions in the input, and a shard is made from a fixed range of them. An accepted sample is a
file of its own in .samples/ until all of its range is done; then the range is sealed: the shard is written,
index.json names it, and only then do the files of its samples go.
"""

from __future__ import annotations

import hashlib
import re
import sys
from dataclasses import replace
from pathlib import Path
from typing import Any

from swifttailor.data.builder.code_version import code_version
from swifttailor.data.builder.make_sample import ACCEPTED, FAILED, REJECTED, MadeSample
from swifttailor.data.builder.settings import BuildSettings
from swifttailor.data.index import INDEX, Rejected, Shard, SplitIndex, read_index
from swifttailor.data.shard_file import ShardFile, pack_sample, unpack_sample, write_durably, write_shard
from swifttailor.errors import InputError
from swifttailor.output_folder import LOCK, FolderLock
from swifttailor.workers.work_folder import RecordFile, WorkFolder, differences

RESULTS, SAMPLES = "results.jsonl", ".samples"
_SHARD = re.compile(r"shard-\d{5}-[0-9a-f]{12}\.safetensors")


class SplitFolder(WorkFolder):
    """Use as a context manager: nobody else can build the split meanwhile."""

    def __init__(self, folder: Path, settings: BuildSettings) -> None:
        """Nothing is touched before the context is entered.

        Args:
            folder: Of the split; made when missing. Its name is the split's.
            settings: What the samples are made with.
        """
        super().__init__(folder)
        self.records: dict[int, dict[str, Any]] = {}
        """The last record of each position whose range is not sealed."""
        self.index = SplitIndex(folder.name, settings.identity())
        self.shard_size = settings.shard_size
        self._shards: dict[int, Shard] = {}
        self._other_code = False

    def _open(self) -> None:
        self._lock = FolderLock(self.folder, "build")
        self._require_own_folder()
        self._open_index()
        (self.folder / SAMPLES).mkdir(exist_ok=True)
        self._file = RecordFile(self.folder / RESULTS)
        self.records |= {r["position"]: r for r in self._file.found if _is_record(r)}
        self._clean_up()

    @property
    def made_by_other_code(self) -> dict[str, str] | None:
        """The code that worked on the folder before, where it is not the present one."""
        return self.index.built_with[-2] if self._other_code else None

    def shard(self, number: int) -> Shard | None:
        """The sealed shard of a range, if it is sealed."""
        return self._shards.get(number)

    def number_of_done(self, *, limit: int | None = None, retry_failed: bool = False) -> int:
        """Patterns that need no more work.

        Args:
            limit: Only the first so many are counted.
            retry_failed: Whether those that failed are to be tried again.
        """
        last = limit if limit is not None else sys.maxsize
        sealed = sum(max(0, min(s.last, last) - s.first) for s in self._shards.values())
        again = sum(
            r.status == FAILED and r.position < last for s in self._shards.values() for r in s.rejected
        )
        single = sum(
            p < last
            and self._sealed_over(p) is None
            and self._is_kept(p)
            and not (retry_failed and self.records[p]["status"] == FAILED)
            for p in self.records
        )
        return sealed + single - again * retry_failed

    def is_done(self, position: int, checksum: str, *, retry_failed: bool) -> bool:
        """Whether a pattern of an open range needs no more work.

        Raises:
            InputError: Another pattern was at this place before.
        """
        record = self.records.get(position)
        if record is None:
            return False
        if record["checksum"] not in ("", checksum):
            raise self.other_input(position, position + 1)
        if record["status"] == FAILED and retry_failed:
            return False
        return self._is_kept(position)

    def keep(self, made: MadeSample) -> None:
        """Puts what a worker has handed back on the disk, the sample first.

        Raises:
            InputError: The disk is full, or a file cannot be written for another reason.
        """
        assert self._file is not None
        if self._other_code:
            self.index.save(self.folder)
            self._other_code = False
        record = made.record
        if record["status"] == ACCEPTED:
            write_durably(self._sample_path(record["position"]), made.data)
        self._file.add(record)
        self.records[record["position"]] = record

    def seal(self, number: int, checksums: list[str]) -> Shard:
        """Writes the shard of a range all of whose patterns are done.

        Args:
            number: Of the range.
            checksums: Of its patterns, in order; fewer than `shard_size` for the last range.

        Raises:
            InputError: A file cannot be written or read. Nothing that was built is lost.
        """
        first = number * self.shard_size
        records = [self.records[first + k] for k in range(len(checksums))]
        accepted = [r for r in records if r["status"] == ACCEPTED]
        samples = [unpack_sample(self._sample_path(r["position"])) for r in accepted]
        path, checksum = None, ""
        if samples:
            path, checksum = write_shard(self.folder, f"shard-{number:05d}", samples)
        before = self._shards.get(number)
        self._shards[number] = Shard(
            first=first,
            last=first + len(records),
            file=path.name if path else "",
            sha256=checksum,
            bytes=path.stat().st_size if path else 0,
            input_sha256=input_checksum(checksums),
            ids=tuple(r["id"] for r in accepted),
            rejected=tuple(
                Rejected(r["position"], r["id"], r["status"], tuple(r["reasons"]))
                for r in records
                if r["status"] != ACCEPTED
            ),
        )
        self._save_index(complete=False)
        if before is not None and before.file and before.file != self._shards[number].file:
            (self.folder / before.file).unlink(missing_ok=True)
        for record in records:
            self._sample_path(record["position"]).unlink(missing_ok=True)
            del self.records[record["position"]]
        return self._shards[number]

    def reopen(self, number: int) -> None:
        """Brings a sealed range back to single samples, so that it can grow or failures be tried again.

        The sealed shard stays valid until `seal` replaces it.
        """
        shard = self._shards[number]
        if shard.file:
            stored = ShardFile(self.folder / shard.file, shard.sha256)
            for k, (position, id) in enumerate(zip(shard.positions, shard.ids, strict=True)):
                write_durably(self._sample_path(position), pack_sample(stored[k]))
                self.records[position] = _record(position, id, ACCEPTED, [])
        for r in shard.rejected:
            self.records[r.position] = _record(r.position, r.id, r.status, list(r.reasons))

    def finish(self) -> None:
        """Notes that all of the input is done."""
        if not self.index.complete:
            self._save_index(complete=True)

    def other_input(self, first: int, last: int) -> InputError:
        """The error for patterns that differ from those that were built before."""
        place = f"pattern {first + 1}" if last == first + 1 else f"patterns {first + 1} to {last}"
        return InputError(
            f"The input differs from the one that '{self.folder}' was built from ({place}). "
            "Give the same files in the same order; more may follow at the end. "
            "For other patterns choose another --out or --split."
        )

    def _sample_path(self, position: int) -> Path:
        return self.folder / SAMPLES / f"{position:08d}.safetensors"

    def _is_kept(self, position: int) -> bool:
        return self.records[position]["status"] != ACCEPTED or self._sample_path(position).is_file()

    def _sealed_over(self, position: int) -> Shard | None:
        shard = self._shards.get(position // self.shard_size)
        return shard if shard is not None and position < shard.last else None

    def _require_own_folder(self) -> None:
        if not (self.folder / INDEX).exists() and {p.name for p in self.folder.iterdir()} - {LOCK}:
            raise InputError(
                f"'{self.folder}' is not empty and holds no split ({INDEX} is missing). "
                "Choose another --out or --split."
            )

    def _open_index(self) -> None:
        now = code_version()
        if not (self.folder / INDEX).exists():
            self.index = replace(self.index, built_with=(now,))
            self.index.save(self.folder)
            return
        found = read_index(self.folder)
        if found.settings != self.index.settings:
            raise InputError(
                f"'{self.folder}' was built with other settings: "
                f"{differences(found.settings, self.index.settings)}. "
                "Use the same settings to go on with it, or another --out."
            )
        self._shards = {s.first // self.shard_size: s for s in found.shards}
        self._other_code = found.built_with[-1:] != (now,)
        self.index = replace(found, built_with=(*found.built_with, now)) if self._other_code else found

    def _save_index(self, *, complete: bool) -> None:
        self.index = self.index.with_shards(list(self._shards.values()), complete=complete)
        self.index.save(self.folder)

    def _clean_up(self) -> None:
        """Removes what a killed run left: shards that no index names, samples that are in a shard."""
        named = {s.file for s in self._shards.values()}
        for path in self.folder.glob("shard-*.safetensors"):
            if path.name not in named and _SHARD.fullmatch(path.name):
                path.unlink()
        for pattern in (".index-*", ".shard-*", f"{SAMPLES}/.*"):  # half-written (`write_atomically`)
            for path in self.folder.glob(pattern):
                path.unlink()
        for position in [p for p in self.records if self._sealed_over(p) is not None]:
            del self.records[position]
        for path in (self.folder / SAMPLES).glob("*.safetensors"):
            if path.stem.isdecimal() and self._sealed_over(int(path.stem)) is not None:
                path.unlink()


def input_checksum(checksums: list[str]) -> str:
    """Checksum of consecutive patterns, from their own."""
    return hashlib.sha256("\n".join(checksums).encode()).hexdigest()


def _record(position: int, id: str, status: str, reasons: list[str]) -> dict[str, Any]:
    return {"position": position, "id": id, "status": status, "reasons": reasons, "checksum": ""}


def _is_record(value: dict[str, Any]) -> bool:
    """Whether a line is a record; the pattern of any other is made again."""
    kinds: dict[str, type] = {"position": int, "id": str, "checksum": str, "reasons": list}
    return value.get("status") in (ACCEPTED, REJECTED, FAILED) and all(
        isinstance(value.get(name), kind) for name, kind in kinds.items()
    )
