"""Legs end where words say: "cropped" ones are not full, whatever else is read of a text."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from swifttailor.describing.claims import Claim
from swifttailor.describing.differences import Gain
from swifttailor.wishes.reader import Wish
from swifttailor.wording.lexicon import WordReading

_FULL = Gain(Claim("leg_hem", "full"))


def with_told_leg_ends(found: Sequence[Wish], words: WordReading) -> tuple[Wish, ...]:
    """What is heard, with the legs as long as a word about their length says.

    Args:
        found: What is heard so far.
        words: By the lexicon.
    """
    said = [i.claim for i in words.implications if i.said and i.claim.name == "leg_hem"]
    ends = [w.change for w in found if isinstance(w.change, Gain) and w.change.claim.name == "leg_hem"]
    if ends != [_FULL] or len(said) != 1 or said[0] == _FULL.claim:
        return tuple(found)
    return tuple([replace(w, change=Gain(said[0])) if w.change == _FULL else w for w in found])
