"""That there is a collar, where a text names one: a network takes one of an unknown kind for none."""

from __future__ import annotations

from swifttailor.describing.claims import Claim
from swifttailor.wording.lexicon import WordReading

_COLLAR = "collar"
_NO_COLLAR = Claim(_COLLAR, "none")


def named_collars(words: WordReading) -> tuple[Claim, ...]:
    """What a text that names a collar cannot mean: that there is none; nothing where it denies one.

    Args:
        words: By the lexicon.
    """
    told = [i.claim for i in words.implications if i.said and i.claim.name == _COLLAR and not i.mark.denied]
    denied = any(
        mark.denied and any(entry.part == _COLLAR or _is_of_collars(entry.claims()) for entry in mark.entries)
        for mark in words.marks
    )
    named = bool(told) and _NO_COLLAR not in told
    return (_NO_COLLAR,) if named and not denied else ()


def _is_of_collars(claims: tuple[Claim, ...]) -> bool:
    return any(claim.name == _COLLAR for claim in claims)
