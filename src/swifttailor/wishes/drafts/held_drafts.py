"""Named drafts of dresses and jumpsuits, held as a text asks for and with the skirt that it asks for.

On shoulders, on thin straps, or by the waist alone; cut from a circle, close, or close with a flounce.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Literal

from swifttailor.describing.claims import Claim
from swifttailor.pattern.drafts.draft_names import NamedDraft

Hold = Literal["shoulders", "straps", "waist"]
Skirt = Literal["circle", "gathered", "close", "flounce"]
_BARE, _THIN_STRAPS = Claim("shoulders", "strapless"), Claim("straps", "narrow")
_JUMPSUITS: Mapping[Hold, str] = {
    "shoulders": "jumpsuit",
    "straps": "strappy-jumpsuit",
    "waist": "strapless-jumpsuit",
}
_OF_LEGS = ("length", "hip_ease", "leg_ease", "flare")
_ON_SHOULDERS: Mapping[Skirt, str] = {
    "circle": "skater-dress",
    "gathered": "skater-dress",
    "close": "fitted-dress",
    "flounce": "mermaid-dress",
}
_WITHOUT: Mapping[Hold, str] = {"straps": "strappy-dress", "waist": "strapless-dress"}
_GATHERS = 2.0
"""Width of a gathered skirt over the waist."""
_FLAGS: Mapping[Skirt, tuple[tuple[str, bool | float], ...]] = {
    "circle": (),
    "gathered": (),
    "close": (("fitted", True),),
    "flounce": (("flounce", True), ("close", 54.0), ("skirt_fraction", 0.8)),
}
"""What makes the skirt of a dress without shoulders."""
_FLARED_WIDE = (("close", 54.0), ("fraction", 0.8))
"""The flounce of a dress with shoulders, where no option says otherwise."""
_OF_SKIRT: Mapping[Skirt, tuple[str, ...]] = {
    "circle": ("skirt_length", "skirt_fraction"),
    "gathered": ("skirt_length", "gathers"),
    "close": ("skirt_length", "skirt_flare", "hip_ease"),
    "flounce": ("skirt_length", "hip_ease", "close"),
}
"""Options that mean the same in all of these dresses."""
_LENGTHS: Mapping[str, float] = {
    "skater-dress": 50.0,
    "fitted-dress": 60.0,
    "mermaid-dress": 100.0,
    "strapless-dress": 98.0,
    "strappy-dress": 62.0,
    "slip-dress": 56.0,
}
"""Of skirts, where no option says otherwise, cm."""
_LONGEST_CM, _SHORTEST_CM = 100.0, 36.0
_FLOOR, _FLOUNCED_CM = Claim("skirt_hem", "floor"), 84.0
"""A flounce begins at the knee: skirts that have one are at least so long."""
_SLIP = "slip-dress"
_WAISTED = frozenset(
    {Claim("waist_seam", "natural"), Claim("skirt", "tiered"), Claim("skirt", "gathered tiers")}
)
"""What makes one have a seam at the waist."""
CIRCLES: Mapping[str, float] = {
    "a-line": 0.3,
    "flared": 0.5,
    "half circle": 0.5,
    "three-quarter circle": 0.75,
    "circle": 1.0,
    "more than a circle": 1.25,
}
"""Parts of a circle, by what a skirt is called."""
_ROUND, _GATHERED = Claim("skirt", "circle"), Claim("skirt", "gathered")
_DROPPED = "drop-waist-dress"
_STRAIGHT: Mapping[str, float] = {"fullness": 1.0, "skirt_flare": 0.0}
"""Of a dropped skirt that is to be straight: gathered ones that narrow to the hem stand out above it."""
_HEAVY_CM, _HOLDING_STRAPS_CM = 75.0, 3.0
"""Full skirts that are longer pull narrower straps than this off the shoulders."""
_CLOSE = ("pencil", "narrowing", "straight")
_WIDE_STRAPS, _BETWEEN_STRAPS = Claim("straps", "wide"), frozenset({Claim("neckline", "square")})
_WIDE: Mapping[str, float] = {"strap_width": 5.5, "dip": 0.0}
"""Straps that are seen to be wide, and the straight edge between them."""
_AT_THE_NECK = ("neckline", "collar", "hood", "neck_depth", "neck_depth_cm", "back_depth", "back_neckline")
_FLOUNCE = "fitted base"


def held_as_asked(draft: NamedDraft, claims: Sequence[Claim]) -> NamedDraft:
    """A dress or jumpsuit held as is asked for, its skirt of the shape that is asked for; others as they are.

    Args:
        draft: As a table names it.
        claims: What is asked for, all of it.
    """
    if draft.name == _DROPPED and any(_asked_skirt(claim) == "close" for claim in claims):
        return NamedDraft(_DROPPED, tuple({**dict(draft.options), **_STRAIGHT}.items()))
    held = _held(draft, claims)
    if held.name != _WITHOUT["straps"] or not _on_wide_straps(claims):
        return held
    return NamedDraft(held.name, tuple({**dict(held.options), **_WIDE}.items()))


def on_straps_that_hold(draft: NamedDraft) -> NamedDraft:
    """A dress whose long, full skirt hangs on straps, with such as hold it; others as they are."""
    options = dict(draft.options)
    length = float(options.get("skirt_length", _LENGTHS.get(draft.name, 0.0)))
    if draft.name != _WITHOUT["straps"] or options.get("fitted") or length <= _HEAVY_CM:
        return draft
    width = max(float(options.get("strap_width", 0.0)), _HOLDING_STRAPS_CM)
    return NamedDraft(draft.name, tuple({**options, "strap_width": width}.items()))


def _held(draft: NamedDraft, claims: Sequence[Claim]) -> NamedDraft:
    own = _own_hold(draft)
    if own is None:
        return draft
    hold = _asked_hold(claims) or own
    if draft.name in _JUMPSUITS.values():
        return draft if hold == own else _with(_JUMPSUITS[hold], draft, _OF_LEGS)
    options, skirt = dict(draft.options), _own_skirt(draft)
    if _ROUND in claims and _GATHERED in claims:  # what is as full as that needs no gathers
        skirt, claims = "circle", [claim for claim in claims if claim != _GATHERED]
        options.pop("gathers", None)
    for claim in claims:
        shape = _asked_skirt(claim)
        if shape == "circle" and skirt in ("flounce", "gathered"):
            continue  # it flares from the knee, or is full as it is
        skirt = shape or skirt
        if shape == "gathered":
            options.setdefault("gathers", _GATHERS)
        elif claim.value == "flared" and shape == "circle":
            options.setdefault("skirt_fraction", CIRCLES["flared"])
        elif shape == "circle":
            options["skirt_fraction"] = CIRCLES[str(claim.value)]
    if draft.name == _SLIP:
        waisted = any(_asked_skirt(claim) or claim in _WAISTED for claim in claims)
        if hold == "straps" and not waisted:
            return draft
        options = {"skirt_length": options.get("length", _LENGTHS[_SLIP]), **options}
    name = _ON_SHOULDERS[skirt] if hold == "shoulders" else _WITHOUT[hold]
    flags = _FLAGS[skirt] if hold != "shoulders" else _FLARED_WIDE if skirt == "flounce" else ()
    if name == draft.name:
        own_options = {key: value for key, value in options.items() if key not in ("fitted", "flounce")}
        return NamedDraft(name, _with_flags(own_options, flags))
    length = float(options.get("skirt_length", _LENGTHS[draft.name]))
    if skirt == "flounce" and _own_skirt(draft) != "flounce":
        length = max(length, _FLOUNCED_CM if _FLOOR not in claims else _LONGEST_CM)
    options |= {"skirt_length": min(max(length, _SHORTEST_CM), _LONGEST_CM)}
    options.setdefault("skirt_fraction", CIRCLES["flared"])
    kept = {key: value for key, value in options.items() if key in _OF_SKIRT[skirt]}
    return NamedDraft(name, _with_flags(kept, flags))


def _with_flags(
    own: Mapping[str, float | bool | str], flags: Sequence[tuple[str, float | bool]]
) -> tuple[tuple[str, float | bool | str], ...]:
    """Options with those of the shape of a skirt that they do not set themselves."""
    return (*own.items(), *[flag for flag in flags if flag[0] not in own])


def _with(name: str, draft: NamedDraft, kept: Sequence[str]) -> NamedDraft:
    return NamedDraft(name, tuple([option for option in draft.options if option[0] in kept]))


def _own_hold(draft: NamedDraft) -> Hold | None:
    """How a draft is held; None of those that there are in one way alone."""
    if draft.name in _ON_SHOULDERS.values() and not any(name == "collar" for name, _ in draft.options):
        return "shoulders"
    if draft.name == _SLIP:
        return "straps"
    found = [hold for names in (_JUMPSUITS, _WITHOUT) for hold, name in names.items() if name == draft.name]
    return found[0] if found else None


def _own_skirt(draft: NamedDraft) -> Skirt:
    options = dict(draft.options)
    if float(options.get("gathers", 1.0)) > 1:
        return "gathered"
    if options.get("flounce") or draft.name == _ON_SHOULDERS["flounce"]:
        return "flounce"
    return "close" if options.get("fitted") or draft.name == _ON_SHOULDERS["close"] else "circle"


def _asked_hold(claims: Sequence[Claim]) -> Hold | None:
    if _BARE in claims:
        return "waist"
    if _THIN_STRAPS in claims or _on_wide_straps(claims):
        return "straps"
    return "shoulders" if any(_covers(claim) for claim in claims) else None


def _on_wide_straps(claims: Sequence[Claim]) -> bool:
    """Whether it hangs on wide straps with a straight edge between them, and no neckline says otherwise."""
    others = [claim for claim in claims if claim.name in _AT_THE_NECK and claim.value != "none"]
    sleeved = any(claim.name == "sleeves" and claim.value != "none" for claim in claims)
    return _WIDE_STRAPS in claims and not sleeved and _BETWEEN_STRAPS.issuperset(others)


def _asked_skirt(claim: Claim) -> Skirt | None:
    if claim.name != "skirt":
        return None
    if claim.value in CIRCLES:
        return "circle"
    if claim.value in ("gathered", _FLOUNCE):
        return "gathered" if claim.value == "gathered" else "flounce"
    return "close" if claim.value in _CLOSE else None


def _covers(claim: Claim) -> bool:
    """Whether what has this has shoulders: sleeves, a neckline between them, a collar."""
    if claim.name in ("sleeves", "left_sleeve", "right_sleeve", "collar", "hood"):
        return claim.value != "none"
    return claim.name in ("neckline", "sleeve_shape") or claim == Claim("shoulders", "both")
