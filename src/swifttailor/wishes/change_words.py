"""The words of changes, from their table, as patterns that find them."""

from __future__ import annotations

import re
from dataclasses import dataclass
from functools import cache
from pathlib import Path

from swifttailor.wishes.change_parts import PARTS, Property
from swifttailor.wording.word_tables import Row, read_table

_TABLE = Path(__file__).with_name("change_words.txt")
_PROPERTIES: tuple[Property, ...] = ("length", "width", "height")
_SIGNS = {"+": 1, "-": -1}


@dataclass(frozen=True, slots=True)
class ChangeWord:
    """A word that says that something is to grow or to shrink, with its place in a text."""

    start: int
    end: int
    what: Property
    sign: int


@dataclass(frozen=True, slots=True)
class PartWord:
    """A part of a garment that a text names."""

    start: int
    end: int
    part: str
    word: str


def find_changes(text: str) -> list[ChangeWord]:
    """Words of changes in their order: "longer", "too tight", "less baggy".

    Args:
        text: In lower case.
    """
    pattern, meaning = _compiled()
    found = []
    for match in pattern.finditer(text):
        if match["adjective"]:
            what, sign = meaning["adjectives"][match["adjective"]]
            found.append(ChangeWord(match.start(), match.end(), what, sign if match["more"] else -sign))
        else:
            found.append(ChangeWord(match.start(), match.end(), *meaning["grow"][match["grow"]]))
    return found


def find_adjectives(text: str) -> list[ChangeWord]:
    """Adjectives that say what something is to be like: "make it tight".

    Args:
        text: In lower case.
    """
    _, meaning = _compiled()
    return [
        ChangeWord(m.start(), m.end(), *meaning["adjectives"][m[0]]) for m in _adjectives().finditer(text)
    ]


@cache
def _adjectives() -> re.Pattern[str]:
    return _any_of(list(_compiled()[1]["adjectives"]))


def find_parts(text: str) -> list[PartWord]:
    """Parts of garments that a text names, in their order.

    Args:
        text: In lower case.
    """
    pattern, part_of = _parts()
    return [PartWord(m.start(), m.end(), part_of[m[0]], m[0]) for m in pattern.finditer(text)]


@cache
def kept_words() -> re.Pattern[str]:
    """What says that something is to stay."""
    return _any_of([word for row in _rows("keep") for word in row.texts])


@cache
def target_words() -> str:
    """A pattern of the words before what a garment is to become."""
    return _any_of([word for row in _rows("target") for word in row.texts]).pattern


@cache
def _compiled() -> tuple[re.Pattern[str], dict[str, dict[str, tuple[Property, int]]]]:
    meaning: dict[str, dict[str, tuple[Property, int]]] = {"grow": {}, "adjectives": {}}
    for section, found in meaning.items():
        for row in _rows(section):
            what, sign = row.words
            if what not in _PROPERTIES or sign not in _SIGNS:
                row.wrong(f"'{what} {sign}' is no property with + or -.")
            found.update(dict.fromkeys(row.texts, (what, _SIGNS[sign])))
    more, less, adjective, grow = (
        _any_of(list(words)).pattern
        for words in (
            [word for row in _rows("more") for word in row.texts],
            [word for row in _rows("less") for word in row.texts],
            meaning["adjectives"],
            meaning["grow"],
        )
    )
    degree = r"(?:(?:a )?(?:bit|lil|little|tad|tiny bit|touch) )?"
    pattern = rf"(?:(?P<more>{more})|(?P<less>{less})) {degree}(?P<adjective>{adjective})|(?P<grow>{grow})"
    return re.compile(pattern), meaning


@cache
def _parts() -> tuple[re.Pattern[str], dict[str, str]]:
    found = {}
    for row in _rows("parts"):
        if len(row.words) != 1 or row.words[0] not in PARTS:
            row.wrong(f"{' '.join(row.words)!r} is no part. Known: {', '.join(sorted(PARTS))}.")
        found.update(dict.fromkeys(row.texts, row.words[0]))
    return _any_of(list(found)), found


def _any_of(words: list[str]) -> re.Pattern[str]:
    longest = sorted(map(re.escape, words), key=len, reverse=True)
    return re.compile(rf"(?<!\w)(?:{'|'.join(longest)})(?!\w)")


def _rows(section: str) -> list[Row]:
    return [row for row in _table() if row.section == section]


@cache
def _table() -> list[Row]:
    return read_table(_TABLE)
