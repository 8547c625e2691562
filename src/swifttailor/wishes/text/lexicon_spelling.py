"""Spellings of the lexicon's words that sound alike: "assymetric", "hoddie", "batteau"; and nearest names.

A slip is put right only where one word of the lexicon alone is spelt like it, but for doubled letters and
letters that sound the same; the text is then shown as it was read. Names that are merely near are guesses.
"""

from __future__ import annotations

import difflib
import re
from collections.abc import Iterable
from functools import cache

from swifttailor.wishes.text.spelling import neighbours, ordinary_words
from swifttailor.wording.lexicon import all_entries

SHORTEST = 5
"""Letters: shorter words have too many neighbours."""
NEAR, MOST_NEAR = 0.72, 3
CLOSE = 0.8
"""How alike a name has to be to be made as a guess."""
_LONGEST = 40
_SOUNDS = (
    ("ck", "k"),
    ("ph", "f"),
    ("c", "k"),
    ("y", "i"),
    ("z", "s"),
    ("ea", "e"),
    ("ee", "e"),
    ("ie", "i"),
    ("ar", "er"),
    ("our", "er"),
    ("or", "er"),
)
_DOUBLED = re.compile(r"(.)\1+")
_SILENT = re.compile(r"e(?=s?$)")
"""At the end of a word nobody hears it: "slevs"."""


def lexicon_spelling(word: str) -> str | None:
    """The word of the lexicon that is spelt like another; None where none is, or several are.

    Args:
        word: That nobody knows.
    """
    small = word.lower()
    if len(small) < SHORTEST or len(small) > _LONGEST or not small.isascii() or not small.isalpha():
        return None
    if small in ordinary_words():
        return None
    slips = [
        near for near in neighbours(small) & _all_words() if near[0] == small[0] and len(near) >= SHORTEST
    ]
    slips = [near for near in slips if near != f"{small}s"]
    if len(slips) == 1:
        return slips[0]
    meant = _by_sound().get(_sound(small), frozenset())
    same = sorted(known for known in meant if known[0] == small[0])
    parts = [known for known in same if known in _parts()]
    same = parts or same
    if len(same) > 1 and len({place for place, known in _places() if known in same}) > 1:
        return None
    if not same:
        return None
    return max(same, key=lambda known: difflib.SequenceMatcher(None, small, known).ratio())


def near_names(words: Iterable[str]) -> tuple[str, ...]:
    """Names of garments that are spelt like words that were not understood, for each the likeliest first."""
    found = [
        difflib.get_close_matches(word[:_LONGEST].lower(), garment_names(), MOST_NEAR, NEAR)
        for word in list(words)[:MOST_NEAR]
    ]
    return tuple(dict.fromkeys([name for names in found for name in names]))


def guessed_name(words: Iterable[str]) -> tuple[str, str] | None:
    """A word that nobody knows, with the name of a garment that it most likely is; None where none is."""
    for word in list(words)[:MOST_NEAR]:
        small = word[:_LONGEST].lower()
        if len(small) < SHORTEST or not small.isalpha() or not small.isascii():
            continue
        near = difflib.get_close_matches(small, garment_names(), 1, CLOSE)
        if near and near[0][0] == small[0]:
            return word, near[0]
    return None


def _sound(word: str) -> str:
    for written, heard in _SOUNDS:
        word = word.replace(written, heard)
    return _SILENT.sub("", _DOUBLED.sub(r"\1", word))


@cache
def _by_sound() -> dict[str, frozenset[str]]:
    found: dict[str, set[str]] = {}
    for entry in all_entries():
        if entry.english is not None:
            continue
        for text in entry.words:
            word = text.lower()
            if word.isalpha() and word.isascii() and len(word) >= SHORTEST - 1:
                found.setdefault(_sound(word), set()).add(word)
    return {sound: frozenset(words) for sound, words in found.items()}


@cache
def _all_words() -> frozenset[str]:
    """Single words of the English tables."""
    words = [text.lower() for entry in all_entries() if entry.english is None for text in entry.words]
    return frozenset([word for word in words if word.isalpha() and word.isascii()])


@cache
def _parts() -> frozenset[str]:
    """What parts of garments are called: likelier than anything else of the same sound."""
    return frozenset([w.lower() for e in all_entries() if e.category == "parts" for w in e.words])


@cache
def _places() -> list[tuple[tuple[str, int], str]]:
    """Where in the tables each word stands."""
    return [(entry.place, word.lower()) for entry in all_entries() for word in entry.words]


@cache
def garment_names() -> tuple[str, ...]:
    """All names of garments of the lexicon, in lower case."""
    entries = [entry for entry in all_entries() if entry.category == "garments"]
    return tuple([word.lower() for entry in entries for word in entry.words])


def is_garment(name: str) -> bool:
    """Whether a name in lower case is that of a garment."""
    return name in _name_set()


@cache
def _name_set() -> frozenset[str]:
    return frozenset(garment_names())
