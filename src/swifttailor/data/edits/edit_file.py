"""Edited versions of patterns in files: GarmentCode's edits, or pairs of ``swifttailor data edits``."""

from __future__ import annotations

import json
from collections.abc import Iterator
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from swifttailor.data.edits.pairs import EditPair, is_reversed
from swifttailor.errors import InputError
from swifttailor.pattern import Pattern, to_specification
from swifttailor.pattern.json_values import parse_json
from swifttailor.pattern.pattern_list import LINE_ENDINGS, BatchPattern, read_patterns


@dataclass(frozen=True)
class EditedVersion:
    """A pattern that came of editing another one, not parsed yet."""

    base: str
    """Id of the other one; empty where its line cannot be used."""
    pattern: BatchPattern
    """The version; its `error` says why the line cannot be used."""


def read_edits(source: Path) -> Iterator[EditedVersion]:
    """Goes through the edited versions in a file.

    Args:
        source: A .jsonl or .jsonl.gz file. A line is ``{"id": ..., "base": ..., "pattern": ...}``, the base
            being the id of a pattern that stands elsewhere, as in GarmentCode's edits: what they say of
            design parameters is not read, since it says nothing about what is seen. Or it is a pair of
            `pair_line`; a pair and the same the other way lead to one version.

    Raises:
        InputError: There is no such file.
    """
    if not source.name.lower().endswith(LINE_ENDINGS):
        raise InputError(
            f"'{source}' is no file of edits. Give a .jsonl or .jsonl.gz file with one "
            '{"id": ..., "base": ..., "pattern": ...} a line, or what swifttailor data edits has written.'
        )
    last: tuple[str, Any] | None = None
    for entry in read_patterns(source):
        if entry.error or entry.line is None:
            yield EditedVersion("", entry)
            continue
        value = parse_json(entry.line, entry.source)
        base = value.get("base")
        if not isinstance(base, str) or not base:
            why = f'The line names no pattern that was edited: "base" is {base!r}; the id of one is accepted.'
            yield EditedVersion("", replace(entry, error=why))
        elif "edited" not in value:
            yield EditedVersion(base, entry)
        else:
            version = value["pattern" if is_reversed(str(value.get("source", ""))) else "edited"]
            if (base, version) != last:
                line = json.dumps({"id": entry.id, "pattern": version}).encode()
                yield EditedVersion(base, replace(entry, line=line))
            last = (base, version)


def pair_line(id: str, base: str, pair: EditPair) -> bytes:
    """A pair as a line of JSON, its end included.

    Args:
        id: Of the pair; must differ from that of every other in the file.
        base: Id of the pattern that was edited; also in a pair that leads back to it.
        pair: What to write.
    """
    written = {
        "id": id,
        "base": base,
        "source": pair.source,
        "instruction": pair.instruction.text,
        "changes": [change.to_json() for change in pair.instruction.changes],
        "pattern": to_specification(pair.base),
        "edited": to_specification(pair.edited),
    }
    return (json.dumps(written, ensure_ascii=False, allow_nan=False) + "\n").encode()


def version_line(id: str, base: str, pattern: Pattern) -> bytes:
    """A recut pattern as a line of JSON, its end included: for `read_edits` and all readers of patterns.

    Args:
        id: Of the version.
        base: Id of the pattern that was recut.
        pattern: The version.
    """
    written = {"id": id, "base": base, "pattern": to_specification(pattern)}
    return json.dumps(written, ensure_ascii=False, allow_nan=False).encode() + b"\n"
