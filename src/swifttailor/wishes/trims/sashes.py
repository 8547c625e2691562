"""What comes first on some garments: a sash that is tied behind, pockets of skirts that are seen."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from swifttailor.wording.lexicon import Lack

WOUND = frozenset({"wrap-skirt", "sarong"})
"""Drafts of skirts that are wound around the waist and tied there."""
BIBBED = frozenset({"dungarees", "pinafore"})
"""Drafts whose straps have buckles."""
_SASH = re.compile(r"\b(?:ribbon |satin |wide |contrast |contrasting )?sash\b(?! belt)", re.IGNORECASE)
_OPEN = frozenset(
    {
        "robe",
        "coat",
        "hooded-coat",
        "wrap-dress",
        "wrap-jumpsuit",
        "kaftan",
        "shift-dress",
        "cardigan",
        "blazer",
    }
)
"""Drafts that a sash holds together in front, or whose waist it makes."""


def first_of_kind(lack: Lack, kind: str, draft: str, text: str) -> tuple[str, ...]:
    """The trims that stand for what cannot be made before those that usually do; none where these do.

    Args:
        lack: What a garment is to have.
        kind: Of the garment.
        draft: That it is cut from.
        text: As it is read.
    """
    if lack.what == "belt_accessory" and kind == "dress" and draft not in _OPEN and _SASH.search(text):
        return ("sash",)
    # Openings in the seams of a dark skirt are seen by nobody.
    return ("patch pockets",) if lack.what == "pockets" and lack.said and kind == "skirt" else ()
