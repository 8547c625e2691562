"""Named drafts whose skirts are narrow enough for a slit to be seen in them: a wide one falls over it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from swifttailor.describing.claims import Claim
from swifttailor.pattern.drafts.draft_names import NamedDraft

_OF_CIRCLES = ("strapless-dress", "strappy-dress", "off-shoulder-dress")
_FROM_A_CIRCLE = "off-shoulder-dress"
"""One of these whose skirt cannot be close over the hips."""
_NARROWEST, _FLARE_CM = 0.3, 4.0
"""The part of a circle that its skirt is cut from then, and how far others slant at the sides, cm."""
_SLIP, _SLIP_CM, _THIN_CM = "slip-dress", 72.0, 1.2
"""What is cut in one, how long it is where nothing is told, and its straps, cm."""
_ONE_SIDE = (Claim("slit", "left"), Claim("slit", "right"))


def slit_as_asked(draft: NamedDraft, claims: Sequence[Claim]) -> NamedDraft:
    """A dress that is cut from a part of a circle, narrower where a slit at one side is asked for.

    Args:
        draft: As it goes with what else is asked for.
        claims: What is asked for, all of it.
    """
    options = dict(draft.options)
    if draft.name == _SLIP and any(slit in claims for slit in _ONE_SIDE):  # of one piece from the straps down
        kept = {"skirt_length": options.get("length", _SLIP_CM), "strap_width": _THIN_CM}
        return NamedDraft("strappy-dress", tuple({**kept, "fitted": True, "skirt_flare": _FLARE_CM}.items()))
    shaped = any(options.get(name) for name in ("fitted", "flounce", "gathers"))
    if draft.name not in _OF_CIRCLES or shaped or sum(slit in claims for slit in _ONE_SIDE) != 1:
        return draft
    if any(claim.name == "skirt" for claim in claims):
        return draft
    if draft.name == _FROM_A_CIRCLE:
        narrow: dict[str, float | bool] = {"skirt_fraction": _NARROWEST}
    else:
        narrow = {"fitted": True, "skirt_flare": _FLARE_CM}
    options.pop("skirt_fraction", None)
    if (
        Claim("straps", "narrow") in claims and "strap_width" in options
    ):  # so light a skirt hangs on thin ones
        options["strap_width"] = _THIN_CM
    return replace(draft, options=tuple({**options, **narrow}.items()))
