"""Named drafts of wrapped dresses and skirts that are to be close: cut closer later, their fronts part."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

from swifttailor.describing.claims import Claim
from swifttailor.pattern.drafts.draft_names import NamedDraft

_SLANTS: Mapping[str, str] = {"wrap-dress": "skirt_flare", "wrap-skirt": "flare"}
"""Option of how far their side seams slant."""
_CLOSE = frozenset({Claim("fit", "close"), Claim("hips", "close")})
_STRAIGHT = frozenset([Claim("skirt", value) for value in ("straight", "pencil", "narrowing")])
_ROOM_CM, _SLANT = 4.0, 2.0
"""Room at the hips of what is close there, cm, and slant of the sides of what falls straight, degrees."""


def wrapped_close_as_asked(draft: NamedDraft, claims: Sequence[Claim]) -> NamedDraft:
    """A wrapped draft with as little room and slant as is asked for; others as they are.

    Args:
        draft: As a table names it.
        claims: What is asked for, all of it.
    """
    slant = _SLANTS.get(draft.name)
    options = dict(draft.options)
    if slant is None:
        return draft
    if not _CLOSE.isdisjoint(claims):
        options["hip_ease"] = min(float(options.get("hip_ease", _ROOM_CM)), _ROOM_CM)
    if not _STRAIGHT.isdisjoint(claims) and "fraction" not in options:
        options[slant] = min(float(options.get(slant, _SLANT)), _SLANT)
    return replace(draft, options=tuple(options.items()))
