"""Garments of GarmentCodeData put into shards like those that are draped here."""

from __future__ import annotations

import time
from collections.abc import Iterable, Iterator
from pathlib import Path

from swifttailor.data.builder.make_sample import (
    ACCEPTED,
    FAILED,
    REJECTED,
    MadeSample,
    SampleTask,
    not_made,
)
from swifttailor.data.garmentcodedata.dataset import SampleFolder
from swifttailor.data.garmentcodedata.multimodal import read_captions
from swifttailor.data.garmentcodedata.sample_folder import read_sample_folder
from swifttailor.data.sample import store_sample
from swifttailor.data.shard_file import pack_sample
from swifttailor.errors import SwiftTailorError
from swifttailor.pattern.pattern_list import BatchPattern, refuse_repeats

ORIGIN = "GarmentCodeData"


def patterns_of(samples: Iterable[SampleFolder]) -> Iterator[BatchPattern]:
    """The input of `build_split` for sample folders; failures come with their error."""
    return refuse_repeats(
        BatchPattern(
            id=folder.name,
            folder=folder.path,
            source=folder.path,
            number=number,
            path=folder.file("specification.json"),
            error=f"listed as a failure: {', '.join(folder.failures)}" if folder.failures else "",
        )
        for number, folder in enumerate(samples, 1)
    )


def import_sample(task: SampleTask, root: Path, captions: Path | None = None) -> MadeSample:
    """The sample of one folder; does for `build_split` what `make_sample` does for patterns.

    Args:
        task: Its pattern's `folder` is the path below `root`.
        root: Of the data set.
        captions: Folder of the unpacked captions of GCD-MM, to be kept with the samples.

    Returns:
        The sample or why there is none. Nothing is raised.
    """
    started = time.perf_counter()
    folder = SampleFolder(root, task.pattern.folder)
    settings = task.settings
    try:
        sample = read_sample_folder(folder, edge_length=settings.edge_length, rotation=settings.rotation)
        if captions is not None:
            texts = read_captions(captions, folder.name)
            sample.about["captions"] = {"description": texts.description, "occasion": texts.occasion}
    except SwiftTailorError as error:
        return not_made(task, REJECTED, f"{type(error).__name__}: {_below(root, error)}")
    except Exception as error:
        return not_made(task, FAILED, f"{type(error).__name__}: {_below(root, error)}")
    record = not_made(task, ACCEPTED, "").record | {
        "reasons": [],
        "quality": sample.about["quality"],
        "panels": len(sample.pattern.panels),
        "stitches": len(sample.pattern.stitches),
        "vertices": len(sample.vertices),
        "seconds": {"reading": round(time.perf_counter() - started, 4)},
    }
    return MadeSample(record, pack_sample(store_sample(sample)))


def _below(root: Path, error: Exception) -> str:
    """An error's text with paths relative to the data set: what is recorded must not depend on its place."""
    return str(error).replace(f"{root}/", "")
