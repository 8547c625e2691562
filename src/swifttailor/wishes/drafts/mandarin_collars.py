"""Named drafts whose collar stands open in the middle of the front, where a word asks for such a one."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace

from swifttailor.pattern.drafts.draft_names import MANDARIN, STANDING, NamedDraft
from swifttailor.wording.lexicon import Entry

_SPLIT = ("split", True)


def asks_for_mandarin_collar(entries: Iterable[Entry]) -> bool:
    """Whether one of the words of a text, by their entries of the lexicon, is such a collar."""
    return any(not {_SPLIT, MANDARIN}.isdisjoint(draft.options) for e in entries for draft in e.drafts)


def with_mandarin_collar(draft: NamedDraft) -> NamedDraft:
    """A draft whose collar stands, open in front; as it is where it stands otherwise, or not at all."""
    options = dict(draft.options)
    if draft.name == "turtleneck" and options.get("rolled") is False:
        return replace(draft, options=tuple({**options, _SPLIT[0]: _SPLIT[1]}.items()))
    if STANDING in draft.options and draft.name != "sweatshirt":
        return replace(draft, options=tuple({**options, MANDARIN[0]: MANDARIN[1]}.items()))
    return draft
