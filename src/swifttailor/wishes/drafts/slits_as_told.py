"""Slits that a text asks a draft for, and how long those of side seams are."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

from swifttailor.describing.claims import Claim
from swifttailor.pattern.drafts.draft_names import SIDE_SLITS, NamedDraft

_HIGH = Claim("slit_size", "high")
_USUAL_CM, _HIGH_CM = 14.0, 30.0
_SHORTEST_CM, _LONGEST_CM = 4.0, 40.0
"""Figures beyond these are not drafted in side seams."""
_SIDES = (Claim("slit", "left"), Claim("slit", "right"))
_HAS_SIDE_SEAMS = (
    *("t-shirt", "tank-top", "turtleneck", "shift-dress", "hooded-coat", "shirt", "polo-shirt", "kaftan"),
)
_SWEATSHIRT, _SHORT = "sweatshirt", ("cap", "short", "elbow")
_KNITTED = NamedDraft.parse("t-shirt(length=26;chest_ease=16;sleeve_length=60;sleeve_end=24;arm_ease=9)")
"""No ribbed band goes around an open hem, nor around a wide sleeve."""
SLIT_SKIRT_CM, _FLARE = 72.0, 4.0
_GOWN_CM = 88.0
_OF_GOWNS = (
    *("neckline", "neck_depth", "neck_widening", "bust_ease", "waist_ease"),
    *("sleeve_length", "arm_ease", "sleeve_end"),
)
_ENDS: Mapping[str, float] = {"maxi": 103.0, "ankle": 96.0, "floor": 104.0}
"""Lengths of skirts with slits, cm, how they flare, degrees, and how long those are that are to end so. They
are drafted long, as a slit over the joint of what was made longer opens in steps."""


def is_slit(claims: Sequence[Claim]) -> bool:
    """Whether a slit is asked for."""
    return any(claim.name == "slit" and claim.value != "none" for claim in claims)


def side_slits_cm(claims: Sequence[Claim]) -> float:
    """How long slits in the side seams of what hangs from the shoulders are, cm: as told, if at all."""
    told = [float(claim.value) for claim in claims if claim.name == "slit_cm"]
    if told and _SHORTEST_CM <= told[0] <= _LONGEST_CM:
        return told[0]
    return _HIGH_CM if _HIGH in claims else _USUAL_CM


def with_side_slits(draft: NamedDraft, claims: Sequence[Claim]) -> NamedDraft:
    """A draft with its side seams open where both are to be, jumpers as knitted tops without bands.

    Args:
        draft: As it goes with what else is asked for.
        claims: What is asked for, all of it.
    """
    both = SIDE_SLITS not in dict(draft.options) and all(slit in claims for slit in _SIDES)
    if draft.name == _SWEATSHIRT and (both or any(Claim("sleeves", length) in claims for length in _SHORT)):
        draft = _KNITTED
    if draft.name not in _HAS_SIDE_SEAMS or not both:
        return draft
    length = side_slits_cm(claims)
    length = max(length, _HIGH_CM) if draft.name == "kaftan" and not _is_told(claims) else length
    return replace(draft, options=(*draft.options, (SIDE_SLITS, length)))


def close_for_a_slit(draft: NamedDraft, claims: Sequence[Claim]) -> NamedDraft:
    """A close skirt, or a dress with one, for a wide one: there a slit is seen.

    A gown keeps its length, its neckline and its sleeves.

    Args:
        draft: Of a circle skirt or of a dress with one.
        claims: What is asked for, all of it.
    """
    if draft.name == "circle-skirt":
        kept = {name: value for name, value in draft.options if name in ("length", "band_height")}
        return NamedDraft("fitted-skirt", tuple({**kept, "flare": _FLARE}.items()))
    options = dict(draft.options)
    if float(options.get("skirt_length", 0.0)) >= _GOWN_CM:
        kept = {name: options[name] for name in _OF_GOWNS if name in options}
        return NamedDraft("fitted-dress", tuple({**kept, "skirt_length": 97.0, "skirt_flare": 6.0}.items()))
    ends = [str(claim.value) for claim in claims if claim.name == "skirt_hem"]
    length = next((_ENDS[end] for end in ends if end in _ENDS), SLIT_SKIRT_CM)
    return NamedDraft("fitted-dress", (("skirt_length", length),))


def _is_told(claims: Sequence[Claim]) -> bool:
    return any(claim.name == "slit_cm" for claim in claims)
