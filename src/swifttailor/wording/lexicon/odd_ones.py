"""What stands alone against several others that a text says: "strapless turtleneck with long sleeves"."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from swifttailor.wording.lexicon.conflicts import exclude

if TYPE_CHECKING:
    from swifttailor.wording.lexicon.reading import Implication

_SEVERAL = 2
"""Other words that it contradicts, and which agree."""


def odd_ones(implied: Sequence[Implication]) -> list[Implication]:
    """What follows from words that contradict two others which agree: these are made.

    Args:
        implied: What follows from the words of a text.
    """
    sure = [i for i in implied if i.certainty == "certain" and i.claim.name != "kind"]
    found = []
    for one in sure:
        against = [o for o in sure if o.mark is not one.mark and exclude(one.claim, o.claim)]
        marks = {id(o.mark): o for o in against}
        if len(marks) < _SEVERAL:
            continue
        if not any(exclude(a.claim, b.claim) for a in against for b in against):
            found.append(one.mark)
    return [i for i in implied if i.said and any(i.mark is mark for mark in found)]
