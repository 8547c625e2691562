"""What can be seen of a garment from where."""

from __future__ import annotations

from typing import Literal

from swifttailor.data.pictures.scenes import View
from swifttailor.describing.claims import Claim

ShownFrom = View | Literal["both"]
"""Where a camera stands; ``both``: two pictures of one garment, front and back."""
_HIDDEN: dict[str, frozenset[str]] = {
    "front": frozenset({"back_neckline", "back_depth", "back_depth_cm"}),
    "back": frozenset({"neckline", "left_neckline", "right_neckline", "neck_depth", "neck_depth_cm"}),
}


def can_be_seen(claim: Claim, view: ShownFrom) -> bool:
    """Whether a view shows what a claim is about; from the side everything may be seen."""
    return claim.name not in _HIDDEN.get(view, ())
