"""Coats that are to have a flared skirt below a waist: they are cut like princess coats."""

from __future__ import annotations

from collections.abc import Sequence

from swifttailor.describing.claims import Claim
from swifttailor.pattern.drafts.draft_names import NamedDraft

_COAT, _FLARED = "coat", Claim("skirt", "flared")
_PRINCESS = NamedDraft.parse(
    "shirt-dress(collar=revers;neck_depth=18;sleeve_length=60;sleeve_end=28;cuffs=false;skirt_fraction=0.5;"
    "skirt_length=66;bust_ease=9;waist_ease=7)"
)


def skirted_as_asked(draft: NamedDraft, claims: Sequence[Claim]) -> NamedDraft:
    """A princess coat of the length of a coat that is to flare; others as they are.

    Args:
        draft: As a table names it.
        claims: What is asked for, all of it.
    """
    if draft.name != _COAT or _FLARED not in claims:
        return draft
    options = dict(_PRINCESS.options)
    length = dict(draft.options).get("length")
    return NamedDraft(
        _PRINCESS.name, tuple({**options, **({} if length is None else {"skirt_length": length})}.items())
    )
