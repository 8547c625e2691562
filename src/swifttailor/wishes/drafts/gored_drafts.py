"""Gored skirts that flare from the knee, where a text says so."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace

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


def gored_as_said(drafts: Sequence[NamedDraft], text: str) -> list[NamedDraft]:
    """Gored skirts, close over the hips and flared from the knee where a text says so.

    They come in place of those with a flounce from the knee, which have no gores.

    Args:
        drafts: As they go with all else that is asked for.
        text: The words.
    """
    gored = [_gored(draft, text) for draft in drafts]
    if not any("close" in dict(draft.options) for draft in gored if draft.name == _GORED):
        return gored
    return [draft for draft in gored if draft.name != _FLOUNCED]


def _gored(draft: NamedDraft, text: str) -> NamedDraft:
    if draft.name != _GORED or not _FROM_THE_KNEE.search(text):
        return draft
    options = dict(draft.options)
    length = max(float(options.get("length", _USUAL_CM)), _CLOSE_TO_CM + _LEAST_BELOW_CM)
    return replace(
        draft,
        options=tuple({**options, "length": length, "close": _CLOSE_TO_CM, "hip_ease": _HIP_CM}.items()),
    )
