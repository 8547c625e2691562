"""Whether "short" is said of a garment by itself, and not of its sleeves."""

from __future__ import annotations

import re

_SHORT = re.compile(r"(?<![\w-])short(?![\w-])", re.IGNORECASE)
_SLEEVES_CUT = re.compile(
    r"short\w*(?:[ -][\w'-]+){0,2}[ -](?:sleeve|arm)"
    r"|sleeve[^,.;]*(?:short|small|little|elbow|half|cap|roll|cut)"
    r"|cap(?!\w)|elbow|half|quarter|upper arms?|roll|t[- ]?shirt|cut off|sleeveless|bare",
    re.IGNORECASE,
)
"""What may make sleeves short that are usually long; "short" by itself is said of the hem."""


def is_short_itself(text: str) -> bool:
    """Whether a garment is said to be short, and nothing that its sleeves are."""
    return _SHORT.search(text) is not None and not _SLEEVES_CUT.search(text)
