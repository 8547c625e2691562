"""What can be seen of a garment from where."""

from __future__ import annotations

from typing import Literal

from swifttailor.data.pictures.scenes import View
from swifttailor.describing.claims import Claim
from swifttailor.picture_reader.close_ups import HIDDEN

PICTURE_SIZE = 800
"""Pixels along each side of the pictures that are shown: as many as GarmentCodeData's renders have."""
ShownFrom = View | Literal["both"]
"""Where a camera stands; ``both``: two pictures of one garment, front and back."""


def can_be_seen(claim: Claim, view: ShownFrom) -> bool:
    """Whether a view shows what a claim is about; from the side everything may be seen."""
    return view not in HIDDEN or claim.name not in HIDDEN[view].claims
