"""The fitted bodice on thin straps: darts as in the fitted block, straight across at the bust."""

from __future__ import annotations

from dataclasses import dataclass

from swifttailor.pattern.drafts.bodice import BACK_Z, FRONT_Z
from swifttailor.pattern.drafts.crossed_straps import (
    draw_top_below_strap,
    lay_crossed_strap,
    sew_torso_on_straps,
)
from swifttailor.pattern.drafts.cutting_table import CuttingTable
from swifttailor.pattern.drafts.darted_block import DartedBlock
from swifttailor.pattern.drafts.figure import Figure, Halves
from swifttailor.pattern.drafts.strap_bodice import OVER_BUST, OVER_UNDERARM, STRAP_LIFT, draw_top_on_strap

LOWEST = 6.0
"""Height of the front's middle over the waist at least, cm."""


@dataclass(frozen=True)
class FittedStrapBodice:
    """How the bodice is cut."""

    strap: float
    """Width of the straps, cm."""
    bust_ease: float
    """On top of the bust girth, cm around."""
    waist_ease: float
    """On top of the waist girth, cm around."""
    dip: float
    """How far the front falls between the straps, cm."""
    crossed: bool = False
    """Whether the straps cross behind."""
    knit: bool = False
    """Whether it is of cloth that stretches, and has no darts."""


def lay_fitted_strap_bodice(table: CuttingTable, figure: Figure, shape: FittedStrapBodice) -> Halves:
    """Lays and sews both halves of the left side, down to the waist.

    Edges of ``left_ftorso`` and ``left_btorso``: waist, side, armhole, shoulder, neck, centre, dart.

    Returns:
        The sewn half widths at the waist, cm.
    """
    begin = DartedBlock.of_knit if shape.knit else DartedBlock.of
    block = begin(figure, bust_ease=shape.bust_ease, waist_ease=shape.waist_ease, drop=1.5)
    for side in "fb":
        front = side == "f"
        outline = block.begin_half(front=front, darted=not shape.knit)
        y = outline.sides[-1].end[1]
        base_y = max(figure.bust_y + OVER_BUST if front else block.under_y + OVER_UNDERARM, y + 0.5)
        low = max(base_y - (shape.dip if front else 0.0), figure.waist_y + LOWEST)
        lift = STRAP_LIFT * figure.front_fullness if front else 0.0
        if shape.crossed and not front:
            draw_top_below_strap(outline, figure, shape.strap, base_y)
            lay_crossed_strap(table, figure, shape.strap, base_y)
        else:
            draw_top_on_strap(outline, figure, shape.strap, base_y=base_y, low=low, lift=lift)
        if front and low > figure.bust_y + 1.0:
            outline.line("centre", 0.0, figure.bust_y)
        outline.line("centre", 0.0, figure.waist_y).closed()
        z = FRONT_Z if front else BACK_Z
        table.lay(f"left_{side}torso", outline, label="body", at=(0.0, 0.0, z), back=not front)
    sew_torso_on_straps(table, crossed=shape.crossed)
    return block.waist
