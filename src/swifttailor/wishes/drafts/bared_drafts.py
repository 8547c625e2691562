"""Drafts that leave shoulders bare: the skirt of off-the-shoulder dresses, and thin straps."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

from swifttailor.describing.claims import Claim
from swifttailor.pattern.drafts.draft_names import STRAP_WIDTH, NamedDraft
from swifttailor.wishes.drafts.held_drafts import CIRCLES

_ON_STRAPS, _THIN = ("camisole", "strappy-dress", "strappy-jumpsuit"), Claim("straps", "narrow")
_THIN_CM = 1.2
_STRAPPY, _THIN_STRAP_CM = "strappy-dress", 1.5
_HEAVY_CM, _VERY_HEAVY_CM = 42.0, 70.0
"""Lengths of skirts cut from a whole circle, or as much of a smaller part of one, that pull at straps, cm."""
_STRONG_CM, _STRONGER_CM = 2.5, 3.0
"""How wide straps are that hold them: narrower ones give and slide off the shoulders."""
_HELD_CLOSE = {"bust_ease": 1.0, "waist_ease": 0.0}
"""Of the bodice over such a skirt, cm: its waist holds up what straps alone do not."""
_STRAPLESS, _OPEN_BACK, _BARE = (
    "strapless-dress",
    Claim("back_depth", "open"),
    Claim("shoulders", "strapless"),
)
_SLIT_FRACTION, _HALTER_CM = 0.35, 98.0
_DRAFT = "off-shoulder-dress"
_SCOOPED = (
    *("fitted-dress", "mermaid-dress", "skater-dress", "jumpsuit"),
    *("fitted-top", "peplum-top"),
)
"""Drafts whose back ends at the waist, down to which it may be bare."""
_HANGING, _LOW_BACK_CM = ("t-shirt", "shift-dress"), 31.0
"""What hangs from its shoulders, with sleeves or room, and how low its back may be, cm."""
_HALTER = "halter-dress"
_BARE_BACK_CM, _BARE_WIDENING_CM, _HALTER_FALL_CM = 38.0, 4.0, 18.0
"""How deep it is then, how narrow the shoulders are, and how far the back of a halter falls."""
_CLOSE_NECKS = frozenset({Claim("neck_depth", "high"), Claim("neckline", "crew")})
_OTHER_BACKS = frozenset({"back_depth_cm", "collar", "hood"})
_OF_TOPS = frozenset(
    {"sleeves", "top_hem", "fit", "length_cm", "chest_cm", "sleeve_shape", "bodice", "straps"}
)
"""What makes a top that is bare behind another than a close one to the waist."""
_SAID_OF_BARE_TOPS = frozenset(
    {Claim("sleeves", "none"), Claim("fit", "close"), Claim("top_hem", "waist"), Claim("bodice", "darted")}
)
_OF_OTHER_TOPS = frozenset({"length", "sleeve_length", "shoulder_extension", "armhole"})
_HANGS = frozenset(
    {
        Claim("fit", "loose"),
        Claim("fit", "oversized"),
        Claim("bodice", "undarted"),
        Claim("bodice", "flared"),
        Claim("skirt", "pencil"),
        Claim("skirt", "straight"),
        Claim("skirt", "narrowing"),
    }
)
"""What a dress with a seam at the waist and a skirt cut from a circle is not."""
_SKIRTS: Mapping[str, float] = {**CIRCLES, "gathered": 0.8}
_LENGTHS: Mapping[str, float] = {
    "mini": 42.0,
    "above the knee": 50.0,
    "knee": 58.0,
    "midi": 76.0,
    "maxi": 98.0,
    "ankle": 98.0,
    "floor": 100.0,
}
"""Waist to hem, by where the hem is to end, cm."""
_FLOUNCED, _FLOUNCED_CM = Claim("skirt", "fitted base"), 84.0
"""A flounce begins at the knee: skirts that have one are at least so long."""
_LONG_CM, _FULL = 90.0, 0.7
"""A long skirt of which nothing is said is as full."""


def bared_as_asked(draft: NamedDraft, claims: Sequence[Claim]) -> NamedDraft:
    """An off-the-shoulder dress as long and full as is asked for, and thin straps; other drafts as they are.

    The dress has a seam at the waist and a skirt that flares from there, unless it is to hang loose or to be
    narrow.

    Args:
        draft: As a table names it; what that sets stays.
        claims: What is asked for, all of it.
    """
    if draft.name == _STRAPLESS and _OPEN_BACK in claims and _BARE not in claims:
        return _held_behind_the_neck(draft, claims)
    if draft.name == "t-shirt" and _OPEN_BACK in claims and not _is_otherwise(claims):
        draft = _bare_top(draft, claims)
    own = dict(draft.options)
    if draft.name == "camisole" and own.get("stretch") and _BARE in claims:
        kept = {name: own[name] for name in ("stretch", "length") if name in own}
        return NamedDraft("bandeau", tuple({"knit": True, **kept}.items()))
    if draft.name in _HANGING and _OPEN_BACK in claims and not _is_otherwise(claims):
        return replace(draft, options=tuple({**own, "back_neck_depth": _LOW_BACK_CM}.items()))
    if draft.name in _SCOOPED and _OPEN_BACK in claims and not _is_otherwise(claims):
        bare = {**own, "back_neck_depth": _BARE_BACK_CM}
        if _CLOSE_NECKS.isdisjoint(claims):
            bare["neck_widening"] = max(float(own.get("neck_widening", 0.0)), _BARE_WIDENING_CM)
        return replace(draft, options=tuple(bare.items()))
    if draft.name == _HALTER and _OPEN_BACK in claims and not _is_otherwise(claims):
        return replace(draft, options=tuple({"back_fall": _HALTER_FALL_CM, **own}.items()))
    if draft.name in _ON_STRAPS and _THIN in claims and STRAP_WIDTH in own:
        thin = min(float(own[STRAP_WIDTH]), _THIN_CM)
        draft = replace(draft, options=tuple({**own, STRAP_WIDTH: thin}.items()))
    if draft.name == _STRAPPY:
        return _with_strong_straps(draft)
    if draft.name != _DRAFT:
        return draft
    options: dict[str, float | bool | str] = {}
    for claim in claims:
        if claim.name == "skirt_hem" and claim.value in _LENGTHS:
            options["length"] = _LENGTHS[str(claim.value)]
    if _FLOUNCED in claims:
        options |= {"waist_seam": True, "flounce": True, "skirt_fraction": 0.8}
        options["length"] = max(float(options.get("length", _LENGTHS["floor"])), _FLOUNCED_CM)
    elif _HANGS.isdisjoint(claims):
        options["waist_seam"] = True
        shapes = [_SKIRTS[str(c.value)] for c in claims if c.name == "skirt" and c.value in _SKIRTS]
        long = float(options.get("length", 0.0)) >= _LONG_CM
        if shapes or long:
            options["skirt_fraction"] = max(shapes, default=_FULL)
    return replace(draft, options=tuple({**options, **own}.items()))


def _with_strong_straps(draft: NamedDraft) -> NamedDraft:
    """A dress on straps that hold up its skirt: those of a long and wide one are no mere cords."""
    own = dict(draft.options)
    if own.get("fitted") or own.get("flounce"):
        return draft
    fullness = float(own.get("skirt_fraction", 0.5)) * float(own.get("gathers", 1.0))
    length = float(own.get("skirt_length", 62.0))
    if length * fullness <= _HEAVY_CM:
        return draft
    least = _STRONGER_CM if length >= _LONG_CM or length * fullness > _VERY_HEAVY_CM else _STRONG_CM
    strap = max(float(own.get(STRAP_WIDTH, _THIN_STRAP_CM)), least)
    return replace(draft, options=tuple({**own, STRAP_WIDTH: strap, **_HELD_CLOSE}.items()))


def _bare_top(draft: NamedDraft, claims: Sequence[Claim]) -> NamedDraft:
    """A top that is to have no back, and of which little else is said: a close one without sleeves."""
    told = {claim.name for claim in claims if claim not in _SAID_OF_BARE_TOPS}
    plain = not {name for name, _ in draft.options} & _OF_OTHER_TOPS
    return NamedDraft("fitted-top") if plain and not told & _OF_TOPS else draft


def _is_otherwise(claims: Sequence[Claim]) -> bool:
    """Whether it is told how deep the back is, or that something stands at the neck."""
    return any(claim.name in _OTHER_BACKS and claim.value != "none" for claim in claims)


def _held_behind_the_neck(draft: NamedDraft, claims: Sequence[Claim]) -> NamedDraft:
    """A halter dress: the edge of a strapless one runs straight across the back that is to be bare."""
    own = dict(draft.options)
    ends = [_LENGTHS[str(c.value)] for c in claims if c.name == "skirt_hem" and c.value in _LENGTHS]
    options = {"back_fall": _HALTER_FALL_CM, "length": [*ends, float(own.get("skirt_length", _HALTER_CM))][0]}
    if any(claim.name == "slit" for claim in claims):
        options["skirt_fraction"] = _SLIT_FRACTION
    elif "skirt_fraction" in own:
        options["skirt_fraction"] = float(own["skirt_fraction"])
    return NamedDraft(_HALTER, tuple(options.items()))
