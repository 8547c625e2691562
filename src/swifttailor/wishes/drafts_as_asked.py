"""Named drafts with the collar, shoulders, slits, legs and tiers that a text asks for."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

from swifttailor.describing.claims import Claim
from swifttailor.pattern.drafts.draft_names import (
    BARE_SHOULDERED,
    COLLARED,
    DRAFT_KINDS,
    SIDE_SLITS,
    STANDING,
    NamedDraft,
)

_BARE = Claim("shoulders", "strapless")
_STAND, _ROLLED = Claim("collar", "stand"), Claim("collar", "turtleneck")
_OF_LAPELS = frozenset({Claim("collar", "lapel")})
_OF_STANDS = frozenset({_STAND, _ROLLED, Claim("neck_depth", "high"), Claim("shoulders", "both")})
"""What may be asked for of the neck of a draft with such a collar."""
_AT_THE_NECK = frozenset(
    {"neckline", "neck_depth", "back_depth", "back_neckline", "shoulders", "straps", "collar", "hood"}
)
"""Names of claims that a collar goes with in one way alone."""
_THIN_STRAPS = Claim("straps", "narrow")
_ON_SHOULDERS = ("t-shirt", "tank-top", "fitted-dress", "shift-dress", "skater-dress")
"""What thin straps do not hold: other drafts do."""
_LEGS: Mapping[str, Mapping[str, float]] = {
    "wide": {"leg_ease": 40.0, "flare": 8.0},
    "flared": {"leg_ease": 8.0, "flare": 26.0},
    "straight": {"leg_ease": 18.0, "flare": 2.0},
    "tapered": {"hip_ease": 9.0, "leg_ease": 12.0, "flare": -7.0},
    "slim": {"leg_ease": 6.0, "flare": -4.0},
}
_LOOSE, _LOOSE_CM = Claim("hips", "loose"), 12.0
_OF_TORSO = ("length", "chest_ease", "flare", "sleeve_length", "arm_ease", "sleeve_end", "side_slits")
"""Options of T-shirts that turtlenecks have as well."""
_SLITS = (Claim("slit", "left"), Claim("slit", "right"))
_SLIT_AT_THE_SIDES = ("t-shirt", "turtleneck", "shift-dress")
_SLIT_CM = 14.0
_SLIT_SKIRT_CM = 72.0
_OF_SKIRTS = {
    "fitted-dress": ("skirt_length", "skirt_flare", "hip_ease"),
    "skater-dress": ("skirt_length", "skirt_fraction"),
}
"""By drafts that there are without shoulders, too: the options of their skirts."""


def draft_as_asked(draft: NamedDraft, claims: Sequence[Claim]) -> NamedDraft | None:
    """A named draft as it goes with what is asked for; None where it does not.

    Shirts get the collar that is asked for, dresses that there are without shoulders lose theirs, what
    falls straight gets slits in its side seams, jumpsuits get legs, and skirts their number of tiers.

    Args:
        draft: As a table names it.
        claims: What is asked for, all of it.
    """
    if draft.name in _SLIT_AT_THE_SIDES and all(slit in claims for slit in _SLITS):
        draft = replace(draft, options=(*draft.options, (SIDE_SLITS, _SLIT_CM)))
    draft = _with_tiers(_with_legs(draft, claims), claims)
    if draft.name == "t-shirt" and (_STAND in claims or _ROLLED in claims):
        draft = _with_stand(draft, 10.0 if _ROLLED in claims else 4.0)
    if draft.name in _ON_SHOULDERS and _THIN_STRAPS in claims:
        return None
    if _BARE in claims and draft.name not in BARE_SHOULDERED:
        return _without_shoulders(draft)
    if draft.name == "skater-dress" and any(claim.name == "slit" for claim in claims):
        draft = NamedDraft("fitted-dress", (("skirt_length", _SLIT_SKIRT_CM),))  # where a slit is seen
    if draft.name == "strapless-dress" and any(_covers(claim) for claim in claims):
        return _with_shoulders(draft)
    if draft.name in COLLARED and _STAND in claims:
        draft = replace(draft, options=(*[o for o in draft.options if o[0] != "collar"], STANDING))
    stands = STANDING in draft.options
    if not stands and draft.name not in COLLARED:
        return draft
    own = _OF_STANDS if stands else _OF_LAPELS
    others = [claim for claim in claims if claim.name in _AT_THE_NECK and claim not in own]
    return None if others else draft


def _with_legs(draft: NamedDraft, claims: Sequence[Claim]) -> NamedDraft:
    """Legs with room, and of jumpsuits the legs that are asked for: trousers have drafts for each shape."""
    if DRAFT_KINDS[draft.name] not in ("jumpsuit", "trousers"):
        return draft
    options = dict(draft.options)
    if DRAFT_KINDS[draft.name] == "jumpsuit":
        for claim in claims:
            options |= _LEGS.get(str(claim.value), {}) if claim.name == "legs" else {}
    if _LOOSE in claims:
        options["hip_ease"] = _LOOSE_CM
    return replace(draft, options=tuple(options.items()))


def _with_tiers(draft: NamedDraft, claims: Sequence[Claim]) -> NamedDraft:
    """A tiered skirt of as many tiers as are asked for, where so many can be drafted."""
    counts = [claim.value for claim in claims if claim.name == "tiers" and not isinstance(claim.value, str)]
    if draft.name != "tiered-skirt" or not counts or not 2 <= counts[0] <= 6:
        return draft
    return replace(draft, options=(*[o for o in draft.options if o[0] != "tiers"], ("tiers", counts[0])))


def _with_stand(draft: NamedDraft, height: float) -> NamedDraft:
    kept = tuple([option for option in draft.options if option[0] in _OF_TORSO])
    return NamedDraft("turtleneck", (*kept, ("collar_height", height)))


def _covers(claim: Claim) -> bool:
    """Whether what has this has shoulders: sleeves, a neckline between them, a collar."""
    if claim.name in ("sleeves", "left_sleeve", "right_sleeve", "collar", "hood"):
        return claim.value != "none"
    return claim.name == "neckline" or claim == Claim("shoulders", "both")


def _with_shoulders(draft: NamedDraft) -> NamedDraft:
    options = dict(draft.options)
    other = "fitted-dress" if options.get("fitted") else "skater-dress"
    skirt = {"skirt_length": 98.0} | ({} if options.get("fitted") else {"skirt_fraction": 0.5})
    skirt |= {name: float(options[name]) for name in _OF_SKIRTS[other] if name in options}
    skirt["skirt_length"] = min(skirt["skirt_length"], 100.0)
    return NamedDraft(other, tuple(skirt.items()))


def _without_shoulders(draft: NamedDraft) -> NamedDraft | None:
    if draft.name not in _OF_SKIRTS:
        return None
    kept = tuple([option for option in draft.options if option[0] in _OF_SKIRTS[draft.name]])
    fitted = (("fitted", True),) if draft.name == "fitted-dress" else ()
    return NamedDraft("strapless-dress", (*kept, *fitted))
