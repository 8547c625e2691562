"""What claims say about the kind of a garment: what has sleeves and legs is a jumpsuit."""

from __future__ import annotations

from collections.abc import Iterable

from swifttailor.describing.claims import Claim

_OF_LEGS = frozenset({"legs", "leg_hem", "leg_cuffs", "inseam_cm", "leg_width_cm", "leg_cuff_cm"})
_OF_SKIRTS = frozenset(
    {"skirt", "skirt_hem", "skirt_length_cm", "slit", "slit_size", "slit_cm", "tiers", "gores", "godets"}
    | {"godet_cm", "hem_cm"}
)
_OF_WAISTS = frozenset({"rise", "waistband", "waistband_cm", "hips", "hem_shape", "sides", "length_cm"})

_WITH_LEGS = frozenset({"trousers", "shorts", "jumpsuit", "playsuit"})
_WITH_SKIRTS = frozenset({"skirt", "dress"})
_LOWER = frozenset({"skirt", "trousers", "shorts"})


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
