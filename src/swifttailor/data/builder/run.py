"""Builds a split: patterns to shards, so that it can be interrupted at any moment and go on."""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Generator, Iterable, Iterator
from dataclasses import dataclass, field, replace
from itertools import islice
from pathlib import Path
from typing import Any

from swifttailor.atomic_files import disk_full
from swifttailor.data.builder.make_sample import (
    FAILED,
    REJECTED,
    MadeSample,
    SampleTask,
    make_sample,
    not_made,
)
from swifttailor.data.builder.other_splits import OtherSplits
from swifttailor.data.builder.settings import BuildSettings
from swifttailor.data.builder.split_folder import SplitFolder, input_checksum
from swifttailor.data.index import SplitIndex
from swifttailor.draping.batch.make_garment import DISK_FULL
from swifttailor.errors import InputError
from swifttailor.pattern.pattern_list import BatchPattern
from swifttailor.workers import Outcome, sigterm_as_interrupt

Runner = Callable[[Callable[[Any], Any], Iterable[Any]], Generator[Outcome]]
"""Runs a function on tasks: `workers.run_tasks` or `workers.ray_pool.run_tasks_on_ray` with its settings."""
OnStart = Callable[[int, str], None]
OnRecord = Callable[[dict[str, Any]], None]

TIME_LIMIT = 600.0
ATTEMPTS = 3


def build_split(
    patterns: Iterator[BatchPattern],
    out: Path,
    split: str,
    settings: BuildSettings,
    *,
    runner: Runner,
    limit: int | None = None,
    retry_failed: bool = False,
    on_start: OnStart | None = None,
    on_record: OnRecord | None = None,
    make: Callable[[SampleTask], MadeSample] = make_sample,
) -> SplitIndex:
    """Drapes patterns and puts those that pass the quality gate into shards.

    Each sample is on the disk before its worker gets the next pattern: after any interruption the same call
    goes on where it stopped. The shards depend on the input and the settings alone, not on `runner`.

    Args:
        patterns: All patterns of the split, in an order that stays; from `read_patterns`.
        out: Folder of the data set; the split gets a folder in it.
        split: Its name (train, validation, test).
        settings: What the samples are made with.
        runner: Runs the drapes.
        limit: Only the first so many patterns.
        retry_failed: Try again what crashed or took too long in an earlier call.
        on_start: Called with the number of patterns done before, and a note or "".
        on_record: Called with each new record.
        make: Makes one sample (for tests).

    Returns:
        The index of the split.

    Raises:
        InputError: The patterns, the settings or the folder cannot be used; the input has changed since an
            earlier call.
        DiskFullError: There is no room for a sample; the same call goes on with it and the rest.
        SimulationError: No worker can be started.
        KeyboardInterrupt: After Ctrl-C or SIGTERM.
    """
    patterns = islice(patterns, limit)
    first = next(patterns, None)  # so that a source that cannot be read leaves no folder behind
    if first is None:
        raise InputError("There are no patterns in the input. Give one pattern a line, or a folder of them.")
    settings.drape.require_usable()
    others = OtherSplits.read(out, split)
    with SplitFolder(out / split, settings) as folder:
        if on_start is not None:
            on_start(folder.number_of_done(limit=limit, retry_failed=retry_failed), _note(folder))
        work = _Work(folder, settings, others, retry_failed=retry_failed, on_record=on_record)
        outcomes = runner(make, work.tasks(_chain(first, patterns)))
        try:
            with sigterm_as_interrupt():
                for outcome in outcomes:
                    made = not_made(outcome.task, FAILED, outcome.lost) if outcome.lost else outcome.result
                    if made.record["status"] == DISK_FULL:
                        raise disk_full(folder.folder)
                    work.take_in(made)
        finally:
            outcomes.close()
        folder.finish()
        return folder.index


@dataclass
class _Range:
    """Consecutive patterns that become one shard."""

    checksums: list[str] = field(default_factory=list)
    """Of its patterns, as far as they have been read."""
    missing: set[int] = field(default_factory=set)
    """Positions that are being worked on."""
    is_open: bool = False
    """Whether it has to be sealed, now or again."""
    is_read: bool = False
    """Whether all of its patterns have been read."""


class _Work:
    """Between the input and the folder: which patterns are to be draped, and which ranges sealed."""

    def __init__(
        self,
        folder: SplitFolder,
        settings: BuildSettings,
        others: OtherSplits,
        *,
        retry_failed: bool,
        on_record: OnRecord | None,
    ) -> None:
        self._folder = folder
        self._settings = settings
        self._others = others
        self._retry_failed = retry_failed
        self._on_record = on_record
        self._ranges: dict[int, _Range] = {}

    def tasks(self, patterns: Iterator[BatchPattern]) -> Iterator[SampleTask]:
        """Goes through the input, and gives what has to be draped."""
        number, position = 0, -1
        for position, pattern in enumerate(patterns):
            if position // self._settings.shard_size != number:
                self._end(number)
            number = position // self._settings.shard_size
            task = self._task(position, pattern)
            part = self._ranges.setdefault(number, _Range())
            if self._is_sealed(part, number, position, task.checksum):
                continue
            part.is_open = True
            if self._folder.is_done(position, task.checksum, retry_failed=self._retry_failed):
                continue
            part.missing.add(position)
            twin = self._others.twin_of(task.pattern)
            if task.pattern.error:
                reason = f"{task.pattern.source}: {task.pattern.error}"
                self.take_in(not_made(task, REJECTED, reason))
            elif twin is not None:
                reason = f"the same pattern as '{twin[0]}' of the split '{twin[1]}'"
                self.take_in(not_made(task, REJECTED, reason))
            else:
                yield task
        if position >= 0:
            self._end(number)

    def take_in(self, made: MadeSample) -> None:
        """Keeps what was made, and seals its range when that was the last of it."""
        self._folder.keep(made)
        if self._on_record is not None:
            self._on_record(made.record)
        position = made.record["position"]
        number = position // self._settings.shard_size
        self._ranges[number].missing.discard(position)
        self._seal_if_done(number)

    def _task(self, position: int, pattern: BatchPattern) -> SampleTask:
        pattern = _with_content(pattern)
        self._others.require_new(pattern)
        content = pattern.line if pattern.line is not None else pattern.error.encode()
        return SampleTask(position, hashlib.sha256(content).hexdigest(), pattern, self._settings.drape)

    def _is_sealed(self, part: _Range, number: int, position: int, checksum: str) -> bool:
        """Whether nothing is to be done for a pattern because it is in a shard; reopens shards.

        Raises:
            InputError: The shard was made from other patterns.
        """
        part.checksums.append(checksum)
        shard = self._folder.shard(number)
        if shard is None:
            return False
        if position + 1 == shard.last and input_checksum(part.checksums) != shard.input_sha256:
            raise self._folder.other_input(shard.first, shard.last)
        if part.is_open:
            return False
        retry = self._retry_failed and any(r.status == FAILED for r in shard.rejected)
        if position >= shard.last or retry:
            self._folder.reopen(number)
            part.is_open = True
        return not part.is_open

    def _end(self, number: int) -> None:
        self._ranges[number].is_read = True
        self._seal_if_done(number)

    def _seal_if_done(self, number: int) -> None:
        part = self._ranges[number]
        if not part.is_read or part.missing:
            return
        if part.is_open:
            self._folder.seal(number, part.checksums)
        del self._ranges[number]


def _chain(first: BatchPattern, rest: Iterator[BatchPattern]) -> Iterator[BatchPattern]:
    yield first
    yield from rest


def _with_content(pattern: BatchPattern) -> BatchPattern:
    """The pattern with its text instead of its file: workers may be on other machines."""
    pattern = replace(pattern, source=Path(pattern.source).name)  # data sets hold no paths
    if pattern.path is None or pattern.error:
        return pattern
    try:
        content = pattern.path.read_bytes().removeprefix(b"\xef\xbb\xbf")
    except OSError as error:
        return replace(pattern, path=None, error=f"Cannot be read: {error.strerror or error}.")
    return replace(pattern, path=None, line=b'{"pattern":' + content + b"}")


def _note(folder: SplitFolder) -> str:
    before = folder.made_by_other_code
    if before is None:
        return ""
    return (
        f"other code than before ({before['version']} {before['commit'][:12]}): samples made now may differ "
        "from what the earlier code would have made"
    )
