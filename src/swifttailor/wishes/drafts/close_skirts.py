"""Skirts that are to be close over the hips, where the name of one begins from what is cut from a circle."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from swifttailor.describing.claims import Claim
from swifttailor.pattern.drafts.draft_names import NamedDraft

_CLOSE, _ROUND, _FITTED = Claim("hips", "close"), "circle-skirt", "fitted-skirt"
_FLARES: Mapping[str, float] = {"pencil": -7.0, "narrowing": -6.0, "straight": -2.0, "a-line": 6.0}
"""Slant of the sides, degrees, by what the skirt is said to be."""
_STRAIGHT, _EASE_CM, _USUAL_CM = -2.0, 3.0, 58.0
_KEPT = ("length", "band_height")


def close_skirt_as_asked(draft: NamedDraft, told: Sequence[Claim], said: Sequence[Claim]) -> NamedDraft:
    """A skirt with darts that is close over the hips, where that is asked for; others as they are.

    Args:
        draft: As it goes with what else is asked for.
        told: What is asked for, all of it.
        said: What of it details say, and no name means: a denim skirt widens, a fitted one does not.
    """
    shapes = [str(claim.value) for claim in said if claim.name == "skirt"]
    shaped = any(shape not in _FLARES for shape in shapes) or any(c.name == "hem_shape" for c in told)
    low = "below_waist" in dict(draft.options)
    if draft.name != _ROUND or _CLOSE not in told or shaped or low:
        return draft
    flare = _FLARES[shapes[0]] if shapes else _STRAIGHT
    kept = {name: value for name, value in draft.options if name in _KEPT}
    return NamedDraft(
        _FITTED, tuple({"length": _USUAL_CM, **kept, "flare": flare, "hip_ease": _EASE_CM}.items())
    )
