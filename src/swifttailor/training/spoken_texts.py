"""Wishes and instructions in people's own words with what they ask for, for the wish reader to learn from."""

from __future__ import annotations

import json
import zlib
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from swifttailor.describing.differences import Change
from swifttailor.errors import InputError
from swifttailor.wishes.labels import change_of, number_labels, statement_labels

HELD_OUT_OF = 10
"""One text of so many is not learnt from, but validated with."""
_KEYS = frozenset({"text", "kind", "asks", "amounts", "voice"})


@dataclass(frozen=True)
class SpokenText:
    """What somebody said, and meant."""

    text: str
    kind: str | None
    """Of the garment that an instruction is about; None of a text that describes a garment."""
    changes: tuple[Change, ...]
    """What it asks for; empty where that is nothing that a pattern can have."""

    @property
    def held_out(self) -> bool:
        """Whether it is kept for validation; decided by the text alone."""
        return zlib.crc32(self.text.lower().encode()) % HELD_OUT_OF == 0


def read_spoken_texts(files: Sequence[Path]) -> list[SpokenText]:
    """Reads files of such texts.

    Args:
        files: Of JSON lines: ``text``, ``kind``, null of a description, ``asks``, labels of what it asks for
            (`statement_labels`), ``amounts``, cm or pieces by label (`number_labels`) where figures are said,
            and ``voice``, whose
            words they are.

    Raises:
        InputError: A file cannot be read, or a line says something else.
    """
    found = []
    for path in files:
        try:
            lines = path.read_text(encoding="utf-8").splitlines()
        except (OSError, UnicodeDecodeError) as error:
            raise InputError(f"'{path}' cannot be read: {error}.") from error
        for number, line in enumerate(lines, 1):
            if line.strip():
                found.append(_spoken(line, f"{path}, line {number}"))
    return found


def _spoken(line: str, where: str) -> SpokenText:
    try:
        given: Any = json.loads(line)
        if not isinstance(given, dict) or not given.keys() <= _KEYS:
            raise TypeError(f"its keys are {', '.join(sorted(_KEYS))}")
        text, kind = given["text"], given["kind"]
        asks, amounts = given["asks"], given.get("amounts", {})
        if not isinstance(text, str) or not isinstance(kind, str | None) or not isinstance(asks, list):
            raise TypeError("text and kind are texts, asks a list")
        amounts = {str(label): float(amount) for label, amount in amounts.items()}
    except (ValueError, KeyError, TypeError, AttributeError) as error:
        raise InputError(
            f"{where}: this is no text with what it asks for ({error!r}). Accepted is "
            '{"text": "an inch off", "kind": "skirt", "asks": ["step:length:down"], '
            '"amounts": {"step:length:down": 2.54}, "voice": "tailor"}.'
        ) from error
    strange = [a for a in asks if a not in statement_labels()] + [
        a for a in amounts if a not in number_labels()
    ]
    if strange:
        raise InputError(
            f"{where}: {strange[0]!r} names nothing that can be asked for. See "
            "swifttailor.wishes.labels for the names that are accepted."
        )
    said = [label for label in asks if label not in amounts]
    return SpokenText(
        text,
        kind,
        (*(change_of(label) for label in said), *(change_of(label, n) for label, n in amounts.items())),
    )
