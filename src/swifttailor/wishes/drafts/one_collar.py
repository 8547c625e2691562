"""Drafts with the collar that another draft of the same text has: a Peter Pan collar, a loose polo neck."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from swifttailor.pattern.drafts.draft_names import LOOSE, ROLLED, NamedDraft

_SHAWL = ("lapels", "shawl")
_SHAWL_CARDIGAN = NamedDraft.parse(
    "blazer(lapels=shawl;chest_ease=12;waist_shaping=0;neck_depth=30;collar_width=6;lapel_width=7;"
    "arm_ease=9;sleeve_end=26;length=24)"
)
"""A cardigan with a shawl collar is cut as a jacket of that collar is."""
_LONG_SHAWL_CARDIGAN, _LONGEST_BLAZER_CM = "coat", 50.0
_OF_CARDIGANS = ("length", "opening", "closed_to", "sleeve_length", "sleeve_shape", "shoulder_extension")
"""What it keeps of the cardigan that is named: one that is worn open stays so."""
_MAY_BE_COLLARED = (
    *("drop-waist-dress", "jumpsuit", "shift-dress", "swing-dress", "fitted-dress"),
    *("shirt", "polo-shirt", "shirt-dress"),
)
_KNITTED, _OF_LOOSE = "sweatshirt", ("collar", "collar_height")


def with_one_collar(named: Sequence[NamedDraft]) -> list[NamedDraft]:
    """Shirts, dresses and jumpers with the collar of another draft of the text; others as they are."""
    named = _with_loose_collars(named)
    if any(draft.name == "cardigan" for draft in named) and any(_SHAWL in draft.options for draft in named):
        named = [_with_shawl_collar(draft) if draft.name == "cardigan" else draft for draft in named]
    collars = [_collar(draft) for draft in named if _collar(draft)]
    return [
        replace(draft, options=(*draft.options, *collars[0]))
        if collars and draft.name in _MAY_BE_COLLARED and not any(n == "collar" for n, _ in draft.options)
        else draft
        for draft in named
    ]


def _collar(draft: NamedDraft) -> tuple[tuple[str, float | bool | str], ...]:
    """Which collar a draft is told to have, and how high one that is turned over itself is: or it is low."""
    rolled = ROLLED in draft.options
    names = _OF_LOOSE if rolled else _OF_LOOSE[:1]
    found = tuple([option for option in draft.options if option[0] in names])
    return found if any(name == "collar" for name, _ in found) else ()


def _with_shawl_collar(cardigan: NamedDraft) -> NamedDraft:
    own = dict(cardigan.options)
    kept = {name: own[name] for name in _OF_CARDIGANS if name in own}
    if not kept.get("opening", 1.0):  # closed by buttons to a ribbed hem
        kept |= {"opening": 0.5, "closed_to": float(kept.get("length", 24.0)) - 3.0}
    longer = float(kept.get("length", 0.0)) > _LONGEST_BLAZER_CM
    options = {**dict(_SHAWL_CARDIGAN.options), **kept}
    name = _LONG_SHAWL_CARDIGAN if longer else _SHAWL_CARDIGAN.name
    return NamedDraft(name, tuple({**options, **({"flare": 0.0} if longer else {})}.items()))


def _with_loose_collars(named: Sequence[NamedDraft]) -> list[NamedDraft]:
    loose = [dict(draft.options) for draft in named if draft.name == _KNITTED and LOOSE in draft.options]
    collar = {name: loose[0][name] for name in _OF_LOOSE if name in loose[0]} if loose else {}
    return [
        replace(draft, options=tuple({**dict(draft.options), **collar}.items()))
        if collar and draft.name == _KNITTED
        else draft
        for draft in named
    ]
