"""One garment of a batch, in a worker process: read, check, drape, save."""

from __future__ import annotations

import functools
import time
import traceback
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from swifttailor.atomic_files import is_disk_full
from swifttailor.body import Body
from swifttailor.body.probe import probe_body
from swifttailor.draping.batch.settings import BatchSettings
from swifttailor.draping.drape import drape
from swifttailor.draping.sewable import Sewable, require_sewable
from swifttailor.errors import SwiftTailorError
from swifttailor.garment.garment import Garment
from swifttailor.pattern.check import BodyProbe
from swifttailor.pattern.pattern_list import BatchPattern

DISK_FULL = "disk full"


@dataclass(frozen=True)
class GarmentTask:
    """What a worker gets."""

    pattern: BatchPattern
    settings: BatchSettings
    out: Path
    """Folder of the batch."""
    overwrite: bool = False
    """Whether files in the garment's folder are replaced that somebody else has put there or changed."""


def make_garment(task: GarmentTask) -> dict[str, Any]:
    """Makes one garment and its folder.

    Returns:
        Its record for results.jsonl. Nothing is raised: whatever goes wrong is in the record. Where the disk
        is full its status is `DISK_FULL`, which is no record to keep.
    """
    record: dict[str, Any] = {"id": task.pattern.id, "folder": task.pattern.folder}
    try:
        return record | _make(task)
    except Exception as error:
        if is_disk_full(error):
            return record | {"status": DISK_FULL}
        if isinstance(error, SwiftTailorError):
            return record | failure(type(error).__name__, str(error))
        last = traceback.extract_tb(error.__traceback__)[-1]
        place = f"{Path(last.filename).name}:{last.lineno}"
        return record | failure(type(error).__name__, f"{error} (at {place})")


def failure(kind: str, error: str) -> dict[str, Any]:
    """The part of a record that says why there is no garment."""
    return {"status": "failed", "kind": kind, "error": error}


def _make(task: GarmentTask) -> dict[str, Any]:
    settings = task.settings
    garment = drape_pattern(task.pattern, settings)
    report = garment.report
    garment = replace(garment, report={"id": task.pattern.id} | report)
    before_saving = time.perf_counter()
    folder = task.out / task.pattern.folder
    garment.save(folder, body=shared_body(settings), preview=settings.preview, overwrite=task.overwrite)
    return {
        "status": "made",
        "accepted": report["quality"]["accepted"],
        "reasons": list(report["quality"]["reasons"]),
        "quality": report["quality"],
        "panels": report["panels"],
        "vertices": report["vertices"],
        "seconds": report["seconds"] | {"saving": round(time.perf_counter() - before_saving, 4)},
    }


def drape_pattern(pattern: BatchPattern, settings: BatchSettings) -> Garment:
    """Reads a pattern of a batch, checks that it can be sewn, and drapes it.

    Returns:
        The garment, with a complete report.

    Raises:
        SwiftTailorError: It is no pattern, or has errors, or cannot be draped.
    """
    started = time.perf_counter()
    sewable = read_sewable(pattern, settings)
    body = shared_body(settings)
    loading = time.perf_counter() - started
    garment = drape(
        sewable.pattern,
        body=body,
        fabric=settings.fabric,
        edge_length=settings.edge_length,
        engine=settings.engine,
        seed=settings.seed,
    )
    return replace(garment, report=sewable.complete_report(garment.report, loading))


def read_sewable(pattern: BatchPattern, settings: BatchSettings) -> Sewable:
    """Reads a pattern of a batch and checks that it can be sewn.

    Raises:
        SwiftTailorError: It is no pattern, or has errors.
    """
    reading = pattern.read(settings.rotation)
    return require_sewable(reading, pattern.id, repair=settings.repair, body=shared_probe(settings))


@functools.lru_cache(maxsize=1)
def shared_body(settings: BatchSettings) -> Body:
    """The body of a batch, loaded once in each worker."""
    return settings.load_body()


@functools.lru_cache(maxsize=1)
def shared_probe(settings: BatchSettings) -> BodyProbe:
    """What the checks know of the body of a batch."""
    return probe_body(shared_body(settings))
