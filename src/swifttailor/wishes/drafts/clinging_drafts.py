"""Named drafts of what is to cling: smaller than the body, of cloth that stretches."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

from swifttailor.describing.claims import Claim
from swifttailor.pattern.drafts.draft_names import SIDE_SLITS, NamedDraft
from swifttailor.wishes.drafts.close_drafts import SHAPED_TO_CM

STRETCH, SHAPING = "stretch", "waist_shaping"
"""Key of ``cannot.txt`` and option of drafts; the option of how far side seams bend inward."""
_STRETCH_CM, _SHAPING_CM = 10.0, 4.0
"""Per cent by which such cloth is cut smaller, and the bend of the sides at the waist, cm."""
_OF_TOPS = 5.0, 3.0, 2.5
"""The same of tops, and their room at the chest: with less they ride up, and lie in a roll above the seat."""
_SPORT_STRETCH_CM, _OF_SPORT, _TO_THE_HIP = 8.0, (2.0, 4.0), (2.5, 2.5)
"""Tops of cloth that gives so much lie on the body all the way: their room at the chest and their bend; the
same of those to the hip, which would lie in a roll above the seat."""
_SPORT_LENGTH_CM, _WAIST_CM = 27.0, 12.0
"""They end low on the seat, which shorter ones ride up, unless they end at the waist, cm below it."""
_KNITTED = ("t-shirt", "tank-top", "turtleneck", "shift-dress")
"""Drafts without darts that follow the body where their cloth stretches."""
_TOPS, _CLOSE = _KNITTED[:3], Claim("fit", "close")
_DRESSES = ("fitted-dress", "skater-dress")
"""Drafts with a waist seam and darts that knitted dresses do without."""
_OF_DRESSES = (
    "neckline",
    "neck_widening",
    "neck_depth",
    "back_neck_depth",
    "sleeves",
    "sleeve_length",
    "sleeve_end",
    "sleeve_shape",
    "collar",
    "collar_width",
    "collar_height",
)
_SHORTEST_CM = 25.0
_DEEPEST_BACK_CM = 16.0
"""Backs that are bare further down end at a seam at the waist."""
_SKIRT_CM: Mapping[str, float] = {"fitted-dress": 60.0, "skater-dress": 50.0, "shirt-dress": 55.0}
_HEMS_CM: Mapping[str, float] = {
    **{"above the knee": 46.0, "knee": 54.0, "below the knee": 60.0},
    **{"midi": 74.0, "maxi": 88.0, "ankle": 93.0},
}
"""How long straight dresses are that are to end so, cm: recut, they would widen below the hips."""
_SHIRT_DRESS, _PULLED_ON = "shirt-dress", ("rolled", "standing")
"""Of shirt dresses, those that have such a collar, and no buttons."""
_SHIRT_SLEEVES: Mapping[str, float | bool] = {"sleeves": True, "sleeve_length": 58.0}
_CLOSE_SKIRTS = ("pencil", "straight", "narrowing")
_WITH_WAIST = frozenset({"waist_seam", "slit", "tiers", "gores"})
_CHEST_CM, _ARM_CM = 2.0, 4.0
"""Room on top of bust and arm, over the body as its cloth is cut for it."""
_SLEEVE_ENDS: Mapping[float, float] = {45.0: 20.0, 36.0: 24.0, 26.0: 26.0, 0.0: 29.0}
"""Width around at the end of sleeves that are at least so long, cm."""
_ALL_OVER = {"bust_ease": 3.0, "waist_ease": 2.0, "hip_ease": 2.0}
_CLOSER: Mapping[str, Mapping[str, float]] = {
    "jumpsuit": _ALL_OVER,
    "strappy-jumpsuit": _ALL_OVER,
    "strapless-jumpsuit": {"hip_ease": 2.0},
    "halter-jumpsuit": {"chest_ease": 2.0, "waist_ease": 2.0, "hip_ease": 2.0},
    "mermaid-dress": _ALL_OVER,
    "fitted-dress": _ALL_OVER,
    "fitted-skirt": {"hip_ease": 2.0},
}
"""Other drafts that may be of such cloth, and the room that they then have at most, cm."""
_NARROW_SKIRTS: Mapping[str, str] = {"fitted-dress": "skirt_flare", "fitted-skirt": "flare"}
_NARROWING, _LEAST_FLARE = -4.0, 3.0
"""Slant of the sides of skirts that cling, degrees, unless they are to flare by at least so much."""
_SLIM = {"leg_ease": 2.0, "flare": -7.0, "length": 96.0}
_WIDE_LEGS = frozenset({Claim("legs", "wide"), Claim("legs", "flared"), Claim("legs", "straight")})
_LESS_STRETCH = 8.0


def clinging_as_asked(draft: NamedDraft, claims: Sequence[Claim]) -> NamedDraft:
    """A draft of cloth that stretches, cut to lie on the body all over; others as they are.

    Args:
        draft: As it was asked for otherwise.
        claims: What is asked for, all of it.
    """
    bare = float(dict(draft.options).get("back_neck_depth", 0.0)) > _DEEPEST_BACK_CM
    collared = draft.name == _SHIRT_DRESS and dict(draft.options).get("collar") in _PULLED_ON
    if (draft.name in _DRESSES or collared) and not any(_has_waist(claim) for claim in claims):
        draft = _close_below(draft) if bare else _without_waist(draft)
    options = dict(draft.options)
    if draft.name in _KNITTED:
        stretch, room, shaping = (
            (_STRETCH_CM, _CHEST_CM, _SHAPING_CM) if draft.name == "shift-dress" else _OF_TOPS
        )
        own = float(options.get(STRETCH, 0.0))
        if draft.name != "shift-dress" and own >= _SPORT_STRETCH_CM:
            room, shaping = _OF_SPORT
            told = any(claim.name in ("top_hem", "length_cm") for claim in claims)
            if not told and float(options.get("length", _SPORT_LENGTH_CM)) >= _WAIST_CM:
                room, shaping = _TO_THE_HIP
                options["length"] = max(_SPORT_LENGTH_CM, float(options.get("length", 0.0)))
        options[STRETCH] = max(stretch, own)
        options |= {"chest_ease": room, SHAPING: shaping, "flare": 0.0}
        ends = [_HEMS_CM[str(c.value)] for c in claims if c.name == "skirt_hem" and c.value in _HEMS_CM]
        if draft.name == "shift-dress" and ends:
            options["length"] = ends[0]
        if draft.name != "tank-top":
            options |= _close_sleeves(draft.name, options)
        return replace(draft, options=tuple(options.items()))
    closer = _CLOSER.get(draft.name)
    if closer is None:
        return draft
    options |= {name: min(most, float(options.get(name, most))) for name, most in closer.items()}
    slant = _NARROW_SKIRTS.get(draft.name)
    if slant is not None and float(options.get(slant, 0.0)) < _LEAST_FLARE:
        options[slant] = min(float(options.get(slant, 0.0)), _NARROWING)
    options["stretch"] = max(_LESS_STRETCH, float(options.get("stretch", 0.0)))
    if draft.name.endswith("jumpsuit") and not _WIDE_LEGS.intersection(claims):
        options = {**_SLIM, **options, "leg_ease": min(float(options.get("leg_ease", 2.0)), 3.0)}
    return replace(draft, options=tuple(options.items()))


def top_clinging_as_asked(
    draft: NamedDraft, claims: Sequence[Claim], *, stretchy: bool = False
) -> NamedDraft:
    """A top that is pulled on and to be close, of no cloth that is told: of jersey; others as they are.

    Args:
        draft: As it was asked for otherwise.
        claims: What is asked for, all of it.
        stretchy: Whether its cloth is to stretch, so that it is close where nothing else is told.
    """
    options = dict(draft.options)
    close = _CLOSE in claims or (stretchy and not any(claim.name == "fit" for claim in claims))
    if not close or draft.name not in _TOPS or SIDE_SLITS in options:
        return draft
    if float(options.get("length", 99.0)) <= SHAPED_TO_CM and options.get(SHAPING):  # darted to the waist
        return draft
    return clinging_as_asked(draft, claims)


def _without_waist(draft: NamedDraft) -> NamedDraft:
    """A dress that falls from the shoulders in one, as long and with the same neck and sleeves."""
    options = dict(draft.options)
    length = max(float(options.get("skirt_length", _SKIRT_CM[draft.name])), _SHORTEST_CM)
    kept = {name: options[name] for name in _OF_DRESSES if name in options}
    if draft.name == _SHIRT_DRESS:
        kept = {**_SHIRT_SLEEVES, **kept}
    return NamedDraft("shift-dress", tuple({"length": length, **kept}.items()))


def _close_below(draft: NamedDraft) -> NamedDraft:
    """A dress whose back is bare to its waist, with a close skirt below that."""
    options = dict(draft.options)
    kept = {name: options[name] for name in (*_OF_DRESSES, "skirt_length") if name in options}
    return NamedDraft("fitted-dress", tuple(kept.items())) if draft.name == "skater-dress" else draft


def _close_sleeves(name: str, options: Mapping[str, float | bool | str]) -> Mapping[str, float]:
    usual = {"t-shirt": 22.0, "turtleneck": 58.5}.get(name, 24.0)
    length = float(options.get("sleeve_length", usual))
    if options.get("sleeve_shape", "plain") != "plain" or options.get("armhole") == "cut-in-one":
        return {}
    return {
        "arm_ease": _ARM_CM,
        "sleeve_end": next(end for least, end in _SLEEVE_ENDS.items() if length >= least),
    }


def _has_waist(claim: Claim) -> bool:
    """Whether what has this has a seam at the waist, or a skirt of its own."""
    return claim.name in _WITH_WAIST or (claim.name == "skirt" and claim.value not in _CLOSE_SKIRTS)
