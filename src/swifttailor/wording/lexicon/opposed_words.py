"""Words of a text that cannot both be true of one garment: "short maxi dress"."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

from swifttailor.describing.claims import Claim
from swifttailor.wording.lexicon.conflicts import opposed
from swifttailor.wording.lexicon.entries import Certainty
from swifttailor.wording.lexicon.two_places import of_two_places

if TYPE_CHECKING:
    from swifttailor.wording.lexicon.reading import Implication, WordMark

_SHORTS, _TO_THE_FEET = Claim("kind", "shorts"), Claim("leg_hem", "full")
_NO_SLEEVES, _PUFFED = Claim("sleeves", "none"), Claim("sleeve_shape", "puffed")
_NAMED_BY: Mapping[str, re.Pattern[str]] = {
    "sleeves": re.compile("sleeve", re.IGNORECASE),
    "collar": re.compile("collar|lapel|neck", re.IGNORECASE),
}
"""What a name says itself of sleeves and collars: a "turtleneck" has no other one."""
_FROM_THE_KNEE = re.compile("knee|trumpet|bell|boot", re.IGNORECASE)
_TOLD_BY: Mapping[bool, tuple[Certainty, ...]] = {True: ("certain", "usual"), False: ("certain",)}
"""How sure what words about details, and what names of garments mean must be to contradict other words."""


def opposed_pairs(text: str, implied: Sequence[Implication]) -> list[tuple[WordMark, WordMark]]:
    """Pairs of words that say opposite things, by definition and of one place.

    What a detail usually is counts where the tables hold it against the other: a high neck that plunges.
    """
    sure = [i for i in implied if i.certainty in _TOLD_BY[i.said] and i.claim.name != "kind"]
    found: dict[tuple[int, int], tuple[WordMark, WordMark]] = {}
    short = next((i for i in implied if i.claim == _SHORTS and not i.said), None)
    for each in sure if short is not None else ():
        if short is not None and each.said and each.claim == _TO_THE_FEET and each.certainty == "certain":
            found[short.mark.start, each.mark.start] = (short.mark, each.mark)
    for k, one in enumerate(sure):
        for other in sure[k + 1 :]:
            certain = one.certainty == other.certainty == "certain"
            if one.mark is other.mark or not (
                _against(one, other) or (certain and opposed(one.claim, other.claim))
            ):
                continue
            if _only_usual(one, other) or _only_usual(other, one):
                continue
            if _puffed_above(one, other) or _puffed_above(other, one):
                continue
            if _flares_below(one, other) or _flares_below(other, one):
                continue
            if _held_up(one, other) or _held_up(other, one):
                continue
            first, second = sorted((one.mark, other.mark), key=lambda mark: mark.start)
            if not of_two_places(text, (first.start, first.end), (second.start, second.end)):
                found.setdefault((first.start, second.start), (first, second))
    return list(found.values())


def _only_usual(named: Implication, said: Implication) -> bool:
    """Whether what is named is had otherwise, too, and a word says so.

    Coats without sleeves or with a collar that stands; one shoulder with a sleeve on it.
    """
    if said.said and named.claim == _NO_SLEEVES and named.certainty != "certain":
        return said.claim.name == "sleeves"
    if named.said or not said.said or named.claim.name not in _NAMED_BY:
        return False
    return _NAMED_BY[named.claim.name].search(named.mark.word) is None


def _puffed_above(head: Implication, arm: Implication) -> bool:
    """Whether sleeves are puffed at the shoulders alone: "puffed shoulders, tight sleeves"."""
    return head.claim == _PUFFED and "shoulder" in head.mark.word.lower() and arm.claim.value == "slim"


def _flares_below(close: Implication, wide: Implication) -> bool:
    """Whether legs are wide from the knee on alone: "tight on the thighs, out like a trumpet"."""
    below = wide.claim.name == "legs" and wide.said and _FROM_THE_KNEE.search(wide.mark.word) is not None
    return below and close.claim.name in ("fit", "hips", "legs")


def _held_up(neckline: Implication, straps: Implication) -> bool:
    """Whether a neckline that is usually strapless is on straps: "a sweetheart bodice with wide straps"."""
    usual = neckline.certainty != "certain" and neckline.claim == Claim("shoulders", "strapless")
    return usual and straps.said and straps.claim.name in ("straps", "sleeves", "shoulders")


def _against(one: Implication, other: Implication) -> bool:
    return any(
        its.claim in entry.against
        for mine, its in ((one, other), (other, one))
        if mine.said and not mine.mark.denied
        for entry in mine.mark.entries
    )
