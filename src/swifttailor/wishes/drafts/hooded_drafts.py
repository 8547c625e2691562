"""Drafts on whose necks a hood is sewn, where a text asks for one."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from swifttailor.describing.claims import Claim
from swifttailor.pattern.drafts.draft_names import HOODED, NamedDraft

_HOOD = Claim("hood", "hood")
_MAY_HAVE = ("fitted-dress", "swing-dress", "drop-waist-dress", "jumpsuit", "shirt-dress")
_OF_SKATERS = ("skirt_length", "skirt_fraction", "waist_ease", "sleeve_length", "sleeve_end", "sleeve_shape")
"""Options of skater dresses that shirt dresses have as well."""


def hooded_as_asked(draft: NamedDraft, claims: Sequence[Claim]) -> NamedDraft:
    """Dresses, jumpsuits and ponchos with a hood drafted for their neckline.

    One that is sewn to the wide neckline of a dress falls over the face.

    Args:
        draft: As a table names it.
        claims: What is asked for, all of it.
    """
    options = dict(draft.options)
    if _HOOD not in claims or "collar" in options:
        return draft
    if draft.name == "poncho":
        return replace(draft, options=(*draft.options, ("hood", True)))
    if draft.name == "skater-dress":
        sleeves = any(c.name == "sleeves" and c.value != "none" for c in claims)
        kept = {name: options[name] for name in _OF_SKATERS if name in options}
        return NamedDraft("shirt-dress", (*kept.items(), HOODED, ("cuffs", False), ("sleeves", sleeves)))
    return replace(draft, options=(*draft.options, HOODED)) if draft.name in _MAY_HAVE else draft
