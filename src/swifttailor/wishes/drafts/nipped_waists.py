"""Dresses that are to be close at the waist, and of whose skirt that says nothing."""

from __future__ import annotations

import re
from dataclasses import replace

from swifttailor.pattern.drafts.draft_names import NamedDraft

_SAID = re.compile(
    r"(?<!\w)(?:nipped(?:[- ]in)?(?: at the| in the)?[- ]waist(?:ed)?"
    r"|(?:tiny|tight|close|fitted|cinched|narrow)(?: at the| in the)?[- ]waist(?:ed)?"
    r"|waist,? (?:that is |is |really |very |super )*(?:nipped|cinched|pulled)[- ]in"
    r"|(?:nipped|cinched|pulled) in (?:at|around) the (?:middle|waist)"
    r"|(?:close|tight|fitted|close[- ]fitting) (?:on top|at the top|bodice))(?!\w)",
    re.IGNORECASE,
)
_DENIED = re.compile(r"(?<!\w)(?:no|not|nothing|without|never|isn't|n't)(?: \w+){0,2} $", re.IGNORECASE)
_DRAFTS = ("skater-dress", "shirt-dress", "strappy-dress")
_BUST_CM, _WAIST_CM = 4.0, 1.5
"""Most room that such a bodice has, all around."""


def nipped_as_said(draft: NamedDraft, text: str) -> NamedDraft:
    """A dress with a waist seam, its bodice closer where a text says so; others as they are.

    Args:
        draft: As it goes with all else that is asked for.
        text: The words.
    """
    found = _SAID.search(text)
    if draft.name not in _DRAFTS or found is None or _DENIED.search(text[: found.start()]):
        return draft
    options = dict(draft.options)
    close = {
        "bust_ease": min(float(options.get("bust_ease", _BUST_CM)), _BUST_CM),
        "waist_ease": min(float(options.get("waist_ease", _WAIST_CM)), _WAIST_CM),
    }
    return replace(draft, options=tuple({**options, **close}.items()))
