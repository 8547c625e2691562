"""Sews the patterns of a split and measures each garment against its drape."""

from __future__ import annotations

import time
from collections.abc import Sequence
from dataclasses import dataclass, field, replace

from swifttailor.arrays import Floats
from swifttailor.data.reader import SplitReader
from swifttailor.data.sample import Sample
from swifttailor.draping.finish import finish as hang_to_rest
from swifttailor.errors import SwiftTailorError
from swifttailor.evaluation.garments.point_cloud import PointCloud
from swifttailor.evaluation.garments.score import Scored, draw_clouds, score_garment
from swifttailor.garment.garment import Garment
from swifttailor.garment_sewer.relaxing import relaxed
from swifttailor.garment_sewer.sewer import BATCH, GarmentSewer, Prepared
from swifttailor.progress import CountProgress, unwatched


@dataclass
class Made:
    """Garments and what became of the others."""

    scored: list[Scored] = field(default_factory=list)
    vertices: dict[int, Floats] = field(default_factory=dict)
    """Of the garments, by number of the sample."""
    lost: list[PointCloud] = field(default_factory=list)
    """The drapes of patterns of which no garment was made."""
    errors: dict[str, str] = field(default_factory=dict)
    """Why, by id."""

    def lose(self, sample: Sample, number: int, error: str, seed: int) -> None:
        """Takes note of a pattern that gave no garment."""
        drape = sample.garment
        self.lost.append(draw_clouds(drape.vertices, drape, seed=seed, number=number).reference)
        self.errors[sample.id] = error


def sew_split(
    sewer: GarmentSewer,
    reader: SplitReader,
    numbers: Sequence[int],
    *,
    resolution: int | None = None,
    finish: bool = False,
    relax: bool = True,
    seed: int = 0,
    progress: CountProgress = unwatched,
) -> Made:
    """Sews and measures.

    Args:
        sewer: Makes the garments.
        reader: The split.
        numbers: Of the samples.
        resolution: Of the images; the model's own when None.
        finish: Whether garments hang to rest by physics in the end.
        relax: Whether they fall for a moment first.
        seed: Of the points that surfaces are compared by.
        progress: Called with 1 after each.

    Raises:
        SwiftTailorError: The split cannot be read. Patterns that cannot be sewn are in the result.
    """
    made = Made()
    for first in range(0, len(numbers), BATCH):
        works = [_Work(k, reader[k]) for k in numbers[first : first + BATCH]]
        for work in works:
            work.prepare(sewer, resolution)
        _predict(sewer, [w for w in works if w.prepared is not None])
        for work in works:
            garment = work.decode(sewer, finish=finish, relax=relax)
            if garment is None:
                made.lose(work.sample, work.number, work.error, seed)
            else:
                drape = work.sample.garment
                found = score_garment(
                    work.sample.id, garment, drape, sewer.body, seed=seed, number=work.number
                )
                made.scored.append(found)
                made.vertices[work.number] = garment.vertices
            progress(1)
    return made


class _Work:
    """One pattern on its way."""

    def __init__(self, number: int, sample: Sample) -> None:
        self.number, self.sample = number, sample
        self.prepared: Prepared | None = None
        self.values: Floats | None = None
        self.error = ""
        self.seconds = 0.0

    def prepare(self, sewer: GarmentSewer, resolution: int | None) -> None:
        started = time.perf_counter()
        try:
            self.prepared = sewer.prepare(
                self.sample.pattern, edge_length=self.sample.edge_length, resolution=resolution
            )
        except SwiftTailorError as error:
            self.error = str(error)
        self.seconds += time.perf_counter() - started

    def decode(self, sewer: GarmentSewer, *, finish: bool, relax: bool) -> Garment | None:
        if self.prepared is None or self.values is None:
            return None
        started = time.perf_counter()
        try:
            garment = sewer.decode(self.prepared, self.values)
            if relax:
                garment = relaxed(garment)
            if finish:
                garment = hang_to_rest(garment)
        except SwiftTailorError as error:
            self.error = str(error)
            return None
        self.seconds += time.perf_counter() - started
        return replace(garment, report=garment.report | {"seconds": {"all": self.seconds}})


def _predict(sewer: GarmentSewer, works: Sequence[_Work]) -> None:
    """All go through the network together; each counts its share of the time."""
    prepared = [w.prepared for w in works if w.prepared is not None]
    if not prepared:
        return
    started = time.perf_counter()
    for work, values in zip(works, sewer.predict(prepared), strict=True):
        work.values = values
    for work in works:
        work.seconds += (time.perf_counter() - started) / len(works)
