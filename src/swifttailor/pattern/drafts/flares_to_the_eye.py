"""Drafts whose skirts are seen to flare, though less than what is measured as such."""

from __future__ import annotations

from collections.abc import Mapping

SLANTING = 9.0
"""Degrees from which close skirts that slant at the sides flare."""
_BAND = "hem_band"
"""The option of a band that draws a hem in."""
_SLANT: Mapping[str, str] = {"fitted-skirt": "flare", "fitted-dress": "skirt_flare"}


def flares_to_the_eye(name: str, options: Mapping[str, float | bool | str], *, full: float) -> bool:
    """Whether a skirt is seen to flare.

    Args:
        name: Of the draft.
        options: Its options.
        full: Width of a gathered skirt over that of its upper edge, over what makes it flare.
    """
    slant = options.get(_SLANT.get(name, ""), 0.0)
    return float(slant) >= SLANTING or (full >= 1.0 and not options.get(_BAND))
