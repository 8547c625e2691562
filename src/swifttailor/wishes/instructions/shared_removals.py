"""Parts that go together: of "remove the hood and the cuffs" each is to be removed."""

from __future__ import annotations

import re

_PART = (
    r"(?:collar|hood|sleeves?|cuffs?|belt|buttons|pockets?|slits?|waistband|ruffles?|frills?|straps?|drawstring|zip|lapels?"
    r"|peplum|bow|ties?|hem band|turtleneck|flounces?|tiers|gathers|darts|pleats)"
)
_SHARED = re.compile(
    rf"(?<!\w)(?P<verb>remove the|remove|without(?: the| an?| any)?|no|lose the|get rid of the|take off the)"
    rf" (?P<one>(?:[\w-]+ )?{_PART}),? (?P<and>and|&|or|nor|plus) (?:the |its |my )?"
    rf"(?P<other>{_PART})(?=\s*(?:$|[.,;!?&]|(?:and|or|but|please|too|as well|instead|for|then)(?!\w)))"
)
_LISTED = re.compile(
    rf"(?<!\w)(?P<verb>remove the|no|without(?: the| an?| any)?)"
    rf" (?P<one>{_PART}), (?:the |its |my )?(?P<other>{_PART})"
    rf"(?=,? (?:and|or|&) (?:the |its |my )?{_PART}(?:\s*(?:$|[.,;!?])| please))"
)


def parted(text: str) -> str:
    """An instruction in which each part that is to go is told to go.

    Args:
        text: In lower case.
    """
    for pattern in (_LISTED, _LISTED, _SHARED):
        text = pattern.sub(_each, text)
    return text


def _each(found: re.Match[str]) -> str:
    return f"{found['verb']} {found['one']} and {found['verb']} {found['other']}"
