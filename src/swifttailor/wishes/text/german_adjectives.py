"""German adjectives that read as comparisons before a noun: "ein weiter Rock" is wide, not wider."""

from __future__ import annotations

import re

_ADJECTIVES = re.compile(
    r"(?<!\w)(?P<stem>weit|eng|schmal|tief|locker|breit|nieder|hell|dunkl)er(?= [A-ZÄÖÜ][a-zäöüß]{2,})"
)
"""Before a noun of the first case, none of which is a change: "einen weiteren Rock" has another ending."""


def adjectives_plainly(text: str) -> str:
    """The text with these as they end before other nouns: "weite Rock"."""
    return _ADJECTIVES.sub(r"\g<stem>e", text)
