"""Tops and tunics that end at a told height of the legs: half-way down the thigh, at the knee."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import replace

from swifttailor.pattern.drafts.draft_names import NamedDraft

_OF = r"(?:of )?(?:the |my |her |his )?"
_ENDS: Mapping[str, float] = {
    rf"mid[ -]?thighs?|(?:middle|half ?-?way down|halfway to) {_OF}thighs?": 46.0,
    r"(?:just )?above (?:the |my |her |his )?knees?|lower thighs?": 54.0,
    r"(?:to|at) (?:the |my |her |his )?knees?|knee[ -](?:length|long)": 60.0,
}
"""How far below the waist they are, cm, by what a text says."""
_OTHERS = re.compile(
    r"(?<!\w)(?:slits?|splits?|vents?|boots?|socks?|leggings|trousers|jeans|shorts|sleeves?)(?!\w)[^.;,]{0,20}$"
)
"""What is said to be so long instead."""
_LENGTH, _LONG_CM = "length", 30.0
_FROM_THE_SHOULDER = ("t-shirt", "tank-top", "shirt", "turtleneck", "camisole")


def to_the_legs_as_said(draft: NamedDraft, text: str) -> NamedDraft:
    """A long top that ends where a text says; others as they are.

    Args:
        draft: As it goes with all else that is asked for.
        text: The words.
    """
    options = dict(draft.options)
    if draft.name not in _FROM_THE_SHOULDER or float(options.get(_LENGTH, 0.0)) < _LONG_CM:
        return draft
    for words, length in _ENDS.items():
        found = re.search(rf"(?<!\w)(?:{words})(?!\w)", text, re.IGNORECASE)
        if found is not None and not _OTHERS.search(text[: found.start()].lower()):
            return replace(draft, options=tuple({**options, _LENGTH: length}.items()))
    return draft
