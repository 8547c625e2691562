"""Drafts of what is worn over other clothes, where a word about a detail names a draft as well."""

from __future__ import annotations

from collections.abc import Sequence

from swifttailor.pattern.drafts.draft_names import NamedDraft
from swifttailor.wishes.drafts.jacket_collars import collar_told, with_told_collar
from swifttailor.wording.lexicon import Entry

_COATS, _JACKETS = ("coat", "hooded-coat", "cape"), ("blazer", "turtleneck")
"""Drafts of what is worn over other clothes and open in front, long and short."""
_PULLED_ON = "t-shirt"
_OPEN_JACKET = NamedDraft.parse("cardigan(length=22;chest_ease=14;neck_depth=16;opening=0;closed_to=8)")
"""Of a jacket whose sleeves are raglan or cut in one, which those of blazers are not."""


def coats_as_named(named: list[NamedDraft], entries: Sequence[Entry]) -> list[NamedDraft]:
    """Of drafts that a text names, those that are coats where it names one: its collar is no dress's."""
    garments = {draft.name for e in entries if e.category == "garments" for draft in e.drafts}
    told = [e for e in entries if e.category != "garments"]
    details = {draft.name for e in told for draft in e.drafts}
    collar = collar_told(told) if garments == {_JACKETS[0]} else None
    if collar is not None:
        return with_told_collar(named, collar)
    if garments and garments <= {*_COATS}:
        return [draft for draft in named if draft.name in _COATS]
    if garments == {_JACKETS[0]} and _PULLED_ON in details:
        return [_OPEN_JACKET]
    if garments == {_JACKETS[0]} and _JACKETS[0] in details:
        return [draft for draft in named if draft.name in _JACKETS]
    return named
