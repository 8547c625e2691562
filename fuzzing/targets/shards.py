"""Data sets: shards of samples, the index of a split, and patterns in lines of JSON."""

from __future__ import annotations

import gzip
import json
import struct
import tempfile
from collections.abc import Sequence
from dataclasses import replace
from functools import cache
from pathlib import Path
from random import Random
from typing import Any

from fuzzing.mutation.byte_mutations import mutate_bytes
from fuzzing.mutation.json_mutations import mutate_json, written
from fuzzing.mutation.panel_mutations import mutate_pattern
from fuzzing.target import Feed, File, Target
from fuzzing.targets import patterns


@cache
def _samples() -> tuple[Any, ...]:
    """A skirt and a T-shirt where they are placed."""
    from swifttailor.data.sample import Sample
    from swifttailor.draping.placement import place_vertices
    from swifttailor.garment import Garment
    from swifttailor.panel_mesh import mesh_pattern
    from swifttailor.pattern.drafts import draft

    made = []
    for name in ("fitted-skirt", "t-shirt"):
        mesh = mesh_pattern(draft(name).canonical(), 8.0)
        about = {"source": name, "quality": {"accepted": True, "reasons": [], "top_cm": 140.0}}
        made.append(Sample.of_garment(name, Garment(mesh, place_vertices(mesh)), 8.0, about))
    return tuple(made)


def shard_seeds() -> Sequence[File]:
    """A shard of two samples."""
    from swifttailor.data.sample import store_sample
    from swifttailor.data.shard_file import write_shard

    with tempfile.TemporaryDirectory() as folder:
        path, _ = write_shard(Path(folder), "shard", [store_sample(one) for one in _samples()])
        return [File(path.read_bytes(), ".safetensors")]


def mutate_shard(file: File, random: Random) -> bytes:
    """Damage to the header, to what a sample says of itself, or to the bytes."""
    way = random.random()
    if way < 0.25:
        return mutate_bytes(file.data, random)
    if way < 0.5:
        (size,) = struct.unpack("<Q", file.data[:8])
        header = written(mutate_json(json.loads(file.data[8 : 8 + size]), random), random)
        return struct.pack("<Q", len(header)) + header + file.data[8 + size :]
    from swifttailor.data.encoding import decode_document, pack
    from swifttailor.data.sample import StoredSample, store_sample
    from swifttailor.data.shard_file import pack_sample

    stored = store_sample(random.choice(_samples()))
    value: Any = decode_document(stored.document)
    if random.random() < 0.4:
        mutate_pattern(value["pattern"], random)
    else:
        value = mutate_json(value, random)
    document = pack(written(value, random))
    positions = pack(bytes(50_000_000)) if random.random() < 0.02 else stored.positions
    return pack_sample(StoredSample(document, positions))


def index_seeds() -> Sequence[File]:
    """The index of a split with two shards."""
    from swifttailor.data.index import INDEX, Rejected, Shard, SplitIndex

    shards = [
        Shard(
            0,
            3,
            "shard-00000-0123456789ab.safetensors",
            "0" * 64,
            99,
            "1" * 64,
            ("a", "b"),
            (Rejected(1, "c", "failed", ("x",)),),
        ),
        Shard(3, 4, "", "", 0, "1" * 64, (), (Rejected(3, "d", "rejected", ("y", "z")),)),
    ]
    settings = {"edge_length": 2.0, "body": {"name": "default"}}
    index = replace(SplitIndex("train", settings, ({"version": "0.1.0"},)), complete=True)
    with tempfile.TemporaryDirectory() as folder:
        index.with_shards(shards, complete=True).save(Path(folder))
        return [File((Path(folder) / INDEX).read_bytes(), ".json")]


def mutate_index(file: File, random: Random) -> bytes:
    """Damage to the JSON or to the bytes."""
    if random.random() < 0.15:
        return mutate_bytes(file.data, random)
    return written(mutate_json(json.loads(file.data), random), random)


def list_seeds() -> Sequence[File]:
    """Three patterns, a line each, packed and not."""
    lines = [
        b'{"id": "%d", "base": "b", "pattern": %s}' % (k, file.data)
        for k, file in enumerate(patterns.seeds()[:3])
    ]
    text = b"\n".join(lines) + b"\n"
    return [File(text, ".jsonl"), File(gzip.compress(text, mtime=0), ".jsonl.gz")]


def mutate_list(file: File, random: Random) -> bytes:
    """Damage to a line, to the order of lines, or to the bytes."""
    packed = file.ending.endswith(".gz")
    lines = (gzip.decompress(file.data) if packed else file.data).splitlines()
    for _ in range(random.randint(0, 2)):
        k = random.randrange(len(lines))
        if random.random() < 0.3:
            lines.insert(
                k, random.choice((b"", b"{}", b"null", b"[" * 3000, lines[k], b'{"id": 1, "pattern": 2}'))
            )
        else:
            lines[k] = written(mutate_json(_parsed(lines[k]), random), random)
    text = b"\n".join(lines)
    data = gzip.compress(text, mtime=0) if packed else text
    return mutate_bytes(data, random, 3) if random.random() < 0.4 else data


def _parsed(line: bytes) -> Any:
    try:
        return json.loads(line)
    except (ValueError, RecursionError):
        return {}


def _load_shards() -> Feed:
    from swifttailor.data.sample import load_sample
    from swifttailor.data.shard_file import ShardFile
    from swifttailor.data.verify import sample_faults

    def feed(path: Path) -> None:
        shard = ShardFile(path)
        for k in range(min(len(shard), 3)):
            sample = load_sample(shard[k])
            list(sample_faults(sample, 8.0))

    return feed


def _load_index() -> Feed:
    from swifttailor.data.reader import SplitReader
    from swifttailor.data.verify import verify_dataset

    def feed(path: Path) -> None:
        index = path.with_name("index.json")
        path.rename(index)
        reader = SplitReader(path.parent)
        list(verify_dataset(path.parent))
        if len(reader):
            reader.place(len(reader) - 1)
            reader.order(0)

    return feed


def _load_lists() -> Feed:
    from swifttailor.data.edits.edit_file import read_edits
    from swifttailor.errors import SwiftTailorError
    from swifttailor.pattern.pattern_list import count_patterns, read_patterns

    def feed(path: Path) -> None:
        count_patterns(path)
        refused: list[SwiftTailorError] = []
        for entry in (*read_patterns(path), *(edit.pattern for edit in read_edits(path))):
            try:
                entry.read()
            except SwiftTailorError as error:
                refused.append(error)
        if refused:
            raise refused[0]

    return feed


TARGETS = (
    Target(
        "shard",
        "shards of data sets, their samples verified",
        shard_seeds,
        mutate_shard,
        _load_shards,
        10.0,
        1000,
        250,
    ),
    Target("index", "index.json of data sets", index_seeds, mutate_index, _load_index, in_ci=1000),
    Target("list", "patterns in lines of JSON", list_seeds, mutate_list, _load_lists, 5.0, in_ci=500),
)
