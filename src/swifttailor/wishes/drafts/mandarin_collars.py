"""Named drafts whose collar stands: open in the middle of the front, or as high as a word says."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace

from swifttailor.pattern.drafts.draft_names import MANDARIN, STANDING, NamedDraft
from swifttailor.wording.lexicon import Entry

_CLOSED = ("sweatshirt", "cape")
"""Drafts whose collars stand all around alone."""
_SPLIT, _HEIGHT = ("split", True), "collar_height"
_STANDING = (STANDING[1], MANDARIN[1])


def asks_for_mandarin_collar(entries: Iterable[Entry]) -> bool:
    """Whether one of the words of a text, by their entries of the lexicon, is such a collar."""
    return any(not {_SPLIT, MANDARIN}.isdisjoint(draft.options) for e in entries for draft in e.drafts)


def with_mandarin_collar(draft: NamedDraft) -> NamedDraft:
    """A draft whose collar stands, open in front; as it is where it stands otherwise, or not at all."""
    options = dict(draft.options)
    if draft.name == "turtleneck" and options.get("rolled") is False:
        return replace(draft, options=tuple({**options, _SPLIT[0]: _SPLIT[1]}.items()))
    if STANDING in draft.options and draft.name not in _CLOSED:
        return replace(draft, options=tuple({**options, MANDARIN[0]: MANDARIN[1]}.items()))
    return draft


def as_high_as_said(draft: NamedDraft, entries: Iterable[Entry]) -> NamedDraft:
    """A draft with a collar that stands as high as the one that a word names: a huge standing collar.

    Args:
        draft: As it goes with what else is asked for.
        entries: Of the words of the text.
    """
    stands = not {STANDING, MANDARIN, ("standing", True)}.isdisjoint(draft.options)
    told = [dict(d.options) for e in entries if e.category == "styles" for d in e.drafts]
    heights = [own[_HEIGHT] for own in told if _HEIGHT in own and own.get("collar") in _STANDING]
    if not stands or not heights:
        return draft
    return replace(draft, options=tuple({**dict(draft.options), _HEIGHT: heights[0]}.items()))
