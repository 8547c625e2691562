"""Slips of the fingers in words of cut: "trosers", "flaerd", "lenght".

The words are those that captions are written of. Only a letter left out, one too many or two exchanged is put
right: a letter that is another makes other words as often ("sport" is not "short").
"""

from __future__ import annotations

import re
from functools import cache

from swifttailor.wording.wordings import all_wordings

SHORTEST = 4
"""Letters: shorter words have too many neighbours."""
_WORD = re.compile(r"[^\W\d_]+(?:['-][^\W\d_]+)*")
_PLACE = re.compile(r"{[^}]*}")
_OTHER = frozenset(
    "arrow arts blow bring come corp cure cured dated edge ether fall fare fill filled font form goes "
    "gorse hand head heath heir here iter iters jean lacks leave lose pain plan point pool raise road "
    "sand shot slack slated sort sorter sorts spar swing symmetric tape ties tire tired trap trapped "
    "traps tree tuned wait waited waits".split()
)
"""Words that stand such a slip from one of cut and are none: those among 31,000 of manuals and programs."""


def put_right(text: str) -> str:
    """The text with such slips in words of cut put right; everything else stays as it is."""
    return _WORD.sub(lambda found: _right(found[0]), text)


def _right(word: str) -> str:
    small = word.lower()
    known = cut_words()
    if len(small) < SHORTEST or small in known or small in _OTHER or not small.isascii():
        return word
    # A plural that is not known is no slip of its singular, nor the other way round.
    meant = sorted(near for near in neighbours(small) & known if near != f"{small}s" or small[-1] == "s")
    # Of several the longest, then the first: a letter is left out more often than added.
    best = max(meant, key=len, default="")
    return best if len(best) >= SHORTEST else word


def neighbours(word: str) -> frozenset[str]:
    """What a word may be if a letter was left out of it or is one too many, or two are exchanged."""
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
