"""Backs that no picture shows: as people wear them, not as GarmentCode's sampler draws them."""

from __future__ import annotations

from swifttailor.describing.differences import Gain
from swifttailor.parameter_reader.agreement import Design
from swifttailor.tailor.reading import Wanted

BACK_DEPTHS = ("collar.bc_depth", "left.collar.bc_depth")
WORN = 0.15
"""Fall of a back neckline, in the units of the design, where nothing is known of it. GarmentCode draws it
evenly up to a bare back."""
_OF_BACKS = ("back_depth", "back_neckline")


def with_hidden_back(design: Design, wanted: Wanted) -> Design:
    """The design with a back neckline as it is worn, where people are shown and no picture shows a back.

    Args:
        design: Of design parameters that were read.
        wanted: What is wanted; of plain pictures, which may be GarmentCode's own, nothing is changed, and
            where words speak of the back neither.
    """
    if not wanted.pictures or any(
        one.reading.is_plain or one.reading.face == "back" for one in wanted.pictures
    ):
        return design
    told = [w.change for w in wanted.said]
    if any(isinstance(change, Gain) and change.claim.name in _OF_BACKS for change in told):
        return design
    deep = [name for name in BACK_DEPTHS if float(design.get(name, 0.0)) > WORN]
    return {**design, **dict.fromkeys(deep, WORN)} if deep else design
