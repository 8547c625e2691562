"""Model files, of one ONNX graph or an archive of several, and libraries of known patterns."""

from __future__ import annotations

import hashlib
import json
import zipfile
from collections.abc import Sequence
from functools import cache
from pathlib import Path
from random import Random
from typing import Any

from fuzzing.mutation.archive_mutations import archive_of, members_of, mutate_archive
from fuzzing.mutation.array_mutations import mutate_array
from fuzzing.mutation.byte_mutations import mutate_bytes
from fuzzing.mutation.json_mutations import mutate_json, written
from fuzzing.mutation.message_mutations import encoded, fields_of, message_of, mutate_message
from fuzzing.target import Feed, File, Target

_TESTS = Path(__file__).parents[2] / "tests"
_METADATA = 14
"""Of ONNX's ModelProto."""
_NOTE, _GRAPH, _CARD = "swifttailor", "graph", "card.json"


def graph_seeds() -> Sequence[File]:
    """The smallest GarmentSewer."""
    return [File((_TESTS / "garment_sewer" / "tiny_sewer.onnx").read_bytes(), ".onnx")]


def archive_seeds() -> Sequence[File]:
    """The smallest PatternMaker."""
    return [File((_TESTS / "pattern_maker" / "tiny_maker.zip").read_bytes(), ".zip")]


@cache
def _parts(data: bytes) -> tuple[bytes, Any]:
    """The graph of a model file, and what the file says of itself."""
    fields = fields_of(data) or []
    notes = [content for number, _, content in fields if number == _METADATA]
    entry = {number: content for number, _, content in fields_of(notes[-1]) or []}
    about = json.loads(entry[2])
    size = about[_GRAPH]["bytes"] if _GRAPH in about else None
    graph = data[:size] if size else message_of([f for f in fields if f[0] != _METADATA])
    return graph, about


def mutate_graph(file: File, random: Random) -> bytes:
    """Damage to the graph under a checksum that fits it, to what the file says of itself, or to the bytes."""
    way = random.random()
    if way < 0.15:
        return mutate_bytes(file.data, random)
    graph, about = _parts(file.data)
    if way < 0.7:
        graph = mutate_message(graph, random)
    value = json.loads(json.dumps(about))
    if isinstance(value, dict):
        value[_GRAPH] = {"bytes": len(graph), "sha256": hashlib.sha256(graph).hexdigest()}
    if way > 0.6:
        value = mutate_json(value, random)
    note = message_of([(1, 2, _NOTE.encode()), (2, 2, written(value, random))])
    return graph + encoded(_METADATA << 3 | 2) + encoded(len(note)) + note


def mutate_maker(file: File, random: Random) -> bytes:
    """Damage to the archive and its members; most of the time its checksums fit."""
    data = mutate_archive(file.data, random, _member, stored=True)
    if random.random() < 0.15 or not data.startswith(b"PK"):
        return data
    try:
        members = members_of(data)
        about = json.loads(dict(members)[_CARD])
        about["sha256"] = {
            name: hashlib.sha256(content).hexdigest() for name, content in members if name != _CARD
        }
    except (
        zipfile.BadZipFile,
        OSError,
        EOFError,
        ValueError,
        KeyError,
        TypeError,
        NotImplementedError,
        RuntimeError,
        RecursionError,
    ):
        return data
    members = [(name, json.dumps(about).encode() if name == _CARD else content) for name, content in members]
    return archive_of(members, [zipfile.ZIP_STORED] * len(members))


def _member(name: str, content: bytes, random: Random) -> bytes:
    if random.random() < 0.1:
        return mutate_bytes(content, random)
    if name.endswith(".onnx"):
        return mutate_message(content, random)
    if name.endswith(".npy"):
        return mutate_array(content, random)
    if name.endswith(".json"):
        return written(mutate_json(json.loads(content), random), random)
    return mutate_bytes(content, random)


def library_seeds() -> Sequence[File]:
    """A library of two drafts."""
    import tempfile

    import numpy as np

    from swifttailor.describing import measure_facts
    from swifttailor.pattern.drafts import draft
    from swifttailor.pattern_library.known import KnownPattern, write_library
    from swifttailor.pattern_library.truth_table import TruthTable
    from swifttailor.picture_reader.truth import Truth

    known = [KnownPattern(name, draft(name).canonical()) for name in ("fitted-skirt", "t-shirt")]
    truths = [Truth.of(one.pattern, measure_facts(one.pattern)) for one in known]
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "known.zip"
        write_library(path, known, TruthTable.of(truths), np.array([3, 1]), {"seed": 7})
        return [File(path.read_bytes(), ".zip")]


def mutate_library(file: File, random: Random) -> bytes:
    """Damage to the archive and its members."""
    return mutate_archive(file.data, random, _member, stored=False)


def _load_graphs() -> Feed:
    from swifttailor.garment_sewer.model_file import load_model

    def feed(path: Path) -> None:
        load_model(path)

    return feed


def _load_makers() -> Feed:
    from swifttailor.pattern_maker.network.model_file import load_model

    def feed(path: Path) -> None:
        load_model(path)

    return feed


def _load_library() -> Feed:
    from swifttailor.pattern_library.known import PatternLibrary

    def feed(path: Path) -> None:
        library = PatternLibrary.load(path)
        for number in range(min(len(library), 3)):
            library.pattern(number)

    return feed


TARGETS = (
    Target(
        "model",
        "model files that are one ONNX graph",
        graph_seeds,
        mutate_graph,
        _load_graphs,
        10.0,
        1000,
        250,
    ),
    Target(
        "maker", "model files that are an archive", archive_seeds, mutate_maker, _load_makers, 10.0, 1000, 60
    ),
    Target(
        "library", "libraries of known patterns", library_seeds, mutate_library, _load_library, 5.0, 600, 200
    ),
)
