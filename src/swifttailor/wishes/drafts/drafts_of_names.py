"""Drafts for names of garments that the tables give none: where a draft can have all that a name means."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence

from swifttailor.describing.claims import Claim
from swifttailor.pattern.drafts.draft_names import NamedDraft
from swifttailor.wishes.drafts.drafts_as_asked import draft_as_asked
from swifttailor.wording.lexicon import Entry, exclude

_Values = Collection[str] | None
_ANY: _Values = None
_UPPER: Mapping[str, _Values] = {
    "fit": _ANY,
    "sleeves": ("none", "cap", "short", "elbow", "three-quarter", "long", "extra-long"),
    "sleeve_shape": ("puffed", "balloon", "gathered end", "bell", "wide", "slim", "set smooth"),
    "cuffs": ("none", "band"),
    "neckline": ("round", "crew", "scoop", "v", "square", "boat"),
    "neck_depth": ("low", "high"),
    "collar": ("none", "stand", "turtleneck", "lapel"),
    "shoulders": ("both", "strapless"),
    "straps": ("narrow", "wide"),
    "bodice": ("darted", "undarted", "flared"),
    "hood": ("none",),
}
_OF_TOPS: Mapping[str, _Values] = {"top_hem": ("cropped", "waist", "high hip", "hip", "long")}
_OF_SKIRTS: Mapping[str, _Values] = {
    "skirt": frozenset(
        {"pencil", "straight", "narrowing", "a-line", "flared", "half circle", "three-quarter circle"}
        | {"circle", "more than a circle", "gathered", "fitted base"}
    ),
    "skirt_hem": _ANY,
    "hips": _ANY,
}
_OF_DRESSES: Mapping[str, _Values] = {"waist_seam": ("natural", "empire")}
_OF_LEGS: Mapping[str, _Values] = {
    "legs": ("wide", "straight", "tapered", "slim", "flared"),
    "leg_hem": _ANY,
    "hips": _ANY,
    "leg_cuffs": ("none", "gathered", "band"),
    "rise": ("high", "mid", "low"),
    "waistband": ("waist",),
}
_COVERED: Mapping[str, Mapping[str, _Values]] = {
    "top": _UPPER | _OF_TOPS,
    "tunic": _UPPER | _OF_TOPS,
    "dress": _UPPER | _OF_SKIRTS | _OF_DRESSES,
    "jumpsuit": _UPPER | _OF_LEGS,
    "playsuit": _UPPER | _OF_LEGS,
    "trousers": _OF_LEGS,
    "shorts": _OF_LEGS,
}
"""By kinds, what names may mean that drafts of these kinds have, or that can be cut into them."""
_CUT_INTO_NAMED: Mapping[str, Mapping[str, _Values]] = {
    "dress": {
        "skirt": frozenset({"tiered", "gathered tiers", *(_OF_SKIRTS["skirt"] or ())}),
        "hem_shape": ("high-low", "lower left", "lower right", "level"),
        **dict.fromkeys(("back_depth", "back_neckline", "slit", "slit_size"), _ANY),
    },
    "top": dict.fromkeys(("back_depth", "back_neckline"), _ANY),
}
"""What is cut into the drafts of names besides: a "backless dress" is a plain one without a back."""
_DRAFTS: Mapping[str, NamedDraft] = {
    "top": NamedDraft.parse("t-shirt(neck_widening=0;neck_depth=11)"),
    "tunic": NamedDraft.parse("t-shirt(length=38;chest_ease=14;neck_widening=0;neck_depth=11)"),
    "dress": NamedDraft.parse(
        "skater-dress(skirt_length=62;skirt_fraction=0.4;neck_widening=1.2;bust_ease=8;waist_ease=6)"
    ),
    "empire": NamedDraft.parse("empire-dress"),
    "jumpsuit": NamedDraft.parse("jumpsuit(hip_ease=7;leg_ease=22;flare=-6)"),
    "playsuit": NamedDraft.parse("jumpsuit(length=50;leg_ease=16;flare=4)"),
    "trousers": NamedDraft.parse("trousers(length=100;leg_ease=22;flare=-8)"),
    "shorts": NamedDraft.parse("trousers(length=50;hip_ease=4;leg_ease=18;crotch_drop=3)"),
}
_SHAPED_LEGS: Mapping[str, NamedDraft] = {
    "wide": NamedDraft.parse("trousers(length=103;hip_ease=6;leg_ease=42;flare=10)"),
    "slim": NamedDraft.parse("jeans"),
    "flared": NamedDraft.parse("flares"),
    "tapered": NamedDraft.parse("trousers(length=92;hip_ease=6;leg_ease=17;flare=-18)"),
}
_EMPIRE = Claim("waist_seam", "empire")


def draft_of_name(entry: Entry, kind: str, asked: Sequence[Claim]) -> NamedDraft | None:
    """A draft that has what a name means; None where no draft has all of it.

    Args:
        entry: Names a garment, and no draft.
        kind: Of the garment.
        asked: What is asked for besides.
    """
    covered = {**_COVERED.get(kind, {}), **_CUT_INTO_NAMED.get(kind, {})}
    meant = [each.claim for each in entry.implied if each.certainty != "likely" and each.claim.name != "kind"]
    meant = [claim for claim in meant if not any(exclude(claim, other) for other in asked)]
    if (
        kind not in _COVERED
        or entry.category != "garments"
        or not all(_has(covered, claim) for claim in meant)
    ):
        return None
    return _as_asked(kind, (*asked, *meant))


def covers(kind: str | None, asked: Sequence[Claim]) -> bool:
    """Whether drafts of a kind have all that is asked for, or it can be cut into them."""
    covered = _COVERED.get(kind or "", {})
    return all(_has(covered, claim) for claim in asked if claim.name != "kind")


def draft_of_kind(kind: str | None, asked: Sequence[Claim]) -> NamedDraft | None:
    """A draft that has all that is asked for of a garment that no word names; None where no draft has.

    Args:
        kind: Of the garment, as what is asked for tells.
        asked: All of it: long bell sleeves, a boat neck, a skirt that touches the floor.
    """
    told = any(claim.name != "kind" for claim in asked)
    return _as_asked(kind, asked) if kind is not None and told and covers(kind, asked) else None


def _as_asked(kind: str, claims: Sequence[Claim]) -> NamedDraft | None:
    draft = _DRAFTS[kind]
    if kind == "dress" and _EMPIRE in claims:
        draft = _DRAFTS["empire"]
    elif kind == "trousers":
        shapes = [str(claim.value) for claim in claims if claim.name == "legs"]
        draft = next((_SHAPED_LEGS[shape] for shape in shapes if shape in _SHAPED_LEGS), draft)
    return draft_as_asked(draft, claims)


def _has(covered: Mapping[str, _Values], claim: Claim) -> bool:
    values = covered.get(claim.name, ())
    return values is None or claim.value in values
