"""Named drafts with legs as a text asks for them: wide, tapered, gathered into cuffs."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

from swifttailor.describing.claims import Claim
from swifttailor.pattern.drafts.draft_kinds import DRAFT_KINDS
from swifttailor.pattern.drafts.draft_names import NamedDraft

_WITHOUT_LEGS = ("bodysuit", "swimsuit")
_LEGS: Mapping[str, Mapping[str, float]] = {
    "wide": {"leg_ease": 42.0, "flare": 10.0},
    "flared": {"leg_ease": 9.0, "flare": 30.0},
    "straight": {"leg_ease": 22.0, "flare": -8.0},
    "tapered": {"hip_ease": 9.0, "leg_ease": 17.0, "flare": -16.0},
    "slim": {"leg_ease": 6.0, "flare": -4.0},
}
_SHORT_CM: Mapping[str, float] = {"very short": 38.0, "mid-thigh": 47.0, "thigh": 53.0}
"""Length of the legs of playsuits that are asked to be so short, from the waist, cm."""
_JOGGERS = "joggers"
_OF_JOGGERS = ("wide", "straight", "slim")
"""Legs that joggers have as well; they are tapered as they are, and nothing flares into a cuff."""
_GATHERED, _BANDED = Claim("leg_cuffs", "gathered"), Claim("leg_cuffs", "band")
_FULL = frozenset({Claim("legs", "tapered"), Claim("legs", "wide"), Claim("hips", "loose")})
"""Legs of which there is something to gather into a band; turn-ups are called cuffs as well."""
_NOT_CUFFED = frozenset({Claim("leg_cuffs", "none"), Claim("leg_cuffs", "flounce"), Claim("legs", "flared")})
_UNCUFFED = Claim("leg_cuffs", "none")
_OPEN_JOGGERS = NamedDraft.parse("pull-on-trousers(length=99;hip_ease=10;leg_ease=24;flare=-8)")
"""Joggers whose ends are open."""
_GATHERS_FROM_CM = 24.0
"""Legs with so much room at the knee do not narrow above their cuffs: they are gathered there."""
_SHORTEST_JOGGERS, _LONGEST_JOGGERS = 44.0, 98.0
_SLIM, _CLOSEST = Claim("legs", "slim"), 100.0
_BELOW_WAIST: Mapping[Claim, float] = {Claim("rise", "mid"): 5.0, Claim("rise", "low"): 14.0}
"""How far below the waist trousers begin, cm."""
_MAY_DRAG = ("trousers", "pull-on-trousers")
"""Drafts of legs of any length."""
_OVER_INSEAM_CM, _LONG_LEGS_CM = 33.3, (90.0, 130.0)
"""Length down the side over that of the inseam, and the lengths that are drafted so, cm."""
_WIDE, _WIDE_CM = Claim("legs", "wide"), 30.0
_LEG_CM, _WIDER_CM, _CLOSEST_CM, _MOST_NARROWED_CM, _EASY_CM = 34.0, 10.0, 9.0, 20.0, 4.0
"""Girth of a leg below the knee; by how much the ends of wide legs may be wider than is told; the least room,
the most that is narrowed, and the room at the hips of those that are, cm."""
_FULL_CM, _CUFF_CM, _BELOW_CUFFS_CM = 100.0, 8.0, 3.0
"""Length of legs, height of their cuffs where none is told, and what of these may go below the hem, cm."""
_SHORTS_CM = 66.0
"""Legs that are no longer end at the knee or above."""
_OF_PLAYSUITS: Mapping[str, float] = {"length": 48.0, "leg_ease": 14.0, "flare": 4.0}
_WIDE_SHORTS: Mapping[str, float] = {"leg_ease": 60.0, "flare": 2.0}
_WIDEST_SHORTS: Mapping[str, float] = {"leg_ease": 60.0, "flare": 6.0}
"""As wide as the thigh of the pattern all the way down: what flares from there looks like a skirt."""
_BAGGY: Mapping[str, float] = {"hip_ease": 14.0, "leg_ease": 30.0, "flare": -4.0}
"""Joggers with wide legs: they are baggy, and no harem trousers unless those are meant."""
_TAPERED, _TO_THE_ANKLE_CM, _WIDE_BAND_CM = Claim("legs", "tapered"), 97.0, 10.5
_TAPERED_LEGS: Mapping[str, float] = {"leg_ease": 17.0, "flare": -15.0}
_TAPERED_CM, _NARROWS_CM = 98.0, -9.0
"""How long tapered legs are, and by how much legs narrow that are tapered as they are, cm."""
_ROOMY: Mapping[str, float] = {"hip_ease": 15.0, "leg_ease": 20.0, "flare": -16.0}
"""Trousers that are wide at the hips and narrow below."""
_LOOSE, _LOOSE_CM = Claim("hips", "loose"), 12.0
_LEGGINGS, _SHORTEST_LEGGINGS_CM = "leggings", 43.0
_FULL_LEGS, _FULL_LEGGINGS_CM = Claim("leg_hem", "full"), 101.0
"""Leggings that are told to be full length, and how long these are, cm."""
_WIDE_BELOW, _FLARES = (
    frozenset({Claim("legs", "wide"), Claim("legs", "flared")}),
    NamedDraft.parse("flares"),
)
_OF_JERSEY: Mapping[Claim, NamedDraft] = {
    Claim("legs", "flared"): NamedDraft.parse(
        "flares(stretch=8;leg_ease=8;hip_ease=2;flare=28;length=103;band_height=7;crotch_drop=0)"
    ),
    Claim("legs", "straight"): NamedDraft.parse(
        "flares(stretch=8;leg_ease=6;hip_ease=1.5;flare=8;length=100;band_height=7;crotch_drop=0)"
    ),
}
"""What leggings are cut as whose legs are to be so: of the same cloth, and close to the knee."""
_WIDE_BAND, _WIDE_BANDS = Claim("waistband", "wide"), ("leggings", "flares", "jeans", "trousers", "joggers")
_BROAD_CM = 10.5
"""Height of waistbands that are measured to be wide."""
_HIGH_RISE, _WITHOUT_BAND = Claim("rise", "high"), Claim("waistband", "none")
_MAY_BE_HIGH: Mapping[str, float] = {
    "trousers": 6.0,
    "pull-on-trousers": 4.0,
    "jeans": 6.0,
    "flares": 6.0,
    "joggers": 4.0,
}
"""Drafts that may begin above the waist, and the least height of their band then, cm."""
_ABOVE_WAIST_CM = 3.5
"""How far above the waist high ones begin, so that one sees it."""


def legs_as_asked(draft: NamedDraft, claims: Sequence[Claim]) -> NamedDraft | None:
    """A draft with the legs that are asked for; None where it has none of them.

    Args:
        draft: As a table names it.
        claims: What is asked for, all of it.
    """
    if draft.name in _WITHOUT_LEGS and any(_has_legs(claim) for claim in claims):
        return None
    if draft.name == _LEGGINGS and not dict(draft.options).get("length", 0.0):
        draft = next((cut for claim, cut in _OF_JERSEY.items() if claim in claims), draft)
    if draft.name == "jeans" and _WIDE_BELOW.intersection(claims):
        draft = _FLARES  # tight over the hips by one word, wide below by another
    if draft.name == _LEGGINGS and _FULL_LEGS in claims and "length" not in dict(draft.options):
        draft = replace(draft, options=(*draft.options, ("length", _FULL_LEGGINGS_CM)))
    if draft.name == _JOGGERS and _UNCUFFED in claims and not dict(draft.options).get("crotch_drop"):
        draft = _OPEN_JOGGERS
    draft = _with_legs(_with_leg_cuffs(draft, claims), claims)
    return None if draft.name == _JOGGERS and _NOT_CUFFED.intersection(claims) else draft


def short_as_a_playsuit(draft: NamedDraft) -> NamedDraft:
    """A jumpsuit that a detail names ("wrap", "halter"), its legs as short as those of playsuits."""
    options = dict(draft.options)
    has_legs = DRAFT_KINDS[draft.name] == "jumpsuit" and draft.name not in _WITHOUT_LEGS
    if not has_legs or float(options.get("length", _FULL_CM)) <= _SHORTS_CM:
        return draft
    return replace(draft, options=tuple({**options, **_OF_PLAYSUITS}.items()))


def _with_leg_cuffs(draft: NamedDraft, claims: Sequence[Claim]) -> NamedDraft:
    """Full trousers that end in cuffs are joggers, as long and as wide."""
    options = dict(draft.options)
    length = float(options.get("length", _LONGEST_JOGGERS))
    cuffed = _GATHERED in claims or (_BANDED in claims and bool(_FULL.intersection(claims)))
    if draft.name not in ("trousers", "pull-on-trousers") or not cuffed or length < _SHORTEST_JOGGERS:
        return draft
    kept = {name: options[name] for name in ("hip_ease", "leg_ease") if name in options}
    if float(options.get("leg_ease", 0.0)) >= _GATHERS_FROM_CM:
        kept["flare"] = 0.0
    return NamedDraft(_JOGGERS, tuple({"length": min(length, _LONGEST_JOGGERS), **kept}.items()))


def _with_legs(draft: NamedDraft, claims: Sequence[Claim]) -> NamedDraft:
    """Legs with room, and of jumpsuits the legs that are asked for: trousers have drafts for each shape."""
    if DRAFT_KINDS[draft.name] not in ("jumpsuit", "trousers") or draft.name in _WITHOUT_LEGS:
        return draft
    options = dict(draft.options)
    known = _OF_JOGGERS if draft.name == _JOGGERS else tuple(_LEGS)
    if DRAFT_KINDS[draft.name] == "jumpsuit" or draft.name == _JOGGERS:
        for claim in claims:
            asked = _LEGS[str(claim.value)] if claim.name == "legs" and claim.value in known else {}
            if claim == _WIDE and draft.name == _JOGGERS:
                asked = {name: max(own, float(options.get(name, own))) for name, own in _BAGGY.items()}
            closer = float(options.get("leg_ease", _CLOSEST)) < _LEGS["slim"]["leg_ease"]
            options |= {} if claim == _SLIM and closer else asked
    if DRAFT_KINDS[draft.name] == "jumpsuit":
        ends = [cm for c in claims if (cm := _short_cm(c))]
        options |= {"length": ends[0]} if ends else {}
        if float(options.get("length", _LONG_LEGS_CM[0])) <= _SHORTS_CM:
            options["flare"] = max(float(options.get("flare", 0.0)), 0.0)
    if draft.name == "trousers" and {_LOOSE, _TAPERED} <= frozenset(claims):
        return _roomy_and_tapered(options, claims)
    if draft.name in _MAY_DRAG and _TAPERED in claims:
        options |= _tapered_legs(options)
    if draft.name in _MAY_DRAG and _WIDE in claims and float(options.get("leg_ease", _CLOSEST)) < _WIDE_CM:
        options |= _wide_legs(options, claims)
    if DRAFT_KINDS[draft.name] == "trousers":
        for claim in claims:
            options |= {"below_waist": _BELOW_WAIST[claim]} if claim in _BELOW_WAIST else {}
            options |= _as_long(draft.name, claim)
        if draft.name in _MAY_DRAG:
            options |= _as_wide(options, claims)
            options |= _above_cuffs(options, claims)
        if _WIDE_BAND in claims and draft.name in _WIDE_BANDS:
            options["band_height"] = max(_BROAD_CM, float(options.get("band_height", 0.0)))
        if _HIGH_RISE in claims and draft.name in _MAY_BE_HIGH and _WITHOUT_BAND not in claims:
            least = max(_MAY_BE_HIGH[draft.name], float(options.get("band_height", 0.0)))
            band = next((float(c.value) for c in claims if c.name == "waistband_cm"), least)
            options |= {"below_waist": -_ABOVE_WAIST_CM, "band_height": band}
        if _HIGH_RISE in claims and draft.name == "briefs":
            options["below_waist"] = 2.0
        if draft.name == _LEGGINGS and float(options.get("length", _LONG_LEGS_CM[0])) < _LONG_LEGS_CM[0]:
            ends = [cm for c in claims if (cm := _short_cm(c))]
            options |= {"length": max(ends[0], _SHORTEST_LEGGINGS_CM)} if ends else {}
    if _LOOSE in claims:
        options["hip_ease"] = max(_LOOSE_CM, float(options.get("hip_ease", 0.0)))
    return replace(draft, options=tuple(options.items()))


def _tapered_legs(options: Mapping[str, float | bool | str]) -> Mapping[str, float]:
    """Legs that taper where a name has straight ones: cut so afterwards they stand off at the hips."""
    length = float(options.get("length", _FULL_CM))
    if length < _LONG_LEGS_CM[0] or float(options.get("flare", 0.0)) <= _NARROWS_CM:
        return {}
    return {**_TAPERED_LEGS, "length": min(length, _TAPERED_CM)}


def _wide_legs(options: Mapping[str, float | bool | str], claims: Sequence[Claim]) -> Mapping[str, float]:
    """Wide legs, as long as they are: short ones have the width of the thigh, and are wide by their slant."""
    if float(options.get("length", _LONG_LEGS_CM[0])) > _SHORTS_CM:
        return _LEGS["wide"]
    return _WIDEST_SHORTS if _LOOSE in claims else _WIDE_SHORTS


def _short_cm(claim: Claim) -> float:
    """How long legs are that are to be so short, from the waist, cm; 0 of other claims."""
    return _SHORT_CM.get(str(claim.value), 0.0) if claim.name == "leg_hem" else 0.0


def _roomy_and_tapered(options: Mapping[str, float | bool | str], claims: Sequence[Claim]) -> NamedDraft:
    """Trousers with room at the hips and narrow ends: gathered at the waist, as darts would stand off."""
    length = min(float(options.get("length", _TO_THE_ANKLE_CM)), _TO_THE_ANKLE_CM)
    band = {"band_height": _WIDE_BAND_CM} if Claim("waistband", "wide") in claims else {}
    return NamedDraft("pull-on-trousers", tuple({"length": length, **_ROOMY, **band}.items()))


def _as_long(name: str, claim: Claim) -> Mapping[str, float]:
    """The length of long legs whose inseam is told: longer ones than those of the usual body are cut, too."""
    if claim.name != "inseam_cm" or isinstance(claim.value, str) or name not in _MAY_DRAG:
        return {}
    length = float(claim.value) + _OVER_INSEAM_CM
    return {"length": round(length, 1)} if _LONG_LEGS_CM[0] <= length <= _LONG_LEGS_CM[1] else {}


def _as_wide(options: Mapping[str, float | bool | str], claims: Sequence[Claim]) -> Mapping[str, float]:
    """Room of wide legs whose ends are told: narrowed by a cut they would keep that of wider ones above."""
    told = [float(c.value) for c in claims if c.name == "leg_width_cm" and not isinstance(c.value, str)]
    room, flare = (float(options.get(name, 0.0)) for name in ("leg_ease", "flare"))
    if not told or room < _WIDE_CM or told[0] - _LEG_CM > room + flare - _WIDER_CM:
        return {}
    room = max(min(room, told[0] - _LEG_CM), _CLOSEST_CM)
    return {
        "leg_ease": room,
        "flare": max(told[0] - _LEG_CM - room, -_MOST_NARROWED_CM),
        "hip_ease": _EASY_CM,
    }


def _above_cuffs(options: Mapping[str, float | bool | str], claims: Sequence[Claim]) -> Mapping[str, float]:
    """The length of legs that end in bands, which are sewn to their ends: else they lie on the feet."""
    stated = [float(c.value) for c in claims if c.name == "leg_cuff_cm" and not isinstance(c.value, str)]
    told = any(claim.name in ("inseam_cm", "length_cm") for claim in claims)
    length = float(options.get("length", _FULL_CM))
    if told or length < _LONG_LEGS_CM[0] or not (stated or _BANDED in claims):
        return {}
    return {"length": length - max([*stated, _CUFF_CM][0] - _BELOW_CUFFS_CM, 0.0)}


def _has_legs(claim: Claim) -> bool:
    if claim.name == "leg_hem":
        return claim.value != "very short"
    return claim.name in ("legs", "leg_cuffs", "inseam_cm", "leg_width_cm") and claim.value not in (
        "slim",
        "none",
    )
