"""index.json: what a split holds, what it was made with, and the checksum of each of its shards."""

from __future__ import annotations

import json
from collections.abc import Iterable
from dataclasses import asdict, dataclass, replace
from pathlib import Path
from typing import Any

from swifttailor.atomic_files import write_text
from swifttailor.errors import InputError

INDEX = "index.json"
FORMAT = "swifttailor split 1"


@dataclass(frozen=True)
class Rejected:
    """A pattern that gave no sample."""

    position: int
    """In the input, from 0."""
    id: str
    status: str
    """``rejected``: it cannot be sewn or its drape is beyond the limits of quality, and always will be;
    ``failed``: it crashed, ran out of memory or time, and may be tried again."""
    reasons: tuple[str, ...]


@dataclass(frozen=True)
class Shard:
    """What became of consecutive patterns of the input."""

    first: int
    """Position of its first pattern in the input, from 0."""
    last: int
    """Position after its last pattern."""
    file: str
    """Name of the file; empty when no sample was accepted."""
    sha256: str
    bytes: int
    input_sha256: str
    """Of the patterns it was made from."""
    ids: tuple[str, ...]
    """Of the samples in the file, in its order."""
    rejected: tuple[Rejected, ...]

    @property
    def positions(self) -> tuple[int, ...]:
        """Position in the input of each sample in the file."""
        absent = {r.position for r in self.rejected}
        return tuple(p for p in range(self.first, self.last) if p not in absent)


@dataclass(frozen=True)
class SplitIndex:
    """The content of index.json. Shards are in the order of the input."""

    split: str
    settings: dict[str, Any]
    """All that decides what the samples look like."""
    built_with: tuple[dict[str, str], ...] = ()
    """Versions of the code that worked on it: version, commit and code checksum."""
    shards: tuple[Shard, ...] = ()
    patterns: int = 0
    """How many patterns the shards were made from."""
    complete: bool = False
    """Whether that was all of the input."""

    def with_shards(self, shards: list[Shard], *, complete: bool) -> SplitIndex:
        """The index with other shards."""
        ordered = tuple(sorted(shards, key=lambda s: s.first))
        return replace(
            self, shards=ordered, patterns=sum(s.last - s.first for s in ordered), complete=complete
        )

    def save(self, folder: Path) -> None:
        """Writes index.json.

        Raises:
            InputError: It cannot be written; the index that was there before stays.
        """
        text = json.dumps({"format": FORMAT} | asdict(self), indent=1) + "\n"
        write_text(folder / INDEX, text, overwrite=True)


def read_index(folder: Path) -> SplitIndex:
    """Reads the index of a split.

    Raises:
        InputError: It is missing or damaged.
    """
    path = folder / INDEX
    try:
        value = json.loads(path.read_text(encoding="utf-8"))
    except OSError as error:
        raise InputError(
            f"'{folder}' is no split of a data set: cannot read '{path}' ({error.strerror or error}). "
            "Give a folder that swifttailor data build has made."
        ) from error
    except (ValueError, RecursionError) as error:
        raise InputError(f"'{path}' is damaged: {error}. Copy it again from its source.") from error
    try:
        if value.pop("format") != FORMAT:
            raise InputError(f"'{path}' is not of this version ('{FORMAT}').")
        shards = tuple(_shard(s) for s in value.pop("shards"))
        index = SplitIndex(**value | {"shards": shards, "built_with": tuple(value["built_with"])})
        _require(index, split=str, settings=dict, patterns=int, complete=bool)
        _require_all("built_with", index.built_with, dict)
        _require_all("settings.body", [index.settings.get("body", {})], dict)
        return index
    except (KeyError, TypeError, AttributeError) as error:
        raise InputError(
            f"'{path}' is damaged: {type(error).__name__} {error}. Copy it again from its source."
        ) from error


def split_folders(folder: Path) -> dict[str, Path]:
    """The splits of a data set by name: the folder itself where it is one, else those in it.

    Raises:
        InputError: There are none.
    """
    if (folder / INDEX).is_file():
        return {folder.name: folder}
    found = {p.parent.name: p.parent for p in sorted(folder.glob(f"*/{INDEX}"))}
    if not found:
        raise InputError(
            f"'{folder}' holds no data set: neither it nor a folder in it has an {INDEX}. "
            "Give a folder that swifttailor data build has made."
        )
    return found


def _shard(value: dict[str, Any]) -> Shard:
    fields: dict[str, Any] = value | {
        "ids": tuple(value["ids"]),
        "rejected": tuple(_rejected(r) for r in value["rejected"]),
    }
    shard = Shard(**fields)
    _require(shard, first=int, last=int, file=str, sha256=str, bytes=int, input_sha256=str)
    _require_all("ids", shard.ids, str)
    return shard


def _rejected(value: dict[str, Any]) -> Rejected:
    fields: dict[str, Any] = value | {"reasons": tuple(value["reasons"])}
    rejected = Rejected(**fields)
    _require(rejected, position=int, id=str, status=str)
    _require_all("reasons", rejected.reasons, str)
    return rejected


def _require(read: Any, **kinds: type) -> None:
    for name, kind in kinds.items():
        _require_all(name, [getattr(read, name)], kind)


def _require_all(name: str, values: Iterable[Any], kind: type) -> None:
    """Raises `TypeError` where one of the values is of another kind."""
    for value in values:
        if type(value) is not kind:
            raise TypeError(f"'{name}' is of type {type(value).__name__}; {kind.__name__} is expected")
