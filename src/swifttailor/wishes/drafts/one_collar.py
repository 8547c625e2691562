"""Shirts, dresses and cardigans with the collar that another draft of the same text has."""

from __future__ import annotations

from dataclasses import replace

from swifttailor.pattern.drafts.draft_names import NamedDraft

_SHAWL = ("lapels", "shawl")
_SHAWL_CARDIGAN = NamedDraft(
    "blazer", (_SHAWL, ("chest_ease", 13.0), ("waist_shaping", 0.5), ("neck_depth", 28.0))
)
"""A cardigan with a shawl collar is cut as a jacket of that collar is."""
_MAY_BE_COLLARED = (
    *("drop-waist-dress", "jumpsuit", "shift-dress", "swing-dress", "fitted-dress"),
    *("shirt", "polo-shirt", "shirt-dress"),
)


def with_one_collar(named: list[NamedDraft]) -> list[NamedDraft]:
    """Shirts and dresses with the collar that another draft of the text has: a Peter Pan collar."""
    if any(draft.name == "cardigan" for draft in named) and any(_SHAWL in draft.options for draft in named):
        named = [_SHAWL_CARDIGAN if draft.name == "cardigan" else draft for draft in named]
    collars = [option for draft in named for option in draft.options if option[0] == "collar"]
    return [
        replace(draft, options=(*draft.options, collars[0]))
        if collars and draft.name in _MAY_BE_COLLARED and not any(n == "collar" for n, _ in draft.options)
        else draft
        for draft in named
    ]
