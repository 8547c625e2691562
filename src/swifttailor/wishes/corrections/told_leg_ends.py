"""Legs end where words say: "cropped" ones are not full, whatever else is read of a text."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from swifttailor.describing.differences import Gain
from swifttailor.wishes.reader import Wish
from swifttailor.wording.lexicon import WordReading

_LONG = ("calf", "ankle", "full")


def with_told_leg_ends(found: Sequence[Wish], words: WordReading) -> tuple[Wish, ...]:
    """What is heard, with the legs as long as a word about their length says.

    Args:
        found: What is heard so far.
        words: By the lexicon.
    """
    said = [i.claim for i in words.implications if i.said and i.claim.name == "leg_hem"]
    if len(said) != 1 or said[0].value not in _LONG:
        return tuple(found)
    told = Gain(said[0])
    others = [w for w in found if _is_of_long_legs(w) and w.change != told]
    if any(w.change == told for w in found) or not others:
        return tuple([w for w in found if w not in others])
    return tuple([replace(w, change=told) if w is others[0] else w for w in found if w not in others[1:]])


def _is_of_long_legs(wish: Wish) -> bool:
    claim = wish.change.claim if isinstance(wish.change, Gain) else None
    return claim is not None and claim.name == "leg_hem" and claim.value in _LONG
