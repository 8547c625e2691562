"""Seams that princess seams take the place of, which are not drawn beside these."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from swifttailor.pattern.pattern import Pattern

_PRINCESS, _PANELS, _FRONT = "princess seams", "princess panels", "ftorso"


def seams_in_princess_seams(pattern: Pattern) -> frozenset[int]:
    """Indices of the stitches that close darts in front, where princess seams take in what they do.

    Of panels that go on from the shoulder to the hem those of all darts, and the seam around the waist.
    """
    through = _PANELS in pattern.trims
    if not through and _PRINCESS not in pattern.trims:
        return frozenset()
    found = set()
    for k, stitch in enumerate(pattern.stitches):
        panels = {side.panel for side in stitch.sides}
        dart = len(panels) == 1 and (through or _FRONT in stitch.sides[0].panel)
        waist = through and {_part(panel) for panel in panels} == {"torso", "skirt"}
        found |= {k} if dart or waist else set()
    return frozenset(found)


def _part(panel: str) -> str:
    return "torso" if "torso" in panel else "skirt" if panel.startswith("skirt") else ""
