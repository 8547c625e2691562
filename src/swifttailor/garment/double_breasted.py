"""The middle of a double-breasted front, which is no edge: the other front lies over it."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from swifttailor.pattern.pattern import Pattern

_TRIM = "double-breasted buttons"
_FRONTS = frozenset({"left_ftorso", "right_ftorso"})


def seams_under_a_front(pattern: Pattern) -> frozenset[int]:
    """Indices of the stitches that a front lies over; none where it is not double-breasted.

    Args:
        pattern: Any pattern; the edge of the front that lies above is among its trims.
    """
    if _TRIM not in pattern.trims:
        return frozenset()
    return frozenset(
        k for k, stitch in enumerate(pattern.stitches) if {side.panel for side in stitch.sides} == _FRONTS
    )
