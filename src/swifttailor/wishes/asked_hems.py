"""Named drafts with the hem that a text asks for: curved like a shirt's, or straight."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import replace

from swifttailor.describing.claims import Claim
from swifttailor.pattern.drafts.draft_names import CURVED_HEM, HEM_RISE, NamedDraft

RISE_CM = 6.0
"""How much higher a curved hem is at the side seams than in the middle."""
_MAY_CURVE = ("shirt", "t-shirt", "tank-top", "shift-dress")
_LEVEL = Claim("hem_shape", "level")
_WAISTED = frozenset({"waist_seam", "skirt", "bodice"})
_SHIRT_DRESS = "shirt-dress"
_STRAIGHT_DRESS = {
    "chest_ease": 14.0,
    "flare": 0.0,
    "length": 52.0,
    "sleeves": True,
    "sleeve_length": 60.0,
    "sleeve_end": 27.0,
    "collar": "shirt",
}
"""A shirt dress whose hem is curved is a long shirt: it has no waist, unless that is asked for."""


def hem_as_asked(
    draft: NamedDraft, claims: Collection[Claim], lacks: Collection[str], denied: Collection[str]
) -> NamedDraft:
    """A named draft with a curved hem where one is asked for, and with a straight one where that is.

    Args:
        draft: As a table names it.
        claims: What is asked for, all of it.
        lacks: Keys of ``cannot.txt`` that the text asks for.
        denied: Keys of ``cannot.txt`` that it refuses.
    """
    options = dict(draft.options)
    if CURVED_HEM in lacks:
        if draft.name == _SHIRT_DRESS and not any(claim.name in _WAISTED for claim in claims):
            own = {name: options[name] for name in ("collar", "collar_height") if name in options}
            bare = Claim("sleeves", "none") in claims
            draft = NamedDraft("shift-dress")
            options = {**_STRAIGHT_DRESS, **own, **({"sleeves": False} if bare else {})}
        return _with(draft, options, RISE_CM) if draft.name in _MAY_CURVE else draft
    if HEM_RISE in options and (_LEVEL in claims or CURVED_HEM in denied):
        return _with(draft, options, 0.0)
    return draft


def _with(draft: NamedDraft, options: dict[str, float | bool | str], rise: float) -> NamedDraft:
    return replace(draft, options=tuple({**options, HEM_RISE: rise}.items()))
