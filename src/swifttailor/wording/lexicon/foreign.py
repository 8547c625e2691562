"""Which language a text is in that is not read, so that a person is told."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Sequence
from functools import cache
from pathlib import Path

from swifttailor.wording.word_tables import read_table

_TABLE = Path(__file__).with_name("foreign.txt")
_WORD = re.compile(r"[^\W\d_]+")
_SCRIPTS = {
    "HIRAGANA": "Japanese",
    "KATAKANA": "Japanese",
    "HANGUL": "Korean",
    "CJK": "Chinese or Japanese",
    "CYRILLIC": "Russian or another language in Cyrillic script",
    "GREEK": "Greek",
    "ARABIC": "Arabic or another language in Arabic script",
    "HEBREW": "Hebrew",
    "DEVANAGARI": "Hindi or another language in Devanagari script",
    "THAI": "Thai",
}
_LEAST = 2
"""Words of a language that have to be there, or half of those that nobody knows."""


def foreign_language(text: str, unknown: Sequence[str]) -> str | None:
    """The language that a text is probably in, where most of it is unknown; None where nothing tells it.

    Args:
        text: Any text.
        unknown: Words of it that the lexicon does not have.
    """
    for letter in text:
        script = _SCRIPTS.get(unicodedata.name(letter, "").partition(" ")[0]) if ord(letter) > 0x250 else None
        if script is not None:
            found = {_SCRIPTS.get(unicodedata.name(each, "").partition(" ")[0]) for each in text}
            return "Japanese" if "Japanese" in found else script
    words = {word.lower() for word in _WORD.findall(text)}
    if not unknown or len(unknown) * 2 < len(words):
        return None
    counts = {language: len(words & known) for language, known in _languages().items()}
    best = max(counts, key=lambda language: counts[language])
    if counts[best] >= _LEAST or (counts[best] and counts[best] * 2 >= len(words)):
        return best
    return None


@cache
def _languages() -> dict[str, frozenset[str]]:
    return {row.words[0]: frozenset(row.texts) for row in read_table(_TABLE)}
