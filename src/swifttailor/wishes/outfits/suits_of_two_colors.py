"""Suits in two colours: the jacket is in the first, the trousers or the skirt in the second.

"A white and red suit" is a white jacket and red trousers. Tracksuits and pyjamas have both colours each.
"""

from __future__ import annotations

import re

from swifttailor.garment.cloth_print import KINDS
from swifttailor.wishes.looks.joined_colors import joined_places
from swifttailor.wording.lexicon import WordReading
from swifttailor.wording.lexicon.outfits import named_outfit

_JACKETS = ("blazer", "boxy jacket", "bikini top")
"""Upper halves, by what their names end with, of sets whose halves may differ in colour."""
_BEFORE = re.compile(r"\s+")
_BEHIND = re.compile(r"\s*,?\s*(?:in|aus|en|de)?\s+", re.IGNORECASE)
_WITH = re.compile(r"\s+with(?!\w)", re.IGNORECASE)
_ENDS = re.compile(r"\s*(?:$|[.,;:!?]|(?:with|please|for|mit|für|avec|pour|con|para)(?!\w))", re.IGNORECASE)


def parted_by_color(text: str, words: WordReading) -> str:
    """The text with both halves of a suit named, each with its colour; others as they are.

    Args:
        text: That the lexicon has read.
        words: By the lexicon.
    """
    joined = joined_places(text, words)
    printed = any(e.print is not None and e.print.kind in KINDS for m in words.marks for e in m.entries)
    if len(joined) != 2 or printed or words.language != "en":
        return text
    first, second = (words.colors[k].words for k in joined)
    begin, end = (words.color_marks[k] for k in joined)
    begins = begin.start - (len(first) - len(begin.word))
    for mark in words.marks:
        named = None if mark.denied else named_outfit(mark.word, mark.entries)
        if named is None or not named.upper.endswith(_JACKETS):
            continue
        halves = f"{first} {named.upper} and {second} {named.lower}"
        if _BEFORE.fullmatch(text, end.end, mark.start):
            both = ", both" if _WITH.match(text, mark.end) else ""
            return text[:begins] + halves + both + text[mark.end :]
        if _BEHIND.fullmatch(text, mark.end, begins) and _ENDS.match(text, end.end):
            return text[: mark.start] + halves + text[end.end :]
    return text
