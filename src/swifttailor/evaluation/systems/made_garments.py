"""The garments of one generator by one constructor, measured as they are made and kept on disk.

A line of JSON for each answer and a file with the points of its surface, so that work goes on after any end,
and sets of garments can be compared without making them again.
"""

from __future__ import annotations

import hashlib
import json
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from swifttailor.atomic_files import write_atomically
from swifttailor.errors import InputError, SwiftTailorError
from swifttailor.evaluation.garments.cloud_distances import chamfer, earth_mover
from swifttailor.evaluation.garments.point_cloud import PointCloud, sample_surface
from swifttailor.evaluation.garments.score import FEW_POINTS, POINTS
from swifttailor.evaluation.kept_settings import keep_settings
from swifttailor.evaluation.maker.ask import KeptAnswer
from swifttailor.evaluation.maker.questions import seed_of
from swifttailor.evaluation.systems.constructor import Constructor
from swifttailor.evaluation.systems.peak_memory import PeakMemory
from swifttailor.panel_mesh.topology import topology
from swifttailor.pattern.digest import pattern_digest
from swifttailor.progress import CountProgress, unwatched
from swifttailor.workers.work_folder import RecordFile

SETTINGS, RECORDS, CLOUDS = "settings.json", "garments.jsonl", "points"
FORMAT = "swifttailor system garments 1"


@dataclass(frozen=True, eq=False)
class MadeGarment:
    """What became of one answer."""

    id: str
    """Of the pattern that was asked for."""
    error: str
    """Why there is no garment; empty where there is."""
    points: PointCloud | None
    """`POINTS` of its surface."""
    chamfer_cm2: float | None
    """To the drape of the pattern that was asked for; None where it has none."""
    emd_cm: float | None
    accepted: bool | None
    """Within the limits of quality of drapes; None where it did not come to rest by physics."""
    reasons: tuple[str, ...]
    """What is beyond them."""
    sound: bool
    """No mesh edge has more than two faces."""
    seconds: dict[str, float]


def make_garments(
    constructor: Constructor,
    answers: Sequence[KeptAnswer],
    references: Sequence[PointCloud | None],
    folder: Path,
    *,
    seed: int,
    progress: CountProgress = unwatched,
) -> tuple[list[MadeGarment], int | None]:
    """Makes and measures what is not there yet.

    Args:
        constructor: Makes them.
        answers: Of one generator.
        references: Points of the drape of the pattern that each was asked for; None where there is none.
        folder: For the garments; nobody else works in it.
        seed: Of the points that surfaces are compared by.
        progress: Called with 1 after each.

    Returns:
        Each answer's garment or why there is none, and the most memory that the process held while it made
        them (MiB): None where nothing was made now, or the system does not tell.

    Raises:
        InputError: The folder cannot be used, or holds garments that were made in another way.
    """
    settings = {"format": FORMAT, "seed": seed} | constructor.identity()
    try:
        keep_settings(folder / SETTINGS, settings, "garments", (RECORDS, CLOUDS))
        (folder / CLOUDS).mkdir(parents=True, exist_ok=True)
        records = RecordFile(folder / RECORDS)
    except OSError as error:
        raise InputError(
            f"Cannot use '{folder}': {error.strerror or error}. Choose another --out."
        ) from error
    known = {r.get("asked"): r for r in records.found}
    made, memory = [], PeakMemory()
    try:
        for answer, reference in zip(answers, references, strict=True):
            asked = _asked(answer)
            path = folder / CLOUDS / f"{asked}.npy"
            record = known.get(asked)
            if record is None or ("error" not in record and not path.is_file()):
                record = {"id": answer.question.id, "asked": asked}
                record |= _make(constructor, answer, reference, path, seed, memory)
                known[asked] = record = json.loads(json.dumps(record, allow_nan=False))
                records.add(record)
            made.append(_read(record, path, folder / RECORDS))
            progress(1)
    finally:
        records.close()
    return made, memory.mebibytes


def _asked(answer: KeptAnswer) -> str:
    """Names an answer by what was asked for and what was answered, however it was asked."""
    answered = answer.record.get("error") if answer.pattern is None else pattern_digest(answer.pattern)
    text = f"{answer.question.id}\0{pattern_digest(answer.question.truth)}\0{answered}"
    return hashlib.sha256(text.encode()).hexdigest()[:24]


def _make(
    constructor: Constructor,
    answer: KeptAnswer,
    reference: PointCloud | None,
    path: Path,
    seed: int,
    memory: PeakMemory,
) -> dict[str, Any]:
    if answer.pattern is None:
        return {"error": str(answer.record.get("error", "There is no pattern."))}
    try:
        with memory:
            garment = constructor.make(answer.pattern)
        drawn = seed_of(seed, answer.question.id, "sewn")
        cloud = sample_surface(garment.vertices, garment.faces, POINTS, drawn)
    except SwiftTailorError as error:
        return {"error": str(error)}
    # As it will be read again, so that going on later makes no difference.
    cloud = PointCloud(cloud.points.astype(np.float32).astype(np.float64))
    write_atomically(path, lambda file: _save(file, cloud), overwrite=True)
    quality = garment.report.get("quality", {})
    far, moved = None, None
    if reference is not None:
        far = chamfer(cloud, reference)
        moved = earth_mover(cloud.first(FEW_POINTS), reference.first(FEW_POINTS))
    return {
        "chamfer_cm2": far,
        "emd_cm": moved,
        "accepted": quality.get("accepted"),
        "reasons": list(quality.get("reasons", ())),
        "sound": topology(garment.faces, len(garment.vertices)).nonmanifold_edges == 0,
        "seconds": garment.report.get("seconds", {}),
    }


def _save(path: Path, cloud: PointCloud) -> None:
    with path.open("wb") as file:
        np.save(file, cloud.points.astype(np.float32))


def _read(record: dict[str, Any], path: Path, book: Path) -> MadeGarment:
    try:
        error = str(record.get("error", ""))
        points = None if error else PointCloud(_points(path))
        return MadeGarment(
            id=str(record["id"]),
            error=error,
            points=points,
            chamfer_cm2=None if error else _number(record["chamfer_cm2"]),
            emd_cm=None if error else _number(record["emd_cm"]),
            accepted=record.get("accepted"),
            reasons=tuple(map(str, record.get("reasons", ()))),
            sound=bool(record.get("sound", False)),
            seconds={str(name): float(value) for name, value in record.get("seconds", {}).items()},
        )
    except (KeyError, TypeError, ValueError, OSError) as error:
        raise InputError(
            f"'{book}' or '{path.name}' beside it is damaged ({error!r}). Delete the folder to make its "
            "garments again."
        ) from error


def _number(value: Any) -> float | None:
    return None if value is None else float(value)


def _points(path: Path) -> np.ndarray:
    points = np.load(path, allow_pickle=False, mmap_mode="r")
    if points.shape != (POINTS, 3) or points.dtype != np.float32 or not np.isfinite(points).all():
        raise ValueError(f"expected {POINTS} points, got {points.dtype} of shape {points.shape}")
    return np.asarray(points, np.float64)
