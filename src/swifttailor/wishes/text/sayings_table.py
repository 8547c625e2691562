"""Tables of sayings: patterns with the plain words that stand for what they find."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import NoReturn

from swifttailor.errors import InputError

_PARTS, _SAYINGS, _RULES, _ASIDES = "parts of patterns", "sayings", "rules", "asides"
_NAMED = re.compile(r"\{([a-z_]+)\}")
_NOTHING = "-"


@dataclass(frozen=True)
class Saying:
    """A pattern, and what is said plainly in place of what it finds."""

    pattern: re.Pattern[str]
    plain: str
    kinds: frozenset[str]
    """Of garments that it is said of; of all where there are none."""


@dataclass(frozen=True)
class SayingsTable:
    """A table that was read."""

    sayings: tuple[Saying, ...]
    rules: Mapping[str, re.Pattern[str]]
    """Patterns that are used by their names."""
    asides: tuple[Saying, ...] = ()
    """What is put plainly before anything else is read: words of the cut that mean none there."""


def read_sayings(path: Path) -> SayingsTable:
    """Reads a table of sayings; its head says how it is written.

    Args:
        path: The file.

    Raises:
        InputError: The file cannot be read, or a line is wrong; the message names file and line.
    """
    try:
        lines = path.read_text(encoding="utf-8").splitlines()
    except (OSError, UnicodeDecodeError) as error:
        raise InputError(f"Cannot read the table of sayings '{path}': {error}.") from error
    parts: dict[str, str] = {}
    rules: dict[str, re.Pattern[str]] = {}
    sayings: list[Saying] = []
    asides: list[Saying] = []
    section, head = "", ""

    def wrong(number: int, what: str) -> NoReturn:
        raise InputError(f"{path.name}, line {number}: {what}")

    for number, line in enumerate(lines, start=1):
        said = line.strip()
        if not said or line.startswith("#"):
            continue
        if line.startswith("[") and line.endswith("]"):
            section, head = line[1:-1], ""
            known = (_PARTS, _SAYINGS, _RULES, _ASIDES)
            if section not in known:
                wrong(number, f"there is no section '{section}'. Known: {', '.join(known)}.")
        elif not line.startswith(" "):
            head = said
        elif not head:
            wrong(number, "a pattern stands under no line of plain words.")
        elif section == _PARTS:
            parts[head] = said
        else:
            unknown = [name for name in _NAMED.findall(said) if name not in parts]
            if unknown:
                wrong(number, f"there is no part of patterns '{unknown[0]}'. Known: {', '.join(parts)}.")
            text = _NAMED.sub(lambda found: parts[found[1]], said)
            try:
                pattern = re.compile(text if section == _RULES else rf"(?<![\w-])(?:{text})")
            except re.error as error:
                wrong(number, f"the pattern cannot be read: {error}.")
            if section == _RULES:
                rules[head] = pattern
            else:
                plain, _, kinds = head.partition("  of:")
                plain = "" if plain == _NOTHING else plain
                saying = Saying(pattern, plain, frozenset(kinds.split(",")) - {""})
                (asides if section == _ASIDES else sayings).append(saying)
    return SayingsTable(tuple(sayings), rules, tuple(asides))
