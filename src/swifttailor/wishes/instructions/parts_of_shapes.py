"""Which part is meant by a shape that only one part of a garment has: a top that is to be "less puffy"."""

from __future__ import annotations

import re
from collections.abc import Callable

from swifttailor.describing.claims import Claim

_PUFFED = re.compile(r"(?<!\w)(?:puff\w*|poof\w*|pouf\w*|floof\w*|balloon\w*|billow\w*)(?!\w)")
_BELLED = re.compile(r"(?<!\w)(?:flar\w*|bell\w*)(?!\w)")
_FULL_SLEEVES = tuple(Claim("sleeve_shape", value) for value in ("puffed", "balloon", "gathered end"))
_FULL_SKIRTS = tuple(
    Claim("skirt", value)
    for value in (
        "gathered",
        "tiered",
        "gathered tiers",
        "circle",
        "more than a circle",
        "three-quarter circle",
    )
)
_BELL = Claim("sleeve_shape", "bell")
_SPREAD = (*_FULL_SKIRTS, Claim("skirt", "flared"), Claim("skirt", "half circle"), Claim("bodice", "flared"))
_NO_SLEEVES = Claim("sleeves", "none")


def part_of_shape(word: str, kind: str, is_so: Callable[[Claim], bool]) -> str | None:
    """The part whose shape a word of change names, where the garment has but one such part.

    Args:
        word: The word of change, in lower case: "less puffy".
        kind: Of the garment.
        is_so: Whether a claim is true of it.
    """
    if kind in ("skirt", "trousers", "shorts") or is_so(_NO_SLEEVES):
        return None
    if _PUFFED.search(word) and not any(map(is_so, _FULL_SKIRTS)):
        skirtless = kind in ("top", "tunic", "jumpsuit", "playsuit")
        return "sleeves" if skirtless or any(map(is_so, _FULL_SLEEVES)) else None
    if _BELLED.search(word) and is_so(_BELL) and not any(map(is_so, _SPREAD)):
        return "sleeve_end"
    return None
