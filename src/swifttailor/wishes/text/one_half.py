"""One half of what is worn as two: "trouser suit, top half only", "just the jacket of a skirt suit"."""

from __future__ import annotations

import re

_SUIT = (
    r"(?P<suit>(?:(?:trouser|pants?|skirt|business|two[- ]piece|three[- ]piece|linen|dinner|lounge) )?suit"
    r"|tuxedo|tracksuit|pyjamas?|pajamas?|bikini|twin ?set|co-?ord(?: set)?|scrubs)"
)
_UPPER = r"(?:top|upper) (?:half|part|piece)|jackets?|blazers?|tops?"
_LOWER = r"(?:bottom|lower) (?:half|part|piece)|trousers|pants|bottoms?|skirts?|shorts"
_HALF = rf"(?:the )?(?:(?P<upper>{_UPPER})|(?P<lower>{_LOWER}))"
_ONLY = (
    re.compile(rf"(?<![\w-]){_SUIT},? (?:(?:but|so|-) )?{_HALF} only(?!\w)", re.IGNORECASE),
    re.compile(rf"(?<![\w-]){_SUIT},? (?:but |so )?(?:only|just) {_HALF}(?![\w-])", re.IGNORECASE),
    re.compile(
        rf"(?<![\w-])(?:only|just) {_HALF} (?:of|from|for) (?:an?|the|my|his|her) {_SUIT}(?![\w-])",
        re.IGNORECASE,
    ),
)
_NAMES = {
    "tuxedo": ("dinner jacket", "tuxedo trousers"),
    "tracksuit": ("tracksuit jacket", "tracksuit bottoms"),
    "pyjama": ("pyjama top", "pyjama bottoms"),
    "pajama": ("pyjama top", "pyjama bottoms"),
    "bikini": ("bikini top", "bikini bottoms"),
    "twin": ("twinset cardigan", "short sleeved knit top"),
    "scrubs": ("scrub top", "scrub trousers"),
    "skirt": ("blazer", "pencil skirt"),
    "co": ("shirt", "trousers"),
}
"""What the halves are called, by how the name of both begins."""
_OF_SUITS = ("blazer", "tailored trousers")


def of_one_half(text: str) -> str:
    """A text that asks for one half alone, with that called by its name; others as they are.

    Args:
        text: A description in any case, in English.
    """
    for pattern in _ONLY:
        found = pattern.search(text)
        if found is not None:
            suit = found["suit"].lower()
            names = next((two for name, two in _NAMES.items() if suit.startswith(name)), _OF_SUITS)
            return f"{text[: found.start()]}{names[0 if found['upper'] else 1]}{text[found.end() :]}"
    return text
