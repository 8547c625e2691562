"""Named wrap skirts that are cut from a part of a circle, where a text asks for so wide a one."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from swifttailor.describing.claims import Claim
from swifttailor.pattern.drafts.draft_names import NamedDraft
from swifttailor.wishes.drafts.held_drafts import CIRCLES

_WOUND, _FRACTION, _WIDEST = "wrap-skirt", "fraction", 0.75
_DARTED = "a-line"
"""A wrap skirt that is no wider is shaped by its side seams and darts."""


def wound_as_asked(drafts: Sequence[NamedDraft], claims: Sequence[Claim]) -> list[NamedDraft]:
    """Wrap skirts as wide as is asked for; others as they are.

    Args:
        drafts: As they go with all else that is asked for.
        claims: What is told.
    """
    asked = [CIRCLES[str(c.value)] for c in claims if c.name == "skirt" and c.value in CIRCLES]
    told = [c.value for c in claims if c.name == "skirt"]
    if not asked or _DARTED in told:
        return list(drafts)
    wide = (_FRACTION, min(max(asked), _WIDEST))
    return [
        replace(d, options=tuple({**dict(d.options), wide[0]: wide[1]}.items())) if d.name == _WOUND else d
        for d in drafts
    ]
