"""The fitted bodice without shoulders: darts as in the fitted block, its upper edge straight or a heart."""

from __future__ import annotations

from dataclasses import dataclass

from swifttailor.pattern.drafts.bodice import BACK_Z, FRONT_Z
from swifttailor.pattern.drafts.cutting_table import CuttingTable
from swifttailor.pattern.drafts.darted_block import DartedBlock
from swifttailor.pattern.drafts.figure import Figure, Halves

OVER_BUST = 8.0
"""Height of the front's upper edge over the fullest part of the bust, cm."""
_DROP_CM = 3.0
"""So far below the armpit its upper edge is at the sides, cm: higher, it stands off in points at the arms."""
TAKEN_IN, TAKEN_IN_BEHIND = 1.5, 1.0
"""So far the middle of the upper edge is taken in, on either side, cm: the body is narrower over the bust."""


@dataclass(frozen=True)
class StraplessBodice:
    """How the bodice is cut."""

    bust_ease: float
    """On top of the bust girth, cm around."""
    waist_ease: float
    """On top of the waist girth, cm around: what keeps it from sliding down."""
    dip: float
    """How far the heart of the upper edge falls in the middle, cm; 0 for a straight one."""


def lay_strapless_bodice(table: CuttingTable, figure: Figure, shape: StraplessBodice) -> Halves:
    """Lays and sews both halves of the left side, down to the waist.

    Edges of ``left_ftorso`` and ``left_btorso``: waist, side, top, centre, dart.

    Returns:
        The sewn half widths at the waist, cm.
    """
    block = DartedBlock.of(figure, bust_ease=shape.bust_ease, waist_ease=shape.waist_ease, drop=_DROP_CM)
    for side in "fb":
        front = side == "f"
        outline = block.begin_half(front=front)
        if front:
            x, y = outline.sides[-1].end
            peak = (min(figure.bust_x, 0.6 * x), max(figure.bust_y + OVER_BUST, y + 1.0))
            middle = max(peak[1] - shape.dip, figure.waist_y + 6.0)
            outline.cubic("top", (x - 0.3 * (x - peak[0]), y), (peak[0] + 4.0, peak[1]), peak)
            outline.cubic(
                "top",
                (0.6 * peak[0], peak[1]),
                (0.25 * peak[0], middle + 0.25 * shape.dip),
                (TAKEN_IN, middle),
            )
            if middle > figure.bust_y + 1.0:
                outline.line("centre", 0.0, figure.bust_y)
        else:
            y = block.under_y - 0.5
            outline.quadratic("top", (0.5 * block.chest.back, y), (TAKEN_IN_BEHIND, y))
        outline.line("centre", 0.0, figure.waist_y).closed()
        z = FRONT_Z if front else BACK_Z
        table.lay(f"left_{side}torso", outline, label="body", at=(0.0, 0.0, z), back=not front)
        table.label(f"left_{side}torso.top", "strapless_top")
    table.seam("left_ftorso.side", "left_btorso.side")
    return block.waist
