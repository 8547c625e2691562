"""Tables of sayings: patterns with the plain words that stand for what they find."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import NoReturn

from swifttailor.errors import InputError

_PARTS, _SAYINGS, _RULES, _ASIDES = "parts of patterns", "sayings", "rules", "asides"
_NAMED = re.compile(r"\{([a-z_]+)\}")
_GROUP, _REFERENCE = re.compile(r"\(\?P<\w+>"), re.compile(r"\(\?P=|\\[1-9]")
_WORD_BEGINS = r"(?<![\w-])"
_NOTHING = "-"


@dataclass(frozen=True)
class Saying:
    """A pattern, and what is said plainly in place of what it finds."""

    text: str
    """Of the pattern, which is found where a word begins."""
    place: str
    """Where it stands, for messages."""
    plain: str
    kinds: frozenset[str]
    """Of garments that it is said of; of all where there are none."""

    @cached_property
    def pattern(self) -> re.Pattern[str]:
        """Made when it is first needed: of hundreds, few ever are.

        Raises:
            InputError: It is no pattern.
        """
        try:
            return re.compile(f"{_WORD_BEGINS}(?:{self.text})")
        except re.error as error:
            raise InputError(f"{self.place}: the pattern cannot be read: {error}.") from error


@dataclass(frozen=True)
class SayingsTable:
    """A table that was read."""

    sayings: tuple[Saying, ...]
    rules: Mapping[str, re.Pattern[str]]
    """Patterns that are used by their names."""
    asides: tuple[Saying, ...] = ()
    """What is put plainly before anything else is read: words of the cut that mean none there."""

    @cached_property
    def any_saying(self) -> re.Pattern[str]:
        """Finds something where any of the `sayings` does: most texts have none, and one search is quicker.

        Raises:
            InputError: One of them has no pattern that can be read.
        """
        return _any_of(self.sayings)

    @cached_property
    def any_aside(self) -> re.Pattern[str]:
        """The same of `asides`."""
        return _any_of(self.asides)


def _any_of(sayings: Sequence[Saying]) -> re.Pattern[str]:
    unnamed = "|".join(_GROUP.sub("(?:", saying.text) for saying in sayings)
    try:
        return re.compile(f"{_WORD_BEGINS}(?:{unnamed})" if unnamed else "(?!)")
    except re.error:
        for saying in sayings:
            saying.pattern  # noqa: B018  # the one that is wrong says so
        raise


def read_sayings(path: Path) -> SayingsTable:
    """Reads a table of sayings; its head says how it is written.

    Args:
        path: The file.

    Raises:
        InputError: The file cannot be read, or a line is wrong; the message names file and line. Patterns of
            sayings are read when they are first needed.
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
            if section == _RULES:
                try:
                    rules[head] = re.compile(text)
                except re.error as error:
                    wrong(number, f"the pattern cannot be read: {error}.")
            elif _REFERENCE.search(text):
                wrong(number, "a saying may not refer to its own groups: all are searched as one pattern.")
            else:
                plain, _, kinds = head.partition("  of:")
                plain = "" if plain == _NOTHING else plain
                place = f"{path.name}, line {number}"
                saying = Saying(text, place, plain, frozenset(kinds.split(",")) - {""})
                (asides if section == _ASIDES else sayings).append(saying)
    return SayingsTable(tuple(sayings), rules, tuple(asides))
