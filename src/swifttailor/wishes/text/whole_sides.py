"""Sides that differ, as the network for people's own words reads them: only where a text speaks of sides."""

from __future__ import annotations

import re

from swifttailor.describing.differences import Change, Gain

_SIDES = re.compile(
    r"(?<!\w)(?:left|right|one|single|other|two|half|side|uneven|unequal|unlike|odd|differ\w*|asym\w*|assym\w*"
    r"|mismatch\w*|lopsided|diagonal\w*|slant\w*|toga|roman|greek|one-\w+|only|lower|longer|shorter)(?!\w)",
    re.IGNORECASE,
)
"""Words without which nothing is said of sides that differ."""
_COUNTS = re.compile(
    r"(?<!\w)(?:one|single|two|only|half)(?:[ -](?!sleeve|shoulder|strap|arm|leg|side)[a-z]+){0,2}?"
    r"[ -](?:pocket|button|zip|piece|row|tier|layer|pleat|dart|colou?r|print|size|seam|belt)s?(?!\w)",
    re.IGNORECASE,
)
"""What such words count instead."""


def speaks_of_sides(text: str) -> bool:
    """Whether a text has a word that may tell sides apart."""
    return _SIDES.search(_COUNTS.sub(" ", text)) is not None


def is_of_one_side(change: Change) -> bool:
    """Whether it makes both sides of a garment differ."""
    if not isinstance(change, Gain):
        return False
    name, value = change.claim.name, str(change.claim.value)
    return (
        name.startswith(("left_", "right_"))
        or value in ("different", "unequal", "asymmetric")
        or value.endswith(" only")
        or value.startswith(("bare ", "lower "))
    )
