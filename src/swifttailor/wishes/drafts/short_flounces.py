"""Skirts that are close and flare below, of which a short length is asked: then the flare begins higher."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

from swifttailor.describing.claims import Claim
from swifttailor.pattern.drafts.draft_names import NamedDraft

_LENGTHS: Mapping[str, str] = {"mermaid-skirt": "length", "mermaid-dress": "skirt_length"}
"""Such drafts, and the option of the length of the skirt."""
_CM: Mapping[str, tuple[float, float]] = {
    "mini": (44.0, 30.0),
    "above the knee": (50.0, 33.0),
    "knee": (58.0, 39.0),
    "below the knee": (66.0, 45.0),
    "midi": (80.0, 53.0),
}
"""By where the hem is to end, how long the skirt is, and its close part, both from the waist, cm."""


def short_flounce_as_asked(draft: NamedDraft, claims: Sequence[Claim]) -> NamedDraft:
    """A close skirt whose flounce is a third of it where it is to be short; others as they are.

    Args:
        draft: As it was asked for otherwise.
        claims: What is asked for, all of it.
    """
    options = dict(draft.options)
    length = _LENGTHS.get(draft.name)
    hems = [_CM[str(claim.value)] for claim in claims if claim.name == "skirt_hem" and claim.value in _CM]
    if length is None or not hems or options.get("tiers"):
        return draft
    long, close = hems[0]
    own = float(options.get("close", close))
    grows = float(options.get(length, long)) < long  # so does what is above the flounce
    close = close if grows else min(own, close)
    return replace(draft, options=tuple({**options, length: long, "close": close}.items()))
