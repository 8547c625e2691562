"""Gored skirts that flare from the knee, where a text says so."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import replace

from swifttailor.describing.claims import Claim
from swifttailor.pattern.drafts.draft_names import NamedDraft

_FROM_THE_KNEE = re.compile(
    r"(?<!\w)(?:(?:flar\w+|wid\w+|open\w*|kick\w*|fan\w*|out)(?: out)?(?: only)?"
    r" (?:from|at|below|after|under) (?:the |my )?knees?|mermaid|trumpet|fishtail)(?!\w)",
    re.IGNORECASE,
)
_FLOUNCED = "mermaid-skirt"
_GORED, _CLOSE_TO_CM, _LEAST_BELOW_CM = "gored-skirt", 50.0, 22.0
"""How far below the waist they begin to flare, and how much there is below it, cm."""
_USUAL_CM, _HIP_CM = 66.0, 2.5
"""Length where none is given, and the room at the hips of what is close there, cm."""


_TRUMPET = re.compile(r"(?<!\w)(?:mermaid|trumpet|fishtail)(?!\w)", re.IGNORECASE)
_LONG_CM, _WIDE_CM = 96.0, 100.0
"""Length of those that are long by their name, and by how much their hem is wider than the hips, cm."""
_CM: Mapping[str, tuple[float, float]] = {
    "knee": (60.0, 40.0),
    "below the knee": (66.0, 44.0),
    "midi": (78.0, 50.0),
    "maxi": (96.0, 58.0),
    "ankle": (96.0, 58.0),
    "floor": (100.0, 60.0),
}
"""Of told lengths how long they are, and where they begin to flare, cm."""


def gored_as_said(drafts: Sequence[NamedDraft], text: str, claims: Sequence[Claim] = ()) -> list[NamedDraft]:
    """Gored skirts, close over the hips and flared from the knee where a text says so.

    They come in place of those with a flounce from the knee, which have no gores.

    Args:
        drafts: As they go with all else that is asked for.
        text: The words.
        claims: What is asked for, all of it.
    """
    gored = [_gored(draft, text, claims) for draft in drafts]
    if not any("close" in dict(draft.options) for draft in gored if draft.name == _GORED):
        return gored
    return [draft for draft in gored if draft.name != _FLOUNCED]


def _gored(draft: NamedDraft, text: str, claims: Sequence[Claim]) -> NamedDraft:
    if draft.name != _GORED or not _FROM_THE_KNEE.search(text):
        return draft
    options = dict(draft.options)
    hems = [_CM[str(claim.value)] for claim in claims if claim.name == "skirt_hem" and claim.value in _CM]
    usual = _LONG_CM if _TRUMPET.search(text) else _USUAL_CM
    long, close = hems[0] if hems else (float(options.get("length", usual)), _CLOSE_TO_CM)
    long = max(long, close + _LEAST_BELOW_CM) if not hems else long
    shape = {"length": long, "close": close, "hip_ease": _HIP_CM, "flare": _WIDE_CM}
    return replace(draft, options=tuple({**options, **shape}.items()))
