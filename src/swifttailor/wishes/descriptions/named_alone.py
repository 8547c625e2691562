"""The one garment that a text names, which its other words do not make another of."""

from __future__ import annotations

import re

from swifttailor.wording.lexicon import Implication, WordMark, WordReading

_BESIDE = re.compile(r"\b(?:something|anything|outfit|with|over|under\w*|like|match\w*|for)\b", re.IGNORECASE)
_NO_STORY = 9
"""Marks of a text, at most, that tells nothing of others."""
_LEADS = frozenset(
    "function polite colors shades prints fabrics styles fits lengths occasions sizes degrees numbers".split()
)
"""Categories of words that may stand before the name of the garment that a text begins with."""
_NAMES_THINGS = ("garments", "accessories", "generic")
_WHOLE_KINDS = frozenset({"dress", "jumpsuit", "playsuit"})
"""Kinds with skirts or legs: who speaks of these at length still asks for the whole."""


def kind_named_alone(text: str, words: WordReading) -> list[Implication]:
    """The kind of the one garment that is named, where nothing says that another is meant ("over jeans")."""
    names = [
        m
        for m in words.marks
        if m.role not in ("part", "theirs") and any(e.category in _NAMES_THINGS for e in m.entries)
    ]
    kinds = [i for i in words.implications if i.claim.name == "kind" and i.mark.role == "garment"]
    whole = {i.claim.value for i in kinds} <= _WHOLE_KINDS
    short = len(words.marks) <= _NO_STORY or (len(names) == 1 and _opens_with(names[0], words))
    alone = (short or whole) and len(names) == 1
    alone = alone and not _BESIDE.search(text[: names[0].start])
    return kinds if alone and len({i.claim.value for i in kinds}) == 1 else []


def _opens_with(name: WordMark, words: WordReading) -> bool:
    """Whether a text begins with a name and its adjectives: who then tells a story tells it of that."""
    before = [m for m in words.marks if m.start < name.start]
    return not any(m.denied or not m.entries or m.entries[0].category not in _LEADS for m in before)
