"""Seams that princess seams take the place of, which are not drawn beside these."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from swifttailor.pattern.pattern import Pattern

_PRINCESS, _FRONT = "princess seams", "ftorso"


def darts_in_princess_seams(pattern: Pattern) -> frozenset[int]:
    """Indices of the stitches that close darts in front, where princess seams take in what they do."""
    if _PRINCESS not in pattern.trims:
        return frozenset()
    return frozenset(
        k
        for k, stitch in enumerate(pattern.stitches)
        if len({side.panel for side in stitch.sides}) == 1 and _FRONT in stitch.sides[0].panel
    )
