"""Named drafts of skirts and dresses with the godets that a text asks for."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from swifttailor.describing.claims import Claim
from swifttailor.pattern.drafts.draft_names import NamedDraft

_GODETS = Claim("skirt", "godets")
_USUAL, _MOST = 6, 12
"""How many there are where nobody says, and how many can be let in."""
_A_LITTLE_FLARE = 2.0
"""Degrees: skirts that narrow to the hem hide what their godets add."""
_SKIRTS = ("fitted-skirt", "circle-skirt", "gored-skirt", "gathered-skirt", "mermaid-skirt")
_DRESSES = ("fitted-dress", "skater-dress", "mermaid-dress", "shift-dress", "shirt-dress", "slip-dress")
_OF_BOTH = ("stretch", "hip_ease", "band_height", "bust_ease", "waist_ease")
_OF_NECKS = ("neckline", "neck_widening", "neck_depth", "back_neck_depth", "collar", "collar_height")
_OF_SLEEVES = ("sleeves", "sleeve_length", "sleeve_end", "sleeve_shape", "arm_ease")
_LENGTHS: Mapping[str, float] = {
    "mini": 42.0,
    "above the knee": 50.0,
    "knee": 60.0,
    "below the knee": 66.0,
    "midi": 76.0,
    "maxi": 96.0,
    "ankle": 96.0,
    "floor": 100.0,
}
"""Waist to hem, by where the hem is to end, cm."""
_USUAL_CM = 66.0
_SHARE, _LEAST_CM, _MOST_CM = 0.48, 16.0, 45.0
"""Height of godets as a part of the skirt's length, and its bounds, cm."""
_WIDE_CM = 38.0


def godets_as_asked(draft: NamedDraft, claims: Sequence[Claim]) -> NamedDraft:
    """A close skirt or dress with godets in its hem, where those are asked for; other drafts as they are.

    Args:
        draft: As a table names it.
        claims: What is asked for, all of it.
    """
    counts = [round(float(c.value)) for c in claims if c.name == "godets" and not isinstance(c.value, str)]
    counts = [count for count in counts if 0 < count <= _MOST]
    if (_GODETS not in claims and not counts) or draft.name not in (*_SKIRTS, *_DRESSES):
        return draft
    own = dict(draft.options)
    ends = [_LENGTHS[str(c.value)] for c in claims if c.name == "skirt_hem" and c.value in _LENGTHS]
    stated = [float(c.value) for c in claims if c.name == "skirt_length_cm" and not isinstance(c.value, str)]
    asked = [*stated, *ends, *[float(own[k]) for k in ("skirt_length", "length") if k in own], _USUAL_CM]
    length = min(max(asked[0], 40.0), 100.0)
    of_dress = draft.name in _DRESSES
    kept = (*_OF_BOTH, *_OF_NECKS, *_OF_SLEEVES) if draft.name == "fitted-dress" else _OF_BOTH[:1]
    if draft.name == "skater-dress":
        kept = (*_OF_NECKS[:4], *_OF_SLEEVES, "bust_ease", "waist_ease")
    options = {name: value for name, value in own.items() if name in kept}
    options |= {("skirt_length" if of_dress else "length"): length}
    options |= {("skirt_flare" if of_dress else "flare"): _A_LITTLE_FLARE}
    options |= {
        "godets": float(counts[0] if counts else _USUAL),
        "godet_width": _WIDE_CM,
        "godet_height": round(min(max(_SHARE * length, _LEAST_CM), _MOST_CM), 1),
    }
    return NamedDraft("fitted-dress" if of_dress else "fitted-skirt", tuple(options.items()))
