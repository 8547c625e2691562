"""Named drafts of skirts and dresses in tiers, as long and full as is asked for, and close over the hips."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

from swifttailor.describing.claims import Claim
from swifttailor.pattern.drafts.draft_names import NamedDraft
from swifttailor.wishes.drafts.held_drafts import on_straps_that_hold

_TIERED, _CLOSE_SKIRT, _CLOSE_DRESS = "tiered-skirt", "mermaid-skirt", "mermaid-dress"
_ON_STRAPS, _LIGHT = "strappy-dress", {"skirt_fraction": 0.35}
_TO_BE_TIERED = (_CLOSE_SKIRT, "circle-skirt", "gathered-skirt")
_IN_TIERS = frozenset({Claim("skirt", "tiered"), Claim("skirt", "gathered tiers")})
_CLOSE = frozenset({Claim("skirt", "fitted base"), Claim("hips", "close")})
_WIDE = frozenset(
    {
        *[Claim("skirt", value) for value in ("flared", "circle", "more than a circle", "gathered")],
        Claim("hips", "loose"),
    }
)
_LENGTHS: Mapping[str, float] = {
    "micro": 36.0,
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
_USUAL_CM, _SHORTEST_CLOSE_CM = 62.0, 50.0
_CLOSE_SHARE, _CLOSE_CM = 0.46, (30.0, 52.0)
"""How much of the length the close part is, and its bounds, cm."""
_CLOSE_TIERS, _MOST = 3, 6
_KEPT = ("tiers", "fullness", "close", "below_waist")
_FULL = 1.8
"""Width of each tier of a wide skirt over that of the one above."""


def tiers_as_asked(draft: NamedDraft, claims: Sequence[Claim]) -> NamedDraft:
    """A skirt or close dress whose tiers are all of one height, as they are asked for; others as they are.

    Args:
        draft: As a table names it.
        claims: What is asked for, all of it.
    """
    asked = frozenset(claims)
    own = dict(draft.options)
    counts = [round(float(c.value)) for c in claims if c.name == "tiers" and not isinstance(c.value, str)]
    counts = [count for count in counts if 1 < count <= _MOST]
    tiered = bool(counts) or not _IN_TIERS.isdisjoint(asked)
    if draft.name == _CLOSE_DRESS:
        if not tiered and not own.get("tiers"):
            return draft
        tiers = float(counts[0] if counts else own.get("tiers") or _CLOSE_TIERS)
        return replace(draft, options=tuple({**own, "tiers": tiers}.items()))
    ends = [_LENGTHS[str(c.value)] for c in claims if c.name == "skirt_hem" and c.value in _LENGTHS]
    if draft.name == _ON_STRAPS and tiered and ends:  # lengthened later, its last tier alone would be long
        return on_straps_that_hold(
            replace(draft, options=tuple({**own, **_LIGHT, "skirt_length": ends[0]}.items()))
        )
    if draft.name not in (_TIERED, *_TO_BE_TIERED) or (draft.name != _TIERED and not tiered):
        return draft
    stated = [float(c.value) for c in claims if c.name == "skirt_length_cm" and not isinstance(c.value, str)]
    length = min(max([*stated, *ends, float(own.get("length", _USUAL_CM))][0], 36.0), 100.0)
    options = {name: value for name, value in own.items() if name in _KEPT}
    options["length"] = length
    close = draft.name == _CLOSE_SKIRT or not _CLOSE.isdisjoint(asked) or bool(own.get("close"))
    if close and length >= _SHORTEST_CLOSE_CM:
        options["close"] = round(min(max(_CLOSE_SHARE * length, _CLOSE_CM[0]), _CLOSE_CM[1]), 1)
        options.setdefault("tiers", float(_CLOSE_TIERS))
        options.pop("below_waist", None)
    elif not _WIDE.isdisjoint(asked):
        options.setdefault("fullness", _FULL)
    if counts:
        options["tiers"] = float(counts[0])
    return NamedDraft(_TIERED, tuple(options.items()))
