"""Tops and tunics that end at a told height of the legs: half-way down the thigh, at the knee."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import replace
from typing import TYPE_CHECKING

from swifttailor.pattern.drafts.draft_names import NamedDraft

if TYPE_CHECKING:
    from swifttailor.wishes.heard import Heard

_OF = r"(?:of )?(?:the |my |her |his )?"
_ENDS: Mapping[str, float] = {
    rf"mid[ -]?thighs?|(?:middle|half ?-?way down|halfway to) {_OF}thighs?": 46.0,
    r"(?:just )?above (?:the |my |her |his )?knees?|lower thighs?": 54.0,
    r"(?:to|at|below|over|past) (?:the |my |her |his )?knees?|knee[ -](?:length|long)|cal(?:f|ves)|ankles?"
    r"|shins?|floor|ground": 60.0,
}
"""How far below the waist they are, cm, by what a text says."""
_OTHERS = re.compile(
    r"(?<!\w)(?:slits?|splits?|vents?|boots?|socks?|leggings|trousers|jeans|shorts|sleeves?)(?!\w)[^.;,]{0,20}$"
)
"""What is said to be so long instead."""
_LENGTH, _LONG_CM = "length", 30.0
_FROM_THE_SHOULDER = ("t-shirt", "tank-top", "shirt", "turtleneck", "camisole")
_OPEN: Mapping[str, float] = {
    "cardigan": 60.0,
    "blazer": 60.0,
    "sweatshirt": 50.0,
    "hoodie": 46.0,
    "waistcoat": 40.0,
}
"""That are as long where a text makes coats of them, and how long they may be."""
_TOPS = frozenset({"top", "tunic"})


def is_long_top(heard: Heard) -> bool:
    """Whether a dress is heard where a top is named: one to the knee."""
    marks = () if heard.words is None else heard.words.marks
    named = [e for m in marks if m.role == "garment" and not m.denied for e in m.entries if e.kinds]
    return heard.kind == "dress" and bool(named) and all(entry.kinds <= _TOPS for entry in named)


def to_the_legs_as_said(draft: NamedDraft, text: str, *, long: bool = False) -> NamedDraft:
    """A long top that ends where a text says; others as they are.

    Args:
        draft: As it goes with all else that is asked for.
        text: The words.
        long: Whether it is as long as a dress (`is_long_top`), whatever its draft is usually.
    """
    options = dict(draft.options)
    if draft.name not in (*_FROM_THE_SHOULDER, *(_OPEN if long else ())):
        return draft
    if not long and float(str(options.get(_LENGTH, 0.0))) < _LONG_CM:
        return draft
    for words, length in _ENDS.items():
        found = re.search(rf"(?<!\w)(?:{words})(?!\w)", text, re.IGNORECASE)
        if found is not None and not _OTHERS.search(text[: found.start()].lower()):
            length = min(length, _OPEN.get(draft.name, length))
            return replace(draft, options=tuple({**options, _LENGTH: length}.items()))
    return draft
