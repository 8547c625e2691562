"""Bodices that end straight across, where a text asks for that and their usual edge is a heart or dips."""

from __future__ import annotations

import re
from dataclasses import replace

from swifttailor.pattern.drafts.draft_names import NamedDraft

_STRAIGHT = re.compile(
    r"(?<!\w)(?:(?:straight|level|horizontal)(?:[ -]across)? (?:neck(?:line)?|top edge|upper edge"
    r"|edge at the top|bust ?line|bodice edge)"
    r"|straight across (?:the (?:top|chest|bust)|neck(?:line)?|at the (?:top|bust|chest))"
    r"|cut straight across)(?!\w)",
    re.IGNORECASE,
)
_HEARTS = re.compile(r"(?<!\w)(?:sweet)?heart", re.IGNORECASE)
_DIPS = ("strapless-dress", "bustier", "strapless-jumpsuit", "strappy-dress", "camisole", "slip-dress")
"""Drafts whose upper edge may be a heart, or dip between straps."""
_DIP = "dip"


def straight_as_said(draft: NamedDraft, text: str) -> NamedDraft:
    """A bodice without a heart or a dip where a text asks for a straight upper edge; others as they are.

    Args:
        draft: As it goes with all else that is asked for.
        text: The words.
    """
    if draft.name not in _DIPS or not _STRAIGHT.search(text) or _HEARTS.search(text):
        return draft
    return replace(draft, options=tuple({**dict(draft.options), _DIP: 0.0}.items()))
