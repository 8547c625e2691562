"""Shoulders where a name means bare ones and the text wants others.

A prom dress, not low cut, and a sweetheart neckline on a blouse, or between sleeves.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from swifttailor.describing.claims import Claim

if TYPE_CHECKING:
    from swifttailor.wording.lexicon.reading import Implication, WordMark

_STRAPLESS = Claim("shoulders", "strapless")
_NECKS = ("neckline", "collar")
_LOW = frozenset([Claim("neck_depth", "low"), Claim("neck_depth", "plunging")])


def with_covered_shoulders(
    implied: Sequence[Implication], never: Sequence[Claim], marks: Sequence[WordMark]
) -> list[Implication]:
    """What follows from a text, with shoulders where they are meant so.

    Args:
        implied: What follows from its words.
        never: What it refuses.
        marks: Its words.
    """
    implied = _between_sleeves(implied)
    bare = next((i for i in implied if i.claim == _STRAPLESS and not i.said), None)
    if bare is None or not _LOW & set(never) or any(i.said and i.claim.name == "shoulders" for i in implied):
        return list(implied)
    mark = next(mark for mark in marks if mark.denied)
    covered = replace(bare, claim=Claim("shoulders", "both"), certainty="certain", said=True, mark=mark)
    return [*implied, covered]


def _between_sleeves(implied: Sequence[Implication]) -> list[Implication]:
    """What follows with covered shoulders instead of bare ones that a neckline usually has, below sleeves."""
    if any(_is_heart(i.mark) for i in implied):  # what names of blouses imply of the neck is another
        implied = [i for i in implied if i.said or i.claim.name not in _NECKS]
    usual = [i for i in implied if i.claim == _STRAPLESS and i.certainty == "usual" and _is_heart(i.mark)]
    others = [i for i in implied if i.claim.name == "shoulders" and i not in usual]
    if not usual or others or not any(_has_sleeves(i) for i in implied):
        return list(implied)
    covered = [replace(i, claim=Claim("shoulders", "both")) for i in usual]
    return [*[i for i in implied if i not in usual], *covered]


def _is_heart(mark: WordMark) -> bool:
    return any("sweetheart" in entry.cannot for entry in mark.entries)


def _has_sleeves(one: Implication) -> bool:
    """Whether what follows has sleeves: such of any length or shape, or cuffs."""
    return one.claim.name in ("sleeve_shape", "cuffs") or (
        one.claim.name == "sleeves" and one.claim.value != "none"
    )
