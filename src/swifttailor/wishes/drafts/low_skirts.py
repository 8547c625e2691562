"""Skirts that sit on the hips, where a text asks for that."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

from swifttailor.describing.claims import Claim
from swifttailor.pattern.drafts.draft_names import NamedDraft

_BELOW_WAIST: Mapping[Claim, float] = {Claim("rise", "low"): 14.0, Claim("rise", "mid"): 5.0}
"""How far below the waist the upper edge of the band is, cm."""
_LOW = ("circle-skirt", "tiered-skirt")


def low_as_asked(draft: NamedDraft, claims: Sequence[Claim]) -> NamedDraft:
    """A skirt on a band below the waist where that is asked for; others as they are.

    Args:
        draft: As it goes with what else is asked for.
        claims: What is asked for, all of it.
    """
    below = next((_BELOW_WAIST[claim] for claim in claims if claim in _BELOW_WAIST), None)
    if draft.name not in _LOW or below is None:
        return draft
    return replace(draft, options=tuple({**dict(draft.options), "below_waist": below}.items()))
