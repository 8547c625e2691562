"""Typing errors in words about the cut: "trosers", "flaerd", "lenght".

The words are those that captions use. Only missing, doubled and swapped letters are corrected: a wrong letter
makes another word as often as an error ("sport" is not "short").
"""

from __future__ import annotations

import re
from functools import cache, lru_cache
from pathlib import Path

from swifttailor.wording.word_tables import read_table
from swifttailor.wording.wordings import all_wordings

SHORTEST = 4
"""Letters: shorter words have too many neighbours."""
_LONGEST = 40
"""Longer ones are no words."""
_WORD = re.compile(r"[^\W\d_]+(?:['-][^\W\d_]+)*")
_PLACE = re.compile(r"{[^}]*}")
_ORDINARY = Path(__file__).with_name("ordinary_words.txt")
_SLIPS = Path(__file__).with_name("common_slips.txt")


def put_right(text: str) -> str:
    """The text with such errors in words about the cut corrected; everything else stays as it is."""
    return _WORD.sub(lambda found: _right(found[0]), text)


@lru_cache(maxsize=8192)
def _right(word: str) -> str:
    small = word.lower()
    known = cut_words()
    if (
        not SHORTEST <= len(small) <= _LONGEST
        or small in known
        or small in ordinary_words()
        or not small.isascii()
    ):
        return word
    # An unknown plural is not an error for its singular, nor the other way round.
    meant = sorted(near for near in neighbours(small) & known if near != f"{small}s" or small[-1] == "s")
    # The longest of several, then the first: a letter is left out more often than added.
    best = max(meant, key=len, default="")
    return best if len(best) >= SHORTEST else word


def common_slip(word: str) -> str | None:
    """The word that people mean who misspell it in a way that is known; None where it is not."""
    return _slips().get(word.lower())


@cache
def _slips() -> dict[str, str]:
    return {wrong: row.words[0] for row in read_table(_SLIPS) for wrong in row.texts}


def neighbours(word: str) -> frozenset[str]:
    """What a word may stand for if a letter is missing, one is doubled or two are swapped."""
    letters = "abcdefghijklmnopqrstuvwxyz-"
    cuts = [(word[:k], word[k:]) for k in range(len(word) + 1)]
    doubled = {a + b[1:] for a, b in cuts if a and b and a[-1] == b[0]}
    longer = {a + letter + b for a, b in cuts for letter in letters}
    exchanged = {a + b[1] + b[0] + b[2:] for a, b in cuts if len(b) > 1}
    return frozenset(doubled | longer | exchanged) - {word}


@cache
def cut_words() -> frozenset[str]:
    """All words of captions, in lower case."""
    found: set[str] = set()
    said = {text for wording in all_wordings() for texts in wording.texts.values() for text in texts}
    for word in set(_WORD.findall(_PLACE.sub(" ", " ".join(said)).lower())):
        found |= {word, word.replace("-", ""), *re.split("['-]", word)}
    return frozenset(found)


@cache
def ordinary_words() -> frozenset[str]:
    """Words that are one such error away from a word about the cut, and are none."""
    lines = _ORDINARY.read_text(encoding="utf-8").splitlines()
    return frozenset(word for line in lines if not line.startswith("#") for word in line.split())
