"""Jackets with the collar that a word about collars names: a jacket with a Peter Pan collar is no shirt."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from swifttailor.pattern.drafts.draft_names import NamedDraft
from swifttailor.wording.lexicon import Entry

_JACKET, _SHIRT, _COLLAR = "blazer", "shirt", "collar"
_LIES = frozenset({"flat_collar", "shirt_collar"})
"""Keys of what words about collars that are turned down say cannot be made of panels."""
_SEWN = ("shirt", "folded", "flat", "standing", "mandarin")
"""Collars that the draft of jackets can have instead of lapels."""
_OF_COLLARS = ("collar_width", "collar_height")
_OF_LAPELS = ("lapels", "lapel_width", "neck_depth", *_OF_COLLARS)


def collar_told(details: Sequence[Entry]) -> NamedDraft | None:
    """The shirt that shows the collar of a text best; None where no word is about such a collar.

    Args:
        details: Entries of the lexicon that name no garment.
    """
    for entry in details:
        if any(draft.name == _JACKET for draft in entry.drafts):  # lapels of some width
            continue
        for draft in entry.drafts:
            told = _COLLAR in dict(draft.options) or not _LIES.isdisjoint(entry.cannot)
            if draft.name == _SHIRT and told and dict(draft.options).get(_COLLAR, _SHIRT) in _SEWN:
                return draft
    return None


def with_told_collar(named: Sequence[NamedDraft], shirt: NamedDraft) -> list[NamedDraft]:
    """The jackets among drafts, with the collar of a shirt.

    Args:
        named: Drafts that a text names.
        shirt: Of `collar_told`.
    """
    own = dict(shirt.options)
    collar = {_COLLAR: own.get(_COLLAR, _SHIRT), **{n: own[n] for n in _OF_COLLARS if n in own}}
    return [
        replace(draft, options=(*[o for o in draft.options if o[0] not in _OF_LAPELS], *collar.items()))
        for draft in named
        if draft.name == _JACKET
    ]
