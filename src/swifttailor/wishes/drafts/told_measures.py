"""Drafts with what figures tell of them that cutting afterwards does not reach: full hems, short tops."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import replace

from swifttailor.describing.claims import Claim
from swifttailor.pattern.drafts.draft_names import NamedDraft

_FLARED = Claim("skirt", "flared")
_FULL_CM = 170.0
"""Dresses whose hem is told to be so wide are not close."""
_STRAIGHT_CM = 125.0
"""Skirts whose hem is told to be no wider are straight."""
_ROUND: Mapping[str, float] = {"skater-dress": 60.0, "strapless-dress": 98.0, "strappy-dress": 62.0}
"""Drafts with a skirt cut from a circle, and its length where no option says otherwise, cm."""
_WAIST_CM, _LEAST, _MOST = 86.0, 0.3, 1.5
_NOT_ROUND = ("gathers", "fitted", "flounce", "pleats", "hem_band")
_TO_THE_WAIST_CM: Mapping[str, float] = {
    **dict.fromkeys(("t-shirt", "sweatshirt", "hoodie", "turtleneck", "blazer", "cardigan"), 34.0),
    **dict.fromkeys(("tank-top", "camisole"), 33.0),
    "shirt": 35.0,
}
"""From the shoulder to the waist on their patterns: their option of length begins there."""
_SHORT = frozenset({Claim("top_hem", "cropped"), Claim("top_hem", "waist")})
_ABOVE_CM, _BELOW_CM = -6.0, 30.0


def full_by_figures(kind: str | None, sure: Sequence[Claim]) -> list[Claim]:
    """That the skirt of a dress is flared, where its hem is told to be wide and nothing tells its shape."""
    wide = any(c.name == "hem_cm" and not isinstance(c.value, str) and c.value >= _FULL_CM for c in sure)
    told = any(claim.name in ("skirt", "tiers", "gores", "godets") for claim in sure)
    return [_FLARED] if kind == "dress" and wide and not told else []


def as_told(draft: NamedDraft, claims: Sequence[Claim]) -> NamedDraft:
    """A draft with the hem and the length that figures tell; others as they are.

    Args:
        draft: As it goes with all else that is asked for.
        claims: What is asked for, all of it.
    """
    told = {c.name: float(c.value) for c in claims if c.name.endswith("_cm") and not isinstance(c.value, str)}
    options = dict(draft.options)
    hem, length = told.get("hem_cm"), told.get("length_cm")
    if hem is not None and draft.name == "circle-skirt" and hem <= _STRAIGHT_CM:
        own = told.get("skirt_length_cm", options.get("length"))
        return NamedDraft("fitted-skirt", () if own is None else (("length", float(own)),))
    if hem is not None and draft.name in _ROUND and not any(options.get(name) for name in _NOT_ROUND):
        long = told.get("skirt_length_cm", float(options.get("skirt_length", _ROUND[draft.name])))
        part = (hem - _WAIST_CM) / (2 * math.pi * long)
        options["skirt_fraction"] = round(min(max(part, _LEAST), _MOST), 2)
    if length is not None and draft.name in _TO_THE_WAIST_CM and not _SHORT.isdisjoint(claims):
        below = length - _TO_THE_WAIST_CM[draft.name]
        options["length"] = round(min(max(below, _ABOVE_CM), _BELOW_CM), 1)
    return draft if options == dict(draft.options) else replace(draft, options=tuple(options.items()))
