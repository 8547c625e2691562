"""Cuffs are deep only where somebody says so: the network takes any word before them for a size."""

from __future__ import annotations

import re
from collections.abc import Sequence

from swifttailor.describing.claims import Claim
from swifttailor.describing.differences import Gain
from swifttailor.wishes.reader import Wish
from swifttailor.wording.lexicon import WordReading

_DEEP = frozenset([Gain(Claim("cuffs", "deep")), Gain(Claim("leg_cuffs", "deep"))])
_SIZE = re.compile(
    r"\b(?:deep|long|wide|high|tall|big|huge|large|oversize|gauntlet|forearm|generous|thick|chunky|broad"
    r"|breit|hoh|tief|lang|gro[sß]|large|haut|profond|ancho|alto|largo|grande|\d)"
)


def without_deep_cuffs(text: str, words: WordReading, found: Sequence[Wish]) -> tuple[Wish, ...]:
    """Drops deep cuffs where no word of the text is one of size, and no name stands for them."""
    named = {Gain(i.claim) for i in words.implications}
    guessed = _DEEP - named if _SIZE.search(text.lower()) is None else frozenset()
    return tuple([wish for wish in found if wish.change not in guessed])
