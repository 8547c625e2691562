"""One sample of a data set, in a worker process: read, check, drape, judge, pack."""

from __future__ import annotations

import traceback
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from swifttailor.atomic_files import is_disk_full
from swifttailor.data.sample import Sample, store_sample
from swifttailor.data.shard_file import pack_sample
from swifttailor.draping.batch import BatchSettings
from swifttailor.draping.batch.make_garment import DISK_FULL, drape_pattern, read_sewable
from swifttailor.errors import MissingExtraError, SwiftTailorError
from swifttailor.garment.folder import plain
from swifttailor.garment.garment import Garment
from swifttailor.panel_mesh import mesh_pattern
from swifttailor.pattern.pattern_list import BatchPattern

ACCEPTED, REJECTED, FAILED = "accepted", "rejected", "failed"


@dataclass(frozen=True)
class SampleTask:
    """What a worker gets."""

    position: int
    """Of the pattern in the input."""
    checksum: str
    """Of the pattern."""
    pattern: BatchPattern
    settings: BatchSettings


@dataclass(frozen=True)
class MadeSample:
    """What a worker hands back."""

    record: dict[str, Any]
    """For results.jsonl: position, id, status, reasons, checksum; quality and seconds where draped."""
    data: bytes = b""
    """The sample (`pack_sample`), where accepted."""


def make_sample(task: SampleTask, *, largest: int | None = None) -> MadeSample:
    """Drapes a pattern and packs what came of it.

    Args:
        task: The pattern.
        largest: Vertices beyond which it is not draped but recorded as failed, so that it can be tried again:
            the few largest patterns take a good part of the time of all.

    Returns:
        The sample or why there is none. Nothing is raised: whatever goes wrong is in the record.
    """
    return guarded(task, lambda: _drape(task, largest))


def _drape(task: SampleTask, largest: int | None) -> MadeSample:
    if largest is not None:
        pattern = read_sewable(task.pattern, task.settings).pattern
        vertices = mesh_pattern(pattern.canonical(), task.settings.edge_length).vertex_count
        if vertices > largest:
            return not_made(task, FAILED, f"left for later: {vertices} vertices, more than {largest}")
    return packed(task, drape_pattern(task.pattern, task.settings))


def guarded(task: SampleTask, make: Callable[[], MadeSample]) -> MadeSample:
    """What `make` returns, or the record of what went wrong; of a full disk none that is kept."""
    try:
        return make()
    except MissingExtraError as error:  # not the pattern's fault
        return not_made(task, FAILED, str(error))
    except Exception as error:
        if is_disk_full(error):
            return not_made(task, DISK_FULL, str(error))
        if isinstance(error, SwiftTailorError):
            return not_made(task, REJECTED, f"{type(error).__name__}: {error}")
        last = traceback.extract_tb(error.__traceback__)[-1]
        place = f"{Path(last.filename).name}:{last.lineno}"
        return not_made(task, FAILED, f"{type(error).__name__}: {error} (at {place})")


def not_made(task: SampleTask, status: str, reason: str) -> MadeSample:
    """The record of a pattern that gave no drape."""
    return MadeSample(_record(task, status, [reason]))


def _record(task: SampleTask, status: str, reasons: list[str]) -> dict[str, Any]:
    return {
        "position": task.position,
        "id": task.pattern.id,
        "status": status,
        "reasons": reasons,
        "checksum": task.checksum,
    }


def packed(task: SampleTask, garment: Garment) -> MadeSample:
    """A garment as a sample, where its quality is accepted."""
    report = plain(garment.report)
    quality = report["quality"]
    status = ACCEPTED if quality["accepted"] else REJECTED
    measured = {name: report[name] for name in ("quality", "panels", "stitches", "vertices", "seconds")}
    record = _record(task, status, list(quality["reasons"])) | measured
    if status == REJECTED:
        return MadeSample(record)
    about = {"source": task.pattern.source, "quality": quality}
    if "mended" in report:
        about["mended"] = report["mended"]
    sample = Sample.of_garment(task.pattern.id, garment, task.settings.edge_length, about)
    return MadeSample(record, pack_sample(store_sample(sample)))
