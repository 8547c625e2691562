"""The clauses of an instruction: "give it long sleeves" and "make it 20 cm longer".

The network reads one request better than several: it may take the centimetres of one for those of another.
A clause begins where an instruction could begin. "Remove the sleeves and the collar" is one clause, since its
second half would ask for a collar if it stood alone.
"""

from __future__ import annotations

import re
from functools import cache

from swifttailor.wording.instructions.requests import gain_words, step_words

_JOINT = re.compile(
    r"\s*(?:[.;:!?,]\s+(?:(?:and|but)\s+)?|\s(?:and|but|&|\+)\s+)(?:(?:also|then|please)\s+)*", re.IGNORECASE
)
_WORD = re.compile(r"[^\W\d_]+")
_OTHER_VERBS = frozenset({"delete", "get", "lose", "turn"})
_WITHOUT_VERB = re.compile(r"\d|(?:the \w+ )?(?:\d|\w{3,}er\b)|no\b|with(?:out)?\b", re.IGNORECASE)
"""What needs no verb of its own: "and 10 cm longer", "and the sleeves wider", "but no hood"."""


def clauses(text: str) -> list[tuple[int, int]]:
    """Where the clauses of a text begin and end, in their order; one where no part of it can stand alone.

    Args:
        text: An instruction of any length; the time is in proportion to it.
    """
    found, start = [], 0
    for joint in _JOINT.finditer(text):
        word = _WORD.match(text, joint.end())
        verb = word is not None and word[0].lower() in _verbs()
        if verb or _WITHOUT_VERB.match(text, joint.end()):
            found.append((start, joint.start()))
            start = joint.end()
    return [(first, end) for first, end in (*found, (start, len(text))) if text[first:end].strip()]


@cache
def _verbs() -> frozenset[str]:
    """What requests begin with: add, give, make, remove, ..."""
    steps = (text for words in step_words().values() for text in (*words.texts, *words.texts_by))
    gains = (text for wording in gain_words() for text in wording.texts)
    first = (_WORD.match(text) for text in (*steps, *gains))
    return _OTHER_VERBS.union(found[0].lower() for found in first if found is not None)
