"""A small split to evaluate on: drafts with something like a drape, made in a moment."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from swifttailor.body import Body
from swifttailor.data.builder.settings import BuildSettings
from swifttailor.data.index import Shard, SplitIndex
from swifttailor.data.sample import Sample, store_sample
from swifttailor.data.shard_file import write_shard
from swifttailor.draping.batch import BatchSettings
from swifttailor.garment.garment import Garment
from swifttailor.garment_sewer.pixels.body_distance import BodyDistance
from swifttailor.garment_sewer.pixels.sewn_prior import sew_around_body
from swifttailor.panel_mesh import mesh_pattern
from swifttailor.pattern.drafts import draft

EDGE_LENGTH = 6.0
LOWER = np.array([0.0, -4.0, 0.0])
"""What the drapes of `write_split` are moved by."""


def make_sample(id: str, name: str, **options) -> Sample:
    """The panels sewn around the body, then 4 cm lower."""
    mesh = mesh_pattern(draft(name, **options).canonical(), EDGE_LENGTH)
    vertices = sew_around_body(mesh, BodyDistance.of(Body.default())) + LOWER
    return Sample.of_garment(id, Garment(mesh, vertices), EDGE_LENGTH, {"source": "draft"})


def write_split(folder: Path, samples: list[Sample], settings: dict | None = None) -> Path:
    """Writes a split of one shard as ``swifttailor data build`` would."""
    folder.mkdir(parents=True)
    path, checksum = write_shard(folder, "shard-00000", [store_sample(s) for s in samples])
    ids = tuple(s.id for s in samples)
    shard = Shard(0, len(ids), path.name, checksum, path.stat().st_size, "", ids, ())
    if settings is None:
        settings = BuildSettings(BatchSettings(edge_length=EDGE_LENGTH, preview=False)).identity()
    SplitIndex(folder.name, settings).with_shards([shard], complete=True).save(folder)
    return folder


def make_data(folder: Path) -> Path:
    """A data set with the split validation: two skirts and a shirt."""
    samples = [
        make_sample("short", "fitted-skirt", length=45.0),
        make_sample("shirt", "t-shirt"),
        make_sample("long", "fitted-skirt", length=70.0),
    ]
    write_split(folder / "validation", samples)
    return folder
