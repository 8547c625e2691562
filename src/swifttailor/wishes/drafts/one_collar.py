"""Drafts with the collar that another draft of the same text has: a Peter Pan collar, a loose polo neck."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from swifttailor.pattern.drafts.draft_names import LOOSE, NamedDraft

_SHAWL = ("lapels", "shawl")
_SHAWL_CARDIGAN = NamedDraft(
    "blazer", (_SHAWL, ("chest_ease", 13.0), ("waist_shaping", 0.5), ("neck_depth", 28.0))
)
"""A cardigan with a shawl collar is cut as a jacket of that collar is."""
_MAY_BE_COLLARED = (
    *("drop-waist-dress", "jumpsuit", "shift-dress", "swing-dress", "fitted-dress"),
    *("shirt", "polo-shirt", "shirt-dress"),
)
_KNITTED, _OF_LOOSE = "sweatshirt", ("collar", "collar_height")


def with_one_collar(named: Sequence[NamedDraft]) -> list[NamedDraft]:
    """Shirts, dresses and jumpers with the collar of another draft of the text; others as they are."""
    named = _with_loose_collars(named)
    if any(draft.name == "cardigan" for draft in named) and any(_SHAWL in draft.options for draft in named):
        named = [_SHAWL_CARDIGAN if draft.name == "cardigan" else draft for draft in named]
    collars = [option for draft in named for option in draft.options if option[0] == "collar"]
    return [
        replace(draft, options=(*draft.options, collars[0]))
        if collars and draft.name in _MAY_BE_COLLARED and not any(n == "collar" for n, _ in draft.options)
        else draft
        for draft in named
    ]


def _with_loose_collars(named: Sequence[NamedDraft]) -> list[NamedDraft]:
    loose = [dict(draft.options) for draft in named if draft.name == _KNITTED and LOOSE in draft.options]
    collar = {name: loose[0][name] for name in _OF_LOOSE if name in loose[0]} if loose else {}
    return [
        replace(draft, options=tuple({**dict(draft.options), **collar}.items()))
        if collar and draft.name == _KNITTED
        else draft
        for draft in named
    ]
