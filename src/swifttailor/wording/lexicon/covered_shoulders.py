"""Shoulders where a name means bare ones and the text wants no low neck: a prom dress, not low cut."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from swifttailor.describing.claims import Claim

if TYPE_CHECKING:
    from swifttailor.wording.lexicon.reading import Implication, WordMark

_STRAPLESS = Claim("shoulders", "strapless")
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
    bare = next((i for i in implied if i.claim == _STRAPLESS and not i.said), None)
    if bare is None or not _LOW & set(never) or any(i.said and i.claim.name == "shoulders" for i in implied):
        return list(implied)
    mark = next(mark for mark in marks if mark.denied)
    covered = replace(bare, claim=Claim("shoulders", "both"), certainty="certain", said=True, mark=mark)
    return [*implied, covered]
