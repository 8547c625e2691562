"""Other garments that a text wants made and worn with the one that it names: "over a white T-shirt"."""

from __future__ import annotations

import re

_OVER = re.compile(
    r"(?<!\w)(?:over|under|underneath|beneath|on top of)(?: (?:an?|some|another|matching))+"
    r"(?: (?!(?:my|her|his|their|our|your|the|any|all|other|it)(?!\w))[\w-]+){0,2} ?$",
    re.IGNORECASE,
)


def is_worn_with(before: str) -> bool:
    """Whether what is named next is a garment beside the one that is asked for, and nobody's own yet.

    Args:
        before: The text up to its name.
    """
    return _OVER.search(before) is not None
