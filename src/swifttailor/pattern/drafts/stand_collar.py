"""A collar that stands around the neck: a strip in four, as long as the neckline below."""

from __future__ import annotations

import math

from swifttailor.pattern.drafts.cutting_table import CuttingTable
from swifttailor.pattern.drafts.figure import Figure
from swifttailor.pattern.drafts.outline import Outline

_LEAN, _NARROWEST = 0.35, 0.12
"""So much shorter is the upper edge of each quarter than the lower one, over the height and at most over the
length of the lower one: necks narrow so, and a collar that does not lean to them stands off."""
_TO_THE_CHIN, _AWAY = 10.0, 0.45
"""Taller collars would cover the mouth: they stand away from the neck, and the upper edge of each quarter is
longer than the lower one by so much of the height, cm."""
CLOSE_FRONT_Z, CLOSE_BACK_Z = 18.0, -17.0
"""Where its halves stand before draping, cm."""
_CORNER, _GAP_CM = 0.45, 0.8
"""Rounding of its corners in front where it is open there, as a part of its height, and how far each half
ends beside the middle, cm."""
ABOVE_NECK = 2.0
"""How far above the neck it begins before draping, cm."""


def lean(height: float, long: float) -> float:
    """How much shorter the upper edge of a quarter of a stand is than its lower one, cm.

    Args:
        height: Of the stand, cm.
        long: Length of the shortest quarter of its lower edge, cm.
    """
    return min(_LEAN * height, _NARROWEST * long)


def lay_stand_collar(
    table: CuttingTable, figure: Figure, height: float, *, split: bool = False, away: bool = False
) -> None:
    """Lays ``left_collar_front`` and ``left_collar_back`` and sews them to the left neckline.

    Args:
        table: Where the left half of a torso lies; `sew_collar` joins the halves after its `mirror`.
        figure: The body.
        height: cm.
        split: Whether it is open in the middle of the front, with rounded corners.
        away: Whether what would cover the chin stands away from the neck.
    """
    quarters = [table.length(f"{torso}.neck") for torso in ("left_ftorso", "left_btorso")]
    tall = away and height > _TO_THE_CHIN
    closer = -_AWAY * height if tall else lean(height, min(quarters))
    upright = math.sqrt(height**2 - closer**2)  # the slanting ends are as long as it is high
    for face, torso, long in zip(("front", "back"), ("left_ftorso", "left_btorso"), quarters, strict=True):
        outline = Outline(0.0, 0.0).line("neck", long, 0.0)
        outline.line("end", long - closer, upright)
        if split and face == "front":
            corner, gap = min(_CORNER * upright, 0.3 * long), min(_GAP_CM, 0.1 * long)
            outline.line("top", gap + corner, upright)
            outline.quadratic("top", (gap, upright), (0.6 * gap, upright - corner))
        else:
            outline.line("top", 0.0, upright)
        outline.line("centre", 0.0, 0.0)
        table.lay(
            f"left_collar_{face}",
            outline.closed(),
            label="body",
            at=(0.0, figure.neck_y + ABOVE_NECK, CLOSE_FRONT_Z if face == "front" else CLOSE_BACK_Z),
            back=face == "back",
        )
        table.seam(f"{torso}.neck", f"left_collar_{face}.neck")
    table.seam("left_collar_front.end", "left_collar_back.end")


def sew_collar(table: CuttingTable, *, split: bool = False) -> None:
    """Sews the halves together in the middle of the back and, where it is not `split`, of the front."""
    if not split:
        table.seam("right_collar_front.centre", "left_collar_front.centre")
    table.seam("left_collar_back.centre", "right_collar_back.centre")
