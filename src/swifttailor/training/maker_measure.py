"""Patterns made ready to learn from, in worker processes.

Each becomes tokens, facts to write captions from, and a few recut versions to write instructions for.
"""

from __future__ import annotations

import hashlib
import json
import random
import zlib
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import islice
from pathlib import Path
from typing import Any

import numpy as np

from swifttailor.data.array_cache import name_with_code
from swifttailor.data.edits.edit_file import EditedVersion
from swifttailor.data.shard_file import write_durably
from swifttailor.describing.facts import GarmentFacts
from swifttailor.describing.facts_file import facts_values
from swifttailor.errors import SwiftTailorError
from swifttailor.pattern import Pattern
from swifttailor.pattern_maker.tokens.encode import encode
from swifttailor.recutting.random_cuts import Way, recut_variously
from swifttailor.recutting.table.cutter import Cutter
from swifttailor.wording.instructions.writer import write_instruction

FORMAT = 1
_TOKENS = ("decode", "edge_numbers", "encode", "grammar", "normalization", "placement_numbers", "vocabulary")
_NO_PART = ("pattern/check/crossing_repair.py", "pattern/check/repair.py", "pattern/svg", "pattern/tidying")
"""Of the room of patterns: patterns are not mended before they are measured."""


@dataclass(frozen=True)
class MeasureTask:
    """What a worker gets: consecutive patterns of a file."""

    patterns: tuple[EditedVersion, ...]
    """Those that are no edited versions have no `base`."""
    recuts: int
    """Versions to make of each."""
    path: Path
    """File to write."""


def task_name(patterns: tuple[EditedVersion, ...], recuts: int) -> str:
    """Name of the file for patterns: equal only if patterns, settings and code are."""
    digest = hashlib.sha256(json.dumps([FORMAT, recuts]).encode())
    for version in patterns:
        pattern = version.pattern
        data = pattern.line if pattern.line is not None else b""
        if pattern.path is not None:
            data = pattern.path.read_bytes()
        digest.update(json.dumps([pattern.id, version.base]).encode() + b"\0" + data + b"\0")
    modules = [f"pattern_maker/tokens/{name}.py" for name in _TOKENS]
    rooms = ("pattern", "body", "describing/measuring", "recutting/table", "recutting/ways")
    cutting = ("recutting/amounts", "recutting/levers", "recutting/random_cuts.py")
    facts = [f"describing/{name}.py" for name in ("dimensions", "facts", "facts_paths")]
    rooms = (*rooms, *cutting, *facts, *modules, "training/maker_measure.py")
    code = name_with_code("maker", *rooms, without=_NO_PART)
    return f"{code}-{digest.hexdigest()[:20]}.safetensors"


def measure(task: MeasureTask) -> str:
    """Writes the file of a task: versions of patterns, and which patterns were left out and why.

    Returns:
        What went wrong with the file, or nothing.
    """
    from safetensors.numpy import save

    about: list[dict[str, Any]] = []
    skipped: list[tuple[str, str]] = []
    tokens, numbers = [np.zeros(0, np.int16)], [np.zeros((0, 8), np.float32)]
    for given in task.patterns:
        try:
            for version, sequence in _versions(given, task.recuts):
                about.append(version | {"length": len(sequence)})
                tokens.append(sequence.tokens.astype(np.int16))
                numbers.append(np.asarray(sequence.numbers))
        except SwiftTailorError as error:
            skipped.append((given.pattern.id, str(error)))
    text = json.dumps({"versions": about, "skipped": skipped}, allow_nan=False)
    arrays = {
        "tokens": np.concatenate(tokens),
        "numbers": np.concatenate(numbers),
        "about": np.frombuffer(text.encode(), np.uint8),
    }
    try:
        write_durably(task.path, save(arrays))
    except SwiftTailorError as error:
        return str(error)
    return ""


def _versions(version: EditedVersion, recuts: int) -> Iterator[tuple[dict[str, Any], Any]]:
    id, pattern = version.pattern.id, version.pattern.read().pattern
    cutter = Cutter(pattern)
    # All or nothing: whatever cannot be encoded or measured is found out here.
    made = [({"id": id, "base": version.base, "source": "file"}, cutter.facts, pattern)]
    for source, facts, recut_pattern in _recuts(cutter, id, recuts):
        made.append(({"id": f"{id}/{source}", "base": id, "source": source}, facts, recut_pattern))
    encoded = [(about, facts, encode(each)) for about, facts, each in made]
    for about, facts, sequence in encoded:
        yield about | {"facts": facts_values(facts)}, sequence


def _recuts(cutter: Cutter, id: str, count: int) -> Iterator[tuple[str, GarmentFacts, Pattern]]:
    """Recut versions for which there are words, each about another topic."""

    def version(way: Way, after: Cutter) -> tuple[str, GarmentFacts, Pattern] | None:
        if not can_be_asked(cutter.facts, after.facts):
            return None
        try:
            encode(after.pattern)
        except SwiftTailorError:
            return None  # grown beyond what tokens can say
        return way.label, after.facts, after.pattern

    rng = random.Random(f"recut {zlib.crc32(id.encode())}")
    return islice(recut_variously(cutter, rng, version), count)


def can_be_asked(before: GarmentFacts, after: GarmentFacts) -> bool:
    """Whether there is an instruction from one garment to the other, or back."""
    return any(write_instruction(*way) is not None for way in ((before, after), (after, before)))
