"""Whether a text asks for big buttons, where a colour stands between the size and the buttons."""

from __future__ import annotations

import re
from collections.abc import Sequence

BIG = "big buttons"
"""Name of the trim."""
_SIZE = (
    r"big|large|huge|giant|oversized|chunky|gro(?:ß|ss)en?|dicken?|riesigen?|gros|grands|grandes?|grandi|gordos"
    r"|grote|dikke"
)
_NOUN = r"buttons?|knöpfen?|knopen|boutons|botones|bottoni|botões"
_FOUND = re.compile(rf"(?<!\w)(?:{_SIZE}),? (?:[^\W\d_]+,? ){{0,2}}(?:{_NOUN})(?!\w)", re.IGNORECASE)
_OTHER = re.compile(
    r"pockets?|collar|and|with|und|mit|et|avec|y|con|e|com|en|met|no|without|of", re.IGNORECASE
)


def asks_for_big_buttons(text: str) -> bool:
    """Whether the buttons that a text asks for are to be big: "big brown buttons".

    Args:
        text: In English, German, French, Spanish, Italian, Dutch or Portuguese.
    """
    return bool(spans_of_big_buttons(text))


def spans_of_big_buttons(text: str) -> list[tuple[int, int]]:
    """Where a text says so: first letter and one past the last."""
    return [
        match.span()
        for match in _FOUND.finditer(text)
        if not any(_OTHER.fullmatch(word.strip(",")) for word in match[0].split()[1:-1])
    ]


def not_of_buttons(text: str, unknown: Sequence[str]) -> tuple[str, ...]:
    """Words in no table but those that say so: "große" of other things is none of the tables' words."""
    said = {word.casefold() for start, end in spans_of_big_buttons(text) for word in text[start:end].split()}
    return tuple([word for word in unknown if word.casefold() not in said])
