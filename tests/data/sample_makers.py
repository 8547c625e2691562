"""Makers of samples for tests of the builder itself: quick, or faulty on purpose."""

from __future__ import annotations

import json
import os
import time
import zlib
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

from swifttailor.data.builder import BuildSettings
from swifttailor.data.builder.make_sample import ACCEPTED, REJECTED, MadeSample, SampleTask, not_made
from swifttailor.data.sample import Sample, store_sample
from swifttailor.data.shard_file import pack_sample
from swifttailor.draping.batch import BatchSettings
from swifttailor.draping.batch.make_garment import read_sewable
from swifttailor.draping.placement import place_vertices
from swifttailor.errors import SwiftTailorError
from swifttailor.garment.garment import Garment
from swifttailor.panel_mesh import mesh_pattern
from swifttailor.workers import Outcome

COARSE = BuildSettings(BatchSettings(edge_length=8.0, preview=False), shard_size=4)


def make_quickly(task: SampleTask) -> MadeSample:
    """What the real maker returns, without a drape; the id says what becomes of it."""
    id = task.pattern.id
    if id.startswith("dies"):
        os._exit(3)
    if id.startswith("hangs"):
        time.sleep(600)
    if id.startswith("bad"):
        return not_made(task, REJECTED, "did not come to rest")
    try:
        pattern = read_sewable(task.pattern, task.settings).pattern.canonical()
    except SwiftTailorError as error:
        return not_made(task, REJECTED, str(error))
    mesh = mesh_pattern(pattern, task.settings.edge_length)
    chance = np.random.default_rng(zlib.crc32(id.encode()))
    vertices = np.cumsum(chance.normal(0, 1, (mesh.vertex_count, 3)), axis=0)
    about = {"source": task.pattern.source, "quality": {"accepted": True, "reasons": [], "top_cm": 140.0}}
    sample = Sample.of_garment(id, Garment(mesh, vertices), task.settings.edge_length, about)
    record = {"position": task.position, "id": id, "status": ACCEPTED, "reasons": []}
    record |= {"checksum": task.checksum, "seconds": {"sewing": time.monotonic()}}
    return MadeSample(record, pack_sample(store_sample(sample)))


def make_placed(task: SampleTask) -> MadeSample:
    """A sound sample without a drape: the panels where they are placed, with the seams closed."""
    sewable = read_sewable(task.pattern, task.settings)
    mesh = mesh_pattern(sewable.pattern.canonical(), task.settings.edge_length)
    vertices = place_vertices(mesh)
    quality = {"accepted": True, "reasons": [], "top_cm": float(vertices[:, 1].max())}
    about = {"source": task.pattern.source, "quality": quality}
    sample = Sample.of_garment(task.pattern.id, Garment(mesh, vertices), task.settings.edge_length, about)
    record = {"position": task.position, "id": task.pattern.id, "status": ACCEPTED, "reasons": []}
    return MadeSample(record | {"checksum": task.checksum}, pack_sample(store_sample(sample)))


def make_slowly(task: SampleTask) -> MadeSample:
    """Leaves time to be interrupted."""
    time.sleep(0.3)
    return make_quickly(task)


def dies_the_first_time(task: SampleTask) -> MadeSample:
    """Takes its worker along once for each pattern whose id starts with "shaky"."""
    id = task.pattern.id
    if id.startswith("shaky"):
        mark = os.path.join(os.environ["MARKS"], id)
        if not os.path.exists(mark):
            open(mark, "w").close()
            os.kill(os.getpid(), 9)
    return make_quickly(task)


def split_content(out: Path) -> dict[str, Any]:
    """All of the split "train" that has to be the same; the code's commit may change between two builds."""
    folder = out / "train"
    assert not list((folder / ".samples").iterdir())
    files: dict[str, Any] = {p.name: p.read_bytes() for p in folder.iterdir() if p.is_file()}
    del files["results.jsonl"]
    files["index.json"] = json.loads(files["index.json"])
    del files["index.json"]["built_with"]
    return files


def run_here(function, tasks, *, order: Callable[[list], list] = list, stop_after: int | None = None):
    """A runner without processes; `stop_after` so many it is killed."""
    done = 0
    waiting = order(list(tasks)) if order is not list else tasks
    for task in waiting:
        if done == stop_after:
            raise KeyboardInterrupt
        yield Outcome(task, function(task))
        done += 1
