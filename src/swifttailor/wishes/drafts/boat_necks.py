"""Drafts with a boat neck: wide along the shoulders, and nearly straight from one to the other."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from swifttailor.describing.claims import Claim
from swifttailor.pattern.drafts.draft_names import NamedDraft

_BOAT = Claim("neckline", "boat")
_WIDE = ("t-shirt", "tank-top", "fitted-top", "fitted-dress", "skater-dress", "shift-dress", "swing-dress")
"""Drafts whose necklines may be so wide."""
_WIDENING_CM, _DEPTH_CM, _BACK_CM = 6.0, 7.5, 3.0
_STRAP_CM = 4.0
"""What is left of the shoulder of a tank top."""
_OTHERWISE = frozenset({"neck_depth", "neck_depth_cm", "back_depth", "back_neckline", "hood"})


def boat_as_asked(draft: NamedDraft, claims: Sequence[Claim]) -> NamedDraft:
    """A draft with the boat neck that is asked for; as it is where more is said of how deep it is.

    Args:
        draft: Fits what is asked for.
        claims: What is asked for, all of it.
    """
    told = {claim.name for claim in claims}
    if _BOAT not in claims or draft.name not in _WIDE or told & _OTHERWISE or draft.stands:
        return draft
    cut: dict[str, float | str] = {"neck_widening": _WIDENING_CM, "neck_depth": _DEPTH_CM}
    cut["back_neck_depth"] = _BACK_CM
    if draft.name == "tank-top":
        cut["strap_width"] = _STRAP_CM
    return replace(draft, options=tuple({**dict(draft.options), **cut}.items()))
