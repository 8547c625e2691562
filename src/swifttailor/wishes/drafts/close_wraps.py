"""Named drafts of wrapped garments that are to be close, or not: cut otherwise later, their fronts part."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

from swifttailor.describing.claims import Claim
from swifttailor.pattern.drafts.draft_names import NamedDraft

_SLANTS: Mapping[str, str] = {"wrap-dress": "skirt_flare", "wrap-skirt": "flare"}
"""Option of how far their side seams slant."""
_CLOSE = frozenset({Claim("fit", "close"), Claim("hips", "close")})
_STRAIGHT = frozenset([Claim("skirt", value) for value in ("straight", "pencil", "narrowing")])
_WITH_ROOM = frozenset({"easy", "loose", "oversized"})
_ROOM_CM, _SLANT = 4.0, 2.0
"""Room at the hips of what is close there, cm, and slant of the sides of what falls straight, degrees."""


_WRAP_TOP = "wrap-top"
_ROOMY: Mapping[str, float] = {"chest_ease": 10.0, "waist_shaping": 0.0}
"""Options of wrap tops that are not to be close, cm."""


def roomy_wrap_as_asked(draft: NamedDraft, claims: Sequence[Claim], never: Sequence[Claim]) -> NamedDraft:
    """A wrap top with room where that is asked for, or where a close one is refused; others as they are.

    Args:
        draft: As a table names it.
        claims: What is asked for, all of it.
        never: What the text refuses.
    """
    roomy = any(c.name == "fit" and c.value in _WITH_ROOM for c in claims) or Claim("fit", "close") in never
    if draft.name != _WRAP_TOP or not roomy:
        return draft
    return replace(draft, options=tuple({**dict(draft.options), **_ROOMY}.items()))


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
