"""Dresses of ribs, which lie on the body where nothing tells how wide they are."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from swifttailor.describing.claims import Claim
from swifttailor.describing.differences import Gain

if TYPE_CHECKING:
    from swifttailor.wishes.heard import Heard

_RIBBED, _LOOSE, _CORDUROY = "rib", Gain(Claim("fit", "loose")), "twill"
"""How such words begin; what the names of many knitted dresses mean; and what corduroy, which has ribs and
does not stretch, is made as."""


def is_ribbed_dress(heard: Heard, said: Sequence[Claim]) -> bool:
    """Whether it is a dress that is called ribbed, and nothing tells how wide it is.

    Args:
        heard: What the text asks for.
        said: What words about details say.
    """
    told = any(claim.name in ("fit", "hips", "skirt") for claim in said)
    told = told or any(wish.change == _LOOSE for wish in (*heard.sure, *heard.likely))
    marks = () if heard.words is None else heard.words.marks
    ribbed = any(mark.word.lower().startswith(_RIBBED) for mark in marks if not mark.denied)
    return heard.kind == "dress" and ribbed and heard.cloth != _CORDUROY and not told
