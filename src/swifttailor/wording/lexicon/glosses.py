"""Texts in languages that have no table of their own, put into English word for word.

Swedish, Danish, Norwegian, Finnish, Polish, Czech, Hungarian, Romanian, Turkish, Russian, Greek, Japanese,
Chinese, Korean, Arabic: so much that a garment is made, or one is changed. What has no gloss stays, and is
told.
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterator, Sequence
from functools import lru_cache
from pathlib import Path
from typing import NamedTuple

from swifttailor.wording.lexicon.reading import read_words

_TABLE = Path(__file__).with_name("glosses.txt")
_GARMENTS, _NOTHING = "garments", "nothing"
_CHANGES, _BESIDE_CHANGES = "changes", "beside changes"
_LEAST_SHARE = 0.5
"""So many of the words of an instruction have to be known."""
_TOKEN = re.compile(r"[\u3040-\u30ff\u3400-\u9fff]+|[^\W\d_]+(?:[-'’][^\W\d_]+)*|[^\w\s]|\d[\d.,]*|\S")
_IDEOGRAPHS = re.compile(r"[\u3040-\u30ff\u3400-\u9fff]+$")
_SAYS_LITTLE = frozenset(["function", "polite", "negations", "degrees", "numbers"])
_SHADES = ("dark", "light")
_LONGEST_PHRASE = 7
_LONGEST_TEXT = 2000
"""Characters; longer texts are stories, of which words alone tell little."""
_UNITS = frozenset(["cm", "mm"])


class _Glossary(NamedTuple):
    exact: dict[str, str]
    stems: dict[str, str]
    marks: frozenset[str]
    """What a text has to say to be read by it: English names of garments, or of changes."""


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
    known = _glossary(False)
    pieces = list(_pieces(text, known))
    meant = [p for p in pieces if p.english not in (None, _NOTHING)]
    if not any(p.english in known.marks for p in meant) or _is_known(text, meant):
        return text
    return _joined(pieces)


def glossed_change(text: str) -> str:
    """An instruction in English, where glosses know enough of its words; else as it is.

    "Lite längre ärmar" and "dłuższa spódnica" are too short to need a grammar: what is to change, and which
    way.

    Args:
        text: In any language.
    """
    if len(text) > _LONGEST_TEXT:
        return text
    glossary = _glossary(True)
    pieces = list(_pieces(text.lower(), glossary))
    words = [p for p in pieces if p.text[0].isalpha() and p.text not in _UNITS]
    meant = [p for p in words if p.english is not None]
    if (
        not any(p.english in glossary.marks for p in meant)
        or len(meant) < _LEAST_SHARE * len(words)
        or _is_known(text, meant)
    ):
        return text
    # Adjectives stand on either side of what they are said of, and articles on neither.
    said = re.sub(r"(?<!\w)the the(?!\w)", "the", _joined(pieces))
    return re.sub(r"(?<!\w)with(?= \d)", "by", said)


def _is_known(text: str, meant: Sequence[_Piece]) -> bool:
    """Whether the tables know as much of a text as glosses do."""
    known = sum(
        len(mark.word.split())
        for mark in read_words(text).marks
        if mark.entries and mark.entries[0].category not in _SAYS_LITTLE
    )
    if all(_is_english(piece.text) for piece in meant):
        return True  # "a denim jacket but as a dress": "a" is a word of Polish, too
    return len(meant) <= known and sum(len(p.text.split()) for p in meant) <= known


def _is_english(text: str) -> bool:
    return all(mark.entries for mark in read_words(text, language="en").marks)


def _joined(pieces: Sequence[_Piece]) -> str:
    shown = [p.text if p.english is None else p.english for p in pieces if p.english != _NOTHING]
    return re.sub(r"\s+([,.;:!?])", r"\1", " ".join(shown).replace("、", ",").replace("。", "."))


def _may_be_glossed(text: str) -> bool:
    words, known = [word.lower() for word in re.findall(r"[A-Za-z]+", text)], _glossary(False)
    return any(_gloss(word, known) in known.marks for word in words)


def _pieces(text: str, known: _Glossary) -> Iterator[_Piece]:
    """The text in words and phrases with their glosses."""
    tokens = _TOKEN.findall(unicodedata.normalize("NFC", text))
    k = 0
    while k < len(tokens):
        if _IDEOGRAPHS.match(tokens[k]):
            yield from _within(tokens[k], known)
            k += 1
            continue
        for count in range(min(_LONGEST_PHRASE, len(tokens) - k), 0, -1):
            said = " ".join(tokens[k : k + count])
            english = _gloss(said.lower(), known)
            if (
                english is None and count == 1 and "-" in said
            ):  # "платье-мешок" is a dress, whatever else it is
                yield from _of_parts(said, known)
                k += count
                break
            if english is not None or count == 1:
                punctuation = not said[0].isalnum()
                yield _Piece(said, said if punctuation and english is None else english)
                k += count
                break


def _of_parts(said: str, known: _Glossary) -> Iterator[_Piece]:
    """The parts of a word with hyphens, where one of them has a gloss; else the word."""
    parts = [_Piece(part, _gloss(part.lower(), known)) for part in said.split("-") if part]
    yield from parts if any(part.english for part in parts) else [_Piece(said, None)]


def _within(run: str, known: _Glossary) -> Iterator[_Piece]:
    """The words of a script that has no spaces, longest first."""
    exact, unknown, k = known.exact, "", 0
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


def _gloss(said: str, known: _Glossary) -> str | None:
    if said in known.exact:
        return known.exact[said]
    fitting = [said[:end] for end in range(len(said), 1, -1) if said[:end] in known.stems]
    fitting = [stem for stem in fitting if stem.count(" ") == said.count(" ")]
    if not fitting:
        return None
    english = known.stems[fitting[0]]
    if english in _SHADES and (rest := said[len(fitting[0]) :].lstrip("oeн-")):  # "ciemnozielony", "mörkblå"
        color = known.exact.get(rest) or (_gloss(rest, known) if len(rest) > 2 else None)
        return f"{english} {color}" if color else english
    return english


@lru_cache(maxsize=2)
def _glossary(changes: bool) -> _Glossary:
    """The words of descriptions, or of instructions, some of which have more words."""
    rows = list(_rows())
    if changes:
        rows.sort(key=lambda row: row[0] not in (_CHANGES, _BESIDE_CHANGES))
    else:
        rows = [row for row in rows if row[0] not in (_CHANGES, _BESIDE_CHANGES)]
    exact: dict[str, str] = {}
    stems: dict[str, str] = {}
    for _, english, word in rows:
        table, said = (stems, word[:-1]) if word.endswith("*") else (exact, word)
        table.setdefault(said, english)
    marks = frozenset(
        english for section, english, _ in rows if section == (_CHANGES if changes else _GARMENTS)
    )
    return _Glossary(exact, stems, marks)


def _rows() -> Iterator[tuple[str, str, str]]:
    """Sections, English words, and each word that means them."""
    section, english = "", ""
    for line in _TABLE.read_text(encoding="utf-8").splitlines():
        if not line.strip() or line.startswith("#"):
            continue
        if line.startswith("["):
            section = line.strip("[]")
            continue
        if not line.startswith(" "):
            english, _, line = line.partition(" : ")
            english = english.strip()
        for word in filter(None, [each.strip().lower() for each in line.split("|")]):
            yield section, english, word
