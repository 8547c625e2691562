"""Sleeves that are not to be set in: they are raglan sleeves, where the text names no others."""

from __future__ import annotations

from typing import TYPE_CHECKING

from swifttailor.describing.claims import Claim
from swifttailor.pattern.drafts.draft_names import ARMHOLES, RAGLAN
from swifttailor.wording.lexicon import Lack, WordMark, WordReading

if TYPE_CHECKING:
    from swifttailor.wishes.heard import Heard

_SET_IN = "set in sleeves"


def armholes_spoken_of(heard: Heard) -> tuple[Lack, ...]:
    """What a text asks for that armholes may show; raglan sleeves where set-in ones are refused.

    Args:
        heard: What is heard of it.
    """
    refused = None if heard.words is None else _refused(heard.words)
    if refused is None or any(lack.what in ARMHOLES for lack in heard.lacks):
        return heard.lacks
    return (*heard.lacks, Lack(RAGLAN, True, refused))


def refused_sleeve_heads(words: WordReading) -> tuple[Claim, ...]:
    """What no guess may ask for where set-in sleeves are refused.

    It is not refused itself: raglan sleeves are as smooth at the shoulder.
    """
    return () if _refused(words) is None else (Claim("sleeve_shape", "set smooth"),)


def _refused(words: WordReading) -> WordMark | None:
    marks = [mark for mark in words.marks if mark.denied]
    return next((mark for mark in marks if any(e.name == _SET_IN for e in mark.entries)), None)
