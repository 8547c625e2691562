"""Patterns that a network is told of: what is true of them, and what the picture reader says of some."""

from __future__ import annotations

import gzip
import hashlib
import json
import sys
from collections.abc import Collection, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from swifttailor.data.pictures.blocks import Family
from swifttailor.data.pictures.scenes import View
from swifttailor.data.reader import SplitReader
from swifttailor.describing.measuring import measure_facts
from swifttailor.errors import SwiftTailorError
from swifttailor.evaluation.maker.looks import LookPictures
from swifttailor.parameter_reader.features import features_of
from swifttailor.pattern import Pattern, read_specification
from swifttailor.pattern.digest import pattern_digest
from swifttailor.pattern_library.sought import Sought
from swifttailor.picture_reader.labels import PARTS
from swifttailor.picture_reader.reader import PictureReader
from swifttailor.picture_reader.truth import Truth

_PLAIN_VIEWS: tuple[View, ...] = "front", "front", "front", "back"
_VIEWS: tuple[View, ...] = "front", "free", "front", "back"
"""From where garments are shown, in turn."""


@dataclass(frozen=True, eq=False)
class ToldPattern:
    """A pattern of which a network is told."""

    id: str
    design: dict[str, Any]
    """GarmentCode's parameters; empty where they are not known."""
    truth: Truth


def patterns_of(path: Path) -> Iterator[tuple[str, dict[str, Any], Pattern]]:
    """Id, design and pattern of each line that can be read; why the others cannot goes to stderr.

    Args:
        path: ``.jsonl.gz`` with ``id``, ``pattern`` and perhaps ``design``.
    """
    with gzip.open(path, "rt", encoding="utf-8") as file:
        for line in map(json.loads, file):
            try:
                pattern = read_specification(line["pattern"], name=line["id"]).pattern.canonical()
            except SwiftTailorError as error:
                sys.stderr.write(f"{line['id']}: {error}\n")
                continue
            yield line["id"], line.get("design", {}), pattern


def measured(path: Path, apart: Collection[str], cache: Path | None) -> list[ToldPattern]:
    """What is true of the patterns of a file.

    Args:
        path: See `patterns_of`.
        apart: Digests of patterns that are left out.
        cache: Folder that keeps what was measured.
    """
    without = hashlib.sha256(" ".join(sorted(apart)).encode()).hexdigest()
    kept = None if cache is None else cache / f"truths-{sha256(path)[:16]}-{without[:8]}.npz"
    if kept is not None and kept.is_file():
        with np.load(kept) as found:
            about = json.loads(str(found["about"]))
            arrays = [found[name] for name in ("part", "statements", "measures", "panels", "boxes")]
        return [
            ToldPattern(id, design, Truth(int(arrays[0][k]), *(a[k] for a in arrays[1:])))
            for k, (id, design) in enumerate(about)
        ]
    rows = []
    for id, design, pattern in patterns_of(path):
        if pattern_digest(pattern) in apart:
            continue
        try:
            rows.append(ToldPattern(id, design, Truth.of(pattern, measure_facts(pattern))))
        except SwiftTailorError as error:
            sys.stderr.write(f"{id}: {error}\n")
        if len(rows) % 500 == 0:
            sys.stderr.write(f"{path.name}: {len(rows)} patterns measured\n")
    if kept is not None:
        kept.parent.mkdir(parents=True, exist_ok=True)
        truths = [row.truth for row in rows]
        names = ("part", "statements", "measures", "panels", "boxes")
        arrays: dict[str, Any] = {
            name: np.array([getattr(truth, name) for truth in truths]) for name in names
        }
        np.savez_compressed(kept, about=json.dumps([[row.id, row.design] for row in rows]), **arrays)
    return rows


def readings(
    split: Path,
    most: int,
    cache: Path | None,
    known: Collection[str] | None = None,
    look: Family = "plain",
) -> list[tuple[str, np.ndarray]]:
    """Id and features of what the picture reader says of pictures of garments, from several sides in turn.

    Args:
        split: Data set with drapes or sewn garments.
        most: Garments that are read, from all over the split.
        known: Ids of those that are of use; all when None.
        cache: Folder that keeps what was read.
        look: Of the pictures.
    """
    samples = SplitReader(split)
    wanted = [id for id in samples.ids if known is None or id in known]
    which = hashlib.sha256(" ".join(wanted).encode()).hexdigest()[:8]
    name = (
        f"{split.parent.name}-{split.name}" if look == "plain" else f"{split.parent.name}-{split.name}-{look}"
    )
    kept = None if cache is None else cache / f"read-{name}-{most}-{which}.npz"
    if kept is not None and kept.is_file():
        with np.load(kept) as found:
            return list(zip(found["ids"].tolist(), found["features"], strict=True))
    reader, found = PictureReader.load(), []
    views = _PLAIN_VIEWS if look == "plain" else _VIEWS
    drawn = {view: LookPictures(split, 0, look, view) for view in set(views)}
    step = max(1, len(wanted) // most)
    for number, id in enumerate(wanted[::step]):
        pattern = samples.sample(id).pattern
        part = PARTS[Truth.of(pattern, measure_facts(pattern)).part]
        picture = drawn[views[number % len(views)]].picture(id)[1][0]
        seen = [one for one in reader.read(picture).parts if one.part == part]
        if seen:
            found.append((id, features_of(Sought.of_reading(seen[0]))))
        if number % 100 == 99:
            sys.stderr.write(f"{split}: {number + 1} pictures read\n")
    if kept is not None:
        kept.parent.mkdir(parents=True, exist_ok=True)
        ids, features = zip(*found, strict=True)
        np.savez_compressed(kept, ids=np.array(ids), features=np.stack(features))
    return found


def sha256(path: Path) -> str:
    """Checksum of a file."""
    return hashlib.sha256(path.read_bytes()).hexdigest()


def shown(argument: str) -> str:
    """A command's argument without the folders of this machine."""
    return Path(argument).name if "/" in argument else argument
