"""Drapes many patterns, in worker processes, so that it can be interrupted and go on."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator
from itertools import chain, islice
from pathlib import Path
from typing import Any

from swifttailor.atomic_files import disk_full, write_text
from swifttailor.draping.batch.ledger import SUMMARY, Ledger
from swifttailor.draping.batch.make_garment import DISK_FULL, GarmentTask, failure, make_garment
from swifttailor.draping.batch.settings import BatchSettings
from swifttailor.draping.batch.sheets import SHEETS, write_sheets
from swifttailor.draping.batch.summary import summarize
from swifttailor.draping.compiled_code import solver_is_compiled
from swifttailor.errors import DiskFullError, InputError
from swifttailor.garment.folder import plain
from swifttailor.output_folder import remove_unfinished_folder
from swifttailor.pattern.pattern_list import BatchPattern, read_patterns
from swifttailor.workers import run_tasks, sigterm_as_interrupt

TIME_LIMIT = 600.0

OnStart = Callable[[int, bool], None]
OnRecord = Callable[[dict[str, Any]], None]


def run_batch(
    source: Path,
    out: Path,
    settings: BatchSettings,
    *,
    workers: int,
    limit: int | None = None,
    time_limit: float = TIME_LIMIT,
    retry_failed: bool = False,
    overwrite: bool = False,
    on_start: OnStart | None = None,
    on_record: OnRecord | None = None,
    make: Callable[[GarmentTask], dict[str, Any]] = make_garment,
) -> dict[str, Any]:
    """Drapes all patterns of a file or folder into folders of their own.

    Each garment is saved whole or not at all, and its record is on disk before the next is taken in: after
    any interruption the same call goes on where it stopped. The garments do not depend on `workers`.

    Args:
        source: .jsonl, .jsonl.gz, or a folder of .json files.
        out: Folder of the batch: <id>/, results.jsonl, summary.json, sheet-01.png.
        settings: What the garments are made with.
        workers: Processes at the same time, each with one thread.
        limit: Only the first so many patterns.
        time_limit: Seconds after which a garment is given up.
        retry_failed: Try again what failed in an earlier call.
        overwrite: Replace files in the batch's folder that somebody else has put there or changed, and make
            garments again that have files which were cut short or changed.
        on_start: Called with the number of patterns that earlier calls have done and whether the solver is
            compiled.
        on_record: Called with each new record.
        make: Makes one garment (for tests).

    Returns:
        The content of summary.json; "changed" lists garments of earlier calls with files that are not as they
        were written, and these files.

    Raises:
        InputError: The source, the settings or the folder cannot be used.
        DiskFullError: There is no room for a garment; the same call goes on with it and the rest.
        SimulationError: No worker can be started.
        KeyboardInterrupt: After Ctrl-C or SIGTERM; summary.json is written before.
    """
    patterns = islice(read_patterns(source), limit)
    first = next(patterns, None)  # so that a source that cannot be read leaves no folder behind
    if first is None:
        raise InputError(
            f"'{source}' holds no patterns. Give one pattern a line, or a folder of .json files."
        )
    settings.require_usable()
    with Ledger(out, settings, overwrite=overwrite) as ledger:
        seen: dict[str, dict[str, Any]] = {}
        changed: dict[str, list[str]] = {}

        def take_in(record: dict[str, Any]) -> None:
            seen[record["id"]] = record  # first, so that an interruption never loses what is on disk
            ledger.add(record)
            if on_record is not None:
                on_record(record)

        def tasks() -> Iterator[GarmentTask]:
            for pattern in chain([first], patterns):
                if ledger.is_done(pattern.id, retry_failed=retry_failed):
                    seen[pattern.id] = record = ledger.records[pattern.id]
                    if record["status"] == "made" and (names := ledger.changed(pattern.id)):
                        changed[pattern.id] = names
                elif pattern.error:
                    take_in(_unusable(pattern))
                else:
                    yield GarmentTask(pattern, settings, out, overwrite)

        complete, compiled = False, solver_is_compiled()
        if on_start is not None:
            again = islice(read_patterns(source), limit) if ledger.records else ()
            on_start(sum(ledger.is_done(p.id, retry_failed=retry_failed) for p in again), compiled)
        outcomes = run_tasks(make, tasks(), workers=workers, time_limit=time_limit, first_alone=not compiled)
        try:
            with sigterm_as_interrupt():
                for outcome in outcomes:
                    if outcome.lost:
                        remove_unfinished_folder(out / outcome.task.pattern.folder)
                    elif outcome.result["status"] == DISK_FULL:
                        raise disk_full(out)
                    take_in(_lost(outcome.task, outcome.lost) if outcome.lost else outcome.result)
                complete = True
        finally:
            outcomes.close()
            summary = plain(summarize(seen.values(), settings.identity(), complete=complete))
            if changed:
                summary["changed"] = changed
            try:
                with ledger.output.fill() as made:
                    write_text(made / SUMMARY, json.dumps(summary, indent=2, allow_nan=False) + "\n")
            except DiskFullError:
                if complete:  # else what ended the batch is on its way already
                    raise
        if settings.preview:
            with ledger.output.fill(stale=SHEETS) as made:
                write_sheets(out, summary["garments"], made)
        return summary


def _unusable(pattern: BatchPattern) -> dict[str, Any]:
    return {"id": pattern.id, "folder": ""} | failure("Unreadable", f"{pattern.source}: {pattern.error}")


def _lost(task: GarmentTask, why: str) -> dict[str, Any]:
    return {"id": task.pattern.id, "folder": task.pattern.folder} | failure("WorkerLost", why)
