"""Named drafts with the hem that a text asks for: curved, longer behind, in arcs, in points, or straight."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import replace

from swifttailor.describing.claims import Claim
from swifttailor.pattern.drafts.draft_names import (
    CURVED_HEM,
    HEM_DIP,
    HEM_POINTS,
    HEM_RISE,
    SCALLOPS,
    NamedDraft,
)

RISE_CM = 6.0
"""How much higher a curved hem is at the side seams than in the middle."""
_MAY_CURVE = ("shirt", "t-shirt", "tank-top", "shift-dress")
_MAY_DIP, _TOP_DIP_CM = ("shirt", "t-shirt", "tank-top", "turtleneck"), 8.0
"""Tops whose hem may be longer behind, and by how much it then is, cm."""
_LEVEL = Claim("hem_shape", "level")
_LONGER_BEHIND, _SCALLOPED = Claim("hem_shape", "high-low"), Claim("hem_shape", "scalloped")
_POINTED = Claim("hem_shape", "pointed")
_ROUND: Mapping[str, str] = {"circle-skirt": "length", "skater-dress": "skirt_length"}
"""Drafts whose hem may dip or be cut in arcs, and their option of its length in front."""
_DIP_CM, _LOWEST_CM, _ARCS_CM = 34.0, 102.0, 10.0
_IN_FRONT: Mapping[str, float] = {"micro": 38.0, "mini": 42.0, "above the knee": 50.0, "knee": 57.0}
"""Where hems that are longer behind end in front, below the waist, by what is asked for."""
_USUAL_CM, _FULL = 50.0, 0.5
_POINTS_CM, _MIDI_CM, _POINTED_FULL = 20.0, 62.0, 0.75
"""How far points hang down, where the hem is above those of longer skirts, and the part of a circle."""
_FRACTIONS: Mapping[str, tuple[str, float]] = {
    "circle-skirt": ("fraction", 0.75),
    "skater-dress": ("skirt_fraction", 0.75),
}
"""Option of the part of a circle, and its value where none is given; a narrower skirt hides its dip."""
_WAISTED = frozenset({"waist_seam", "skirt", "bodice"})
_SHIRT_DRESS = "shirt-dress"
_STRAIGHT_DRESS = {
    "chest_ease": 14.0,
    "flare": 0.0,
    "length": 52.0,
    "sleeves": True,
    "sleeve_length": 60.0,
    "sleeve_end": 27.0,
    "collar": "shirt",
}
"""A shirt dress whose hem is curved is a long shirt: it has no waist, unless that is asked for."""


def hem_as_asked(
    draft: NamedDraft, claims: Collection[Claim], lacks: Collection[str], denied: Collection[str]
) -> NamedDraft:
    """A named draft with a curved hem where one is asked for, and with a straight one where that is.

    Args:
        draft: As a table names it.
        claims: What is asked for, all of it.
        lacks: Keys of ``cannot.txt`` that the text asks for.
        denied: Keys of ``cannot.txt`` that it refuses.
    """
    options = dict(draft.options)
    if draft.name in _ROUND and not {_LONGER_BEHIND, _SCALLOPED, _POINTED}.isdisjoint(claims):
        return _shaped(draft, claims)
    if draft.name in _MAY_DIP and _LONGER_BEHIND in claims:
        return replace(draft, options=tuple({**options, HEM_DIP: _TOP_DIP_CM}.items()))
    if CURVED_HEM in lacks:
        if draft.name == _SHIRT_DRESS and not any(claim.name in _WAISTED for claim in claims):
            own = {name: options[name] for name in ("collar", "collar_height") if name in options}
            bare = Claim("sleeves", "none") in claims
            draft = NamedDraft("shift-dress")
            options = {**_STRAIGHT_DRESS, **own, **({"sleeves": False} if bare else {})}
        return _with(draft, options, RISE_CM) if draft.name in _MAY_CURVE else draft
    if HEM_RISE in options and (_LEVEL in claims or CURVED_HEM in denied):
        return _with(draft, options, 0.0)
    return draft


def _shaped(draft: NamedDraft, claims: Collection[Claim]) -> NamedDraft:
    """A round skirt, or a dress with one, whose hem is cut in arcs or lower behind than in front."""
    options = dict(draft.options)
    if options.get("gathers"):
        return draft
    if _POINTED in claims:
        return _pointed(draft, claims)
    if _LONGER_BEHIND not in claims:
        return replace(draft, options=tuple({**options, SCALLOPS: _ARCS_CM}.items()))
    ends = [str(claim.value) for claim in claims if claim.name == "skirt_hem"]
    front = next((_IN_FRONT[end] for end in ends if end in _IN_FRONT), _USUAL_CM)
    fraction, usual = _FRACTIONS[draft.name]
    full = max(_FULL, float(options.get(fraction, usual)))
    dipped = {_ROUND[draft.name]: front, fraction: full, HEM_DIP: min(_DIP_CM, _LOWEST_CM - front)}
    return replace(draft, options=tuple({**options, **dipped}.items()))


def _pointed(draft: NamedDraft, claims: Collection[Claim]) -> NamedDraft:
    """A round skirt, or a dress with one, whose hem hangs in points."""
    options = dict(draft.options)
    ends = [str(claim.value) for claim in claims if claim.name == "skirt_hem"]
    usual = _MIDI_CM if ends else _USUAL_CM
    above = next((_IN_FRONT[end] for end in ends if end in _IN_FRONT), usual)
    fraction, _ = _FRACTIONS[draft.name]
    full = max(_POINTED_FULL, float(options.get(fraction, _POINTED_FULL)))
    pointed = {_ROUND[draft.name]: above, fraction: full, HEM_POINTS: _POINTS_CM}
    return replace(draft, options=tuple({**options, **pointed}.items()))


def _with(draft: NamedDraft, options: dict[str, float | bool | str], rise: float) -> NamedDraft:
    return replace(draft, options=tuple({**options, HEM_RISE: rise}.items()))
