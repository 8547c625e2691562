"""What garments are called by one of their parts: a "kimono-sleeved top" is a top with kimono sleeves."""

from __future__ import annotations

import re

from swifttailor.wording.lexicon import read_words

_PARTS = {
    "sleeved": "sleeves",
    "necked": "neck",
    "collared": "collar",
    "legged": "legs",
    "waisted": "waist",
    "backed": "back",
    "hemmed": "hem",
    "skirted": "skirt",
    "cuffed": "cuffs",
    "strapped": "straps",
}
"""How a part is called behind what it is like."""
_JOINED = re.compile(rf"(?<![\w-])([^\W\d_]+(?:-[^\W\d_]+)*)[- ]({'|'.join(_PARTS)})(?![\w-])", re.IGNORECASE)
_COUNTS = frozenset({"one", "two", "three", "half", "full", "both"})
"""Words that say nothing of what a part is like."""


def with_parts_apart(text: str) -> str:
    """The text with such words as the part and what it is like, where the lexicon knows these and not those.

    Args:
        text: In English.
    """

    def apart(found: re.Match[str]) -> str:
        like, part = found[1], _PARTS[found[2].lower()]
        if like.lower() in _COUNTS or _is_one(found[0]):
            return found[0]
        named = next(
            (name for name in (f"{like} {part}", f"{like} {part.removesuffix('s')}") if _is_one(name)), None
        )
        return found[0] if named is None else named

    return _JOINED.sub(apart, text)


def _is_one(words: str) -> bool:
    """Whether the lexicon has some words as one entry."""
    marks = read_words(words, language="en").marks
    return len(marks) == 1 and bool(marks[0].entries) and (marks[0].start, marks[0].end) == (0, len(words))
