"""A small data set to train on in seconds: drafts whose drapes follow a simple rule that can be learnt."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from swifttailor.body import Body
from swifttailor.data.index import Shard, SplitIndex
from swifttailor.data.sample import Sample, store_sample
from swifttailor.data.shard_file import write_shard
from swifttailor.garment.garment import Garment
from swifttailor.garment_sewer.pixels.body_distance import BodyDistance
from swifttailor.garment_sewer.pixels.sewn_prior import sew_around_body
from swifttailor.panel_mesh import mesh_pattern
from swifttailor.pattern.drafts import draft

EDGE_LENGTH = 6.0


def make_sample(id: str, name: str, **options) -> Sample:
    """The panels sewn around the body, then 5 cm lower and 4 cm further forward."""
    mesh = mesh_pattern(draft(name, **options).canonical(), EDGE_LENGTH)
    vertices = sew_around_body(mesh, BodyDistance.of(Body.default())) + np.array([0.0, -5.0, 4.0])
    return Sample.of_garment(id, Garment(mesh, vertices), EDGE_LENGTH, {"source": "draft"})


def write_split(folder: Path, samples: list[Sample], *, size: int = 4) -> Path:
    """Writes a split as ``swifttailor data build`` would, `size` samples to a shard."""
    folder.mkdir(parents=True)
    shards = []
    for k in range(0, len(samples), size):
        part = samples[k : k + size]
        path, checksum = write_shard(folder, f"shard-{k // size:05d}", [store_sample(s) for s in part])
        ids = tuple(s.id for s in part)
        bytes_ = path.stat().st_size
        shards.append(Shard(k, k + len(part), path.name, checksum, bytes_, "", ids, ()))
    SplitIndex(folder.name, {}).with_shards(shards, complete=True).save(folder)
    return folder


def make_data(folder: Path) -> Path:
    """Splits train (6 garments) and validation (2)."""
    train = [make_sample(f"shirt{k}", "t-shirt", sleeve_length=20.0 + 8 * k) for k in range(3)]
    train += [make_sample(f"skirt{k}", "fitted-skirt", length=45.0 + 8 * k) for k in range(3)]
    validation = [
        make_sample("shirt", "t-shirt", sleeve_length=25.0),
        make_sample("skirt", "fitted-skirt", length=50.0),
    ]
    write_split(folder / "train", train)
    write_split(folder / "validation", validation)
    return folder
