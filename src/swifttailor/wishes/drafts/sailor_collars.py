"""Named drafts with a sailor collar, where a word about the collar asks for one."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace

from swifttailor.pattern.drafts.draft_names import NamedDraft
from swifttailor.wording.lexicon import Entry

_SAILOR = ("collar", "sailor")
_V = {"shirt": {"hem_opening": 0.0}, "polo-shirt": {}}
"""Drafts whose neckline is a V wherever it has this collar, and what goes with it: shirts are pulled on."""
_OTHERS = ("shirt-dress", "fitted-dress", "shift-dress", "swing-dress", "drop-waist-dress", "jumpsuit")
_DEPTH_CM = 16.0


def asks_for_sailor_collar(entries: Iterable[Entry]) -> bool:
    """Whether one of the words of a text, by their entries of the lexicon, is such a collar."""
    details = [entry for entry in entries if entry.category == "styles"]
    return any(_SAILOR in draft.options for entry in details for draft in entry.drafts)


def with_sailor_collar(draft: NamedDraft) -> NamedDraft:
    """A draft with this collar in place of what the garment's name has; as it is where it can have none."""
    if draft.name not in (*_V, *_OTHERS):
        return draft
    more = {**_V.get(draft.name, {}), "neck_depth": _DEPTH_CM, _SAILOR[0]: _SAILOR[1]}
    return replace(draft, options=tuple({**dict(draft.options), **more}.items()))
