"""Garment Geometry Images: ggi.npz, read and decoded."""

from __future__ import annotations

import json
import tempfile
from collections.abc import Sequence
from pathlib import Path
from random import Random

import numpy as np

from fuzzing.mutation.archive_mutations import mutate_archive
from fuzzing.mutation.array_mutations import array_file, mutate_array
from fuzzing.mutation.byte_mutations import mutate_bytes
from fuzzing.mutation.json_mutations import mutate_json, written
from fuzzing.mutation.panel_mutations import mutate_pattern
from fuzzing.target import Feed, File, Target


def seeds() -> Sequence[File]:
    """Images of a skirt and a T-shirt: placed, with their pattern and without, and a pattern alone."""
    from dataclasses import replace

    from swifttailor.draping.placement import place_vertices
    from swifttailor.garment import Garment
    from swifttailor.ggi import encode
    from swifttailor.ggi.file import write_ggi
    from swifttailor.panel_mesh import mesh_pattern
    from swifttailor.pattern.drafts import draft

    files = []
    for name in ("fitted-skirt", "t-shirt"):
        mesh = mesh_pattern(draft(name).canonical(), 6.0)
        images = encode(Garment(mesh, place_vertices(mesh)), 64)
        for one in (images, replace(images, layout=None), replace(images, geometry=None)):
            with tempfile.TemporaryDirectory() as folder:
                files.append(File(write_ggi(one, Path(folder) / "ggi.npz").read_bytes(), ".npz"))
    return files


def mutate(file: File, random: Random) -> bytes:
    """Damage to arrays, to the pattern and the numbers in the file, or to the archive."""
    return mutate_archive(file.data, random, _member, stored=False)


def _member(name: str, content: bytes, random: Random) -> bytes:
    if name != "about.npy" or random.random() < 0.2:
        return mutate_array(content, random)
    head = content.index(b"\n") + 1
    value = json.loads(content[head:])
    if "pattern" in value and random.random() < 0.5:
        mutate_pattern(value["pattern"], random)
    else:
        value = mutate_json(value, random)
    text = written(value, random)
    return array_file(
        np.frombuffer(mutate_bytes(text, random, 1) if random.random() < 0.05 else text, np.uint8)
    )


def _load_feed() -> Feed:
    from swifttailor.ggi.decode import decode
    from swifttailor.ggi.file import read_ggi

    def feed(path: Path) -> None:
        images = read_ggi(path)
        if images.geometry is None:
            return  # a pattern that was never draped
        by_outline = images.layout is not None and len(path.read_bytes()) % 2
        garment = decode(images, "outline" if by_outline else "grid", 4.0)
        if not np.isfinite(garment.vertices).all():
            raise AssertionError("the garment has vertices that are not finite")

    return feed


TARGETS = (Target("ggi", "ggi.npz files, read and decoded", seeds, mutate, _load_feed, 10.0, 1000, 250),)
