"""What the workers of `ray_scaling` do beside functions of the package; in a module that they can import."""

from __future__ import annotations

import functools
from pathlib import Path

from swifttailor.data.reader import SplitReader
from swifttailor.evaluation.garments.sew_split import sew_split
from swifttailor.garment_sewer.sewer import GarmentSewer


def evaluate_one(task: tuple[Path, int]) -> int:
    """Sews one pattern of a split and compares the garment with its drape: 1 if there is one."""
    folder, number = task
    return len(sew_split(_sewer(), _reader(folder), [number]).scored)


@functools.cache
def _sewer() -> GarmentSewer:
    return GarmentSewer.load()


@functools.cache
def _reader(folder: Path) -> SplitReader:
    return SplitReader(folder)
