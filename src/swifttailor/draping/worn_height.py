"""Between which heights the top of a garment must hang to be where it is worn."""

from __future__ import annotations

from typing import NamedTuple

from swifttailor.body import BodyMeasurements
from swifttailor.pattern import Pattern
from swifttailor.pattern.check import hangs_from_shoulders

_BELOW_ARMPITS_CM = 10.0
_BELOW_PLACED_CM = 5.0
_ABOVE_CROWN_CM = 20.0
_ABOVE_ARMPITS_CM = 10.0


class WornHeight(NamedTuple):
    """Heights above the floor, cm."""

    lowest: float
    """The top of the garment must reach it."""
    highest: float
    """The top of the garment must stay below it."""
    kind: str
    """What is worn so, in words."""


def worn_height(pattern: Pattern, measurements: BodyMeasurements) -> WornHeight:
    """Where the top of a garment belongs.

    What hangs from the shoulders or is strapless reaches a hand below the armpits, or a little below where
    its panels are placed if they are placed that low, but never below the waist; hoods may stand up. Skirts
    and trousers reach the hips, and not the chest.
    """
    if hangs_from_shoulders(pattern):
        placed = max(float(p.to_world(p.outline(1.0))[:, 1].max()) for p in pattern.panels)
        lowest = min(measurements.armpit_level - _BELOW_ARMPITS_CM, placed - _BELOW_PLACED_CM)
        lowest = max(lowest, measurements.waist_level)
        return WornHeight(lowest, measurements.height + _ABOVE_CROWN_CM, "a garment with a bodice")
    highest = measurements.armpit_level + _ABOVE_ARMPITS_CM
    return WornHeight(measurements.hips_level, highest, "a skirt or trousers")
