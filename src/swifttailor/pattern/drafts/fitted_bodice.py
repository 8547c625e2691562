"""The fitted bodice block: bust dart, waist darts, ends at the waist."""

from __future__ import annotations

from dataclasses import dataclass

from swifttailor.pattern.drafts.bodice import lay_torso_half, sew_torso, shoulder_tip_x
from swifttailor.pattern.drafts.cutting_table import CuttingTable
from swifttailor.pattern.drafts.darted_block import SIDE_MINIMUM, DartedBlock
from swifttailor.pattern.drafts.figure import Figure, Halves
from swifttailor.pattern.drafts.neckline import Neckline

FRONT_BALANCE, BLADE_FULLNESS = 1.0, 0.04
"""Length of the front over the back of a straight fall, as a part of the body's extra length there; and of
the back over the shoulder blades, as a part of the waist line."""
_RACER_FULLNESS = 0.01
"""The latter of a back that is cut in: its straps leave little to lie over."""
_YOKE_SIDE_CM = 4.0
"""Length of the side seam of a yoke, cm."""


@dataclass(frozen=True)
class FittedBodice:
    """How the fitted block is cut."""

    neckline: Neckline
    bust_ease: float
    """On top of the bust girth, cm around."""
    waist_ease: float
    """On top of the waist girth, cm around."""
    armhole_drop: float
    """Underarm point below the armpit, cm."""
    shoulder_extension: float = 0.0
    """Armhole seam beyond (positive) or inside (negative) the shoulder tip, cm."""
    yoke: bool = False
    """Whether it ends where the underarm is and has no darts, as what a smock is gathered into."""
    racer: bool = False
    """Whether the back is cut in between the shoulder blades, so that its straps run together there."""
    knit: bool = False
    """Whether it is of cloth that stretches, and has no darts."""


def lay_fitted_bodice(table: CuttingTable, figure: Figure, shape: FittedBodice) -> Halves:
    """Lays and sews both halves of the left side, down to the waist.

    Edges of ``left_ftorso`` and ``left_btorso``: waist, side, armhole, shoulder, neck, centre, dart.

    Returns:
        The sewn half widths at the waist, cm.
    """
    block = DartedBlock.of(
        figure,
        bust_ease=shape.bust_ease,
        waist_ease=shape.waist_ease,
        drop=shape.armhole_drop,
        least=_YOKE_SIDE_CM if shape.yoke else SIDE_MINIMUM,
    )
    if shape.knit:
        block = DartedBlock.of_knit(
            figure, bust_ease=shape.bust_ease, waist_ease=shape.waist_ease, drop=shape.armhole_drop
        )
    tip_x = shoulder_tip_x(figure, shape.neckline, shape.shoulder_extension)
    tip_x = min(tip_x, min(block.chest.front, block.chest.back) - 1.5)
    neck_x = min(shape.neckline.start_x(figure), tip_x - 3.0)
    for front in (True, False):
        outline = block.begin_half(
            front=front,
            bare=not front and shape.neckline.bares_back,
            darted=not (shape.yoke or shape.knit),
        )
        scoop = 0.66 if front else 0.5
        shoulder = (neck_x, tip_x)
        lay_torso_half(
            table,
            figure,
            outline,
            shape.neckline,
            shoulder,
            front=front,
            balance=FRONT_BALANCE,
            scoop=scoop,
            blade=_RACER_FULLNESS if shape.racer else BLADE_FULLNESS,
            racer=shape.racer and not front,
        )
    sew_torso(table)
    return block.waist
