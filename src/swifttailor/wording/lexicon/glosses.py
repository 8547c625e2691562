"""Texts in languages that have no table of their own, put into English word for word.

Swedish, Danish, Norwegian, Finnish, Polish, Czech, Hungarian, Romanian, Turkish, Russian, Greek, Japanese,
Chinese, Korean, Arabic: so much that a garment is made. What has no gloss stays, and is told.
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import NamedTuple

from swifttailor.wording.lexicon.reading import read_words

_TABLE = Path(__file__).with_name("glosses.txt")
_GARMENTS, _NOTHING = "garments", "nothing"
_TOKEN = re.compile(r"[\u3040-\u30ff\u3400-\u9fff]+|[^\W\d_]+(?:[-'’][^\W\d_]+)*|[^\w\s]|\d[\d.,]*|\S")
_IDEOGRAPHS = re.compile(r"[\u3040-\u30ff\u3400-\u9fff]+$")
_SAYS_LITTLE = frozenset(["function", "polite", "negations", "degrees", "numbers"])
_SHADES = ("dark", "light")
_LONGEST_PHRASE = 4
_LONGEST_TEXT = 2000
"""Characters; longer texts are stories, of which words alone tell little."""


class _Glossary(NamedTuple):
    exact: dict[str, str]
    stems: dict[str, str]
    garments: frozenset[str]


class _Piece(NamedTuple):
    text: str
    english: str | None
    """None where it has no gloss."""


def glossed(text: str) -> str:
    """A description in English where glosses know more of its words than the tables do; else as it is.

    Args:
        text: In any language.
    """
    if len(text) > _LONGEST_TEXT or (text.isascii() and not _may_be_glossed(text)):
        return text
    pieces = list(_pieces(text))
    meant = [p for p in pieces if p.english not in (None, _NOTHING)]
    garments = [p for p in meant if p.english in _glossary().garments]
    if not garments:
        return text
    known = sum(
        len(mark.word.split())
        for mark in read_words(text).marks
        if mark.entries and mark.entries[0].category not in _SAYS_LITTLE
    )
    if len(meant) <= known and sum(len(p.text.split()) for p in meant) <= known:
        return text
    shown = [p.text if p.english is None else p.english for p in pieces if p.english != _NOTHING]
    return re.sub(r"\s+([,.;:!?])", r"\1", " ".join(shown).replace("、", ",").replace("。", "."))


def _may_be_glossed(text: str) -> bool:
    words = [word.lower() for word in re.findall(r"[A-Za-z]+", text)]
    return any(_gloss(word) in _glossary().garments for word in words)


def _pieces(text: str) -> Iterator[_Piece]:
    """The text in words and phrases with their glosses."""
    tokens = _TOKEN.findall(unicodedata.normalize("NFC", text))
    k = 0
    while k < len(tokens):
        if _IDEOGRAPHS.match(tokens[k]):
            yield from _within(tokens[k])
            k += 1
            continue
        for count in range(min(_LONGEST_PHRASE, len(tokens) - k), 0, -1):
            said = " ".join(tokens[k : k + count])
            english = _gloss(said.lower())
            if english is not None or count == 1:
                punctuation = not said[0].isalnum()
                yield _Piece(said, said if punctuation and english is None else english)
                k += count
                break


def _within(run: str) -> Iterator[_Piece]:
    """The words of a script that has no spaces, longest first."""
    exact, unknown, k = _glossary().exact, "", 0
    while k < len(run):
        found = next((run[k:end] for end in range(len(run), k, -1) if run[k:end] in exact), "")
        if not found:
            unknown += run[k]
            k += 1
            continue
        if unknown:
            yield _Piece(unknown, None)
            unknown = ""
        yield _Piece(found, exact[found])
        k += len(found)
    if unknown:
        yield _Piece(unknown, None)


def _gloss(said: str) -> str | None:
    known = _glossary()
    if said in known.exact:
        return known.exact[said]
    fitting = [said[:end] for end in range(len(said), 1, -1) if said[:end] in known.stems]
    fitting = [stem for stem in fitting if stem.count(" ") == said.count(" ")]
    if not fitting:
        return None
    english = known.stems[fitting[0]]
    if english in _SHADES and (rest := said[len(fitting[0]) :].lstrip("oeн-")):  # "ciemnozielony", "mörkblå"
        color = known.exact.get(rest) or (_gloss(rest) if len(rest) > 2 else None)
        return f"{english} {color}" if color else english
    return english


@cache
def _glossary() -> _Glossary:
    exact: dict[str, str] = {}
    stems: dict[str, str] = {}
    garments: set[str] = set()
    section, english = "", ""
    for line in _TABLE.read_text(encoding="utf-8").splitlines():
        if not line.strip() or line.startswith("#"):
            continue
        if line.startswith("["):
            section = line.strip("[]")
            continue
        if not line.startswith(" "):
            english, _, line = line.partition(" : ")
            if section == _GARMENTS:
                garments.add(english)
        for word in [each.strip().lower() for each in line.split("|")]:
            if word.endswith("*"):
                stems.setdefault(word[:-1], english)
            elif word:
                exact.setdefault(word, english)
    return _Glossary(exact, stems, frozenset(garments))
