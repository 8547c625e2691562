"""Outfits of which a text names the trousers alone, and says of the rest that it has a hood."""

from __future__ import annotations

import re

_LOWER = r"(?P<lower>(?:[\w-]+ ){0,3}(?:trousers|pants|leggings|breeches|jeans|joggers|shorts))"
_HOODED = re.compile(
    rf"(?P<before>(?:[\w-]+ ){{0,4}})\b(?:outfit|set|costume|look)s?\b\s*[:,-]? (?:with |of )?{_LOWER}"
    r",? (?:and |with )?(?:an? |the )?(?:hooded|hood)\W*$",
    re.IGNORECASE,
)


def with_hooded_top(text: str) -> str:
    """The text with a hooded top named: "leather outfit, tight trousers, hooded" has one.

    Args:
        text: As it was given.
    """
    return _HOODED.sub(r"\g<before>hooded top and \g<before>\g<lower>", text)
