"""Dresses that are to be fitted, where nothing says that their skirt is to widen: close down to the hem."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import replace

from swifttailor.describing.claims import Claim
from swifttailor.pattern.drafts import find_draft
from swifttailor.pattern.drafts.draft_names import NamedDraft

_ROUND, _FITTED, _HELD = "skater-dress", "fitted-dress", ("strapless-dress", "strappy-dress")
_CLOSE = Claim("fit", "close")
_STRAIGHT = frozenset({Claim("skirt", "straight"), Claim("hips", "close"), Claim("skirt", "pencil")})
_OTHERWISE = frozenset({"skirt", "hips", "waist_seam", "hem_shape", "tiers", "godets", "gores"})
"""What tells of a skirt otherwise."""
_SHAPED = ("gathers", "pleats", "hem_band", "hem_points", "hem_dip", "scallop_width", "flounce", "fitted")
_EASE_CM: Mapping[str, float] = {"bust_ease": 4.0, "waist_ease": 2.5, "hip_ease": 3.0}
_NARROWS, _LONG_CM, _LONG_NARROWS = -3.0, 84.0, 1.0
"""Slant of its sides, degrees; and from which length, cm, it is that of what reaches the ankles."""
_USUAL_CM: Mapping[str, float] = {"strapless-dress": 98.0}
_ELSE_CM = 60.0
"""Length of skirts where no option says otherwise, cm."""


def fitted_as_asked(draft: NamedDraft, told: Sequence[Claim], likely: Collection[Claim]) -> NamedDraft:
    """A dress with darts and a narrow skirt where one is to be fitted; others as they are.

    Args:
        draft: As it goes with what else is asked for.
        told: What is asked for, all of it.
        likely: What goes with that.
    """
    options = dict(draft.options)
    if draft.name not in (_ROUND, *_HELD) or _CLOSE not in told or _STRAIGHT.isdisjoint(likely):
        return draft
    if any(claim.name in _OTHERWISE for claim in told) or any(options.get(name) for name in _SHAPED):
        return draft
    long = float(options.get("skirt_length", _USUAL_CM.get(draft.name, _ELSE_CM)))
    flare = {"skirt_flare": _NARROWS if long < _LONG_CM else _LONG_NARROWS}
    if draft.name in _HELD:
        options.pop("skirt_fraction", None)
        return replace(draft, options=tuple({**options, "fitted": True, **flare}.items()))
    own = {field.name for field in find_draft(_FITTED).options}
    kept = {name: value for name, value in options.items() if name in own}
    return NamedDraft(_FITTED, tuple({**kept, **_EASE_CM, **flare, "skirt_length": long}.items()))
