"""What a text asks for, in the words that the pattern maker was trained on.

People make typing errors, name colours and use words that it has never read; one such word can be enough to
make it leave out half of a garment. The wish reader is less easily misled, so what it has read is said again.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from swifttailor.describing.claims import Claim
from swifttailor.describing.differences import Change, Gain
from swifttailor.wording.captions import write_claims

_OF_LEGS = frozenset({"legs", "leg_hem", "leg_cuffs", "inseam_cm", "leg_cuff_cm"})
_OF_SKIRTS = frozenset({"skirt", "skirt_hem", "skirt_length_cm", "slit", "slit_size", "tiers", "hem_cm"})
_OF_WAISTS = frozenset({"rise", "waistband", "waistband_cm", "hips", "hem_shape", "sides", "length_cm"})

_WITH_LEGS = frozenset({"trousers", "shorts", "jumpsuit", "playsuit"})
_WITH_SKIRTS = frozenset({"skirt", "dress"})
_LOWER = frozenset({"skirt", "trousers", "shorts"})


def in_own_words(wishes: Sequence[Change], seed: int = 0) -> str:
    """Writes a text that asks for the same; empty if there is nothing to say.

    Args:
        wishes: Of a description.
        seed: Decides the words.
    """
    claims = [wish.claim for wish in wishes if isinstance(wish, Gain)]
    if not claims:
        return ""
    if all(claim.name != "kind" for claim in claims):
        claims += [Claim("kind", kind) for kind in implied_kind(claims)]
    return write_claims(claims, seed).text


def fits_kind(claim: str, kind: str) -> bool:
    """Whether a garment of a kind can have what a claim is about: skirts have no sleeves."""
    if claim in _OF_LEGS:
        return kind in _WITH_LEGS
    if claim in _OF_SKIRTS:
        return kind in _WITH_SKIRTS
    if claim in _OF_WAISTS or claim == "kind":
        return True
    return kind not in _LOWER


def implied_kind(claims: Iterable[Claim]) -> tuple[str, ...]:
    """What kind a garment must be if all this is said about it, at most one: legs and sleeves, a jumpsuit."""
    names = {claim.name for claim in claims}
    upper = bool(names - _OF_LEGS - _OF_SKIRTS - _OF_WAISTS)
    if names & _OF_LEGS:
        return ("jumpsuit",) if upper else ("trousers",)
    if names & _OF_SKIRTS:
        return ("dress",) if upper else ("skirt",)
    return ("top",) if upper else ()
