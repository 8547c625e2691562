"""Slits that a text asks a draft for, and how long those of side seams are."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

from swifttailor.describing.claims import Claim
from swifttailor.pattern.drafts.draft_names import BACK_SLIT, SIDE_SLITS, NamedDraft

_HIGH = Claim("slit_size", "high")
_USUAL_CM, _HIGH_CM = 14.0, 30.0
_SHORTEST_CM, _LONGEST_CM = 4.0, 40.0
"""Figures beyond these are not drafted in side seams."""
_SIDES = (Claim("slit", "left"), Claim("slit", "right"))
_HAVE_SIDE_SEAMS = frozenset(
    {"t-shirt", "tank-top", "turtleneck", "shift-dress", "hooded-coat", "shirt", "polo-shirt", "kaftan"}
)
_SLIT_BEHIND, _BEHIND, _BEHIND_CM = "shift-dress", Claim("slit", "back"), 22.0
"""The draft whose back may be open above the hem, and how far where nothing is told, cm."""
_KAFTAN = "kaftan"
"""So long that lower slits than high ones are not seen."""
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


def side_slits_cm(claims: Sequence[Claim], *, usual: float = _USUAL_CM) -> float:
    """How long slits in the side seams of what hangs from the shoulders are, cm: as told, if at all."""
    told = [float(claim.value) for claim in claims if claim.name == "slit_cm"]
    if told and _SHORTEST_CM <= told[0] <= _LONGEST_CM:
        return told[0]
    return _HIGH_CM if _HIGH in claims else usual


def slit_at_both_sides(claims: Sequence[Claim]) -> bool:
    """Whether both side seams are to be open."""
    return all(slit in claims for slit in _SIDES)


def with_side_slits(draft: NamedDraft, claims: Sequence[Claim]) -> NamedDraft:
    """A draft with its side seams open where both are to be; one that has such slits by its name keeps these.

    So is the seam in the middle of the back of a straight dress.

    Args:
        draft: As it goes with what else is asked for.
        claims: What is asked for, all of it.
    """
    if draft.name == _SLIT_BEHIND and _BEHIND in claims and BACK_SLIT not in dict(draft.options):
        return replace(draft, options=(*draft.options, (BACK_SLIT, side_slits_cm(claims, usual=_BEHIND_CM))))
    opens = draft.name in _HAVE_SIDE_SEAMS and SIDE_SLITS not in dict(draft.options)
    if not opens or not slit_at_both_sides(claims):
        return draft
    length = side_slits_cm(claims, usual=_HIGH_CM if draft.name == _KAFTAN else _USUAL_CM)
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
