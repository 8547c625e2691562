"""A collar that stands around the neck and is turned down over itself: a shirt's, a roll neck."""

from __future__ import annotations

from dataclasses import dataclass

from swifttailor.pattern.drafts.cutting_table import CuttingTable
from swifttailor.pattern.drafts.figure import Figure
from swifttailor.pattern.drafts.outline import Outline
from swifttailor.pattern.drafts.stand_collar import ABOVE_NECK, CLOSE_BACK_Z, CLOSE_FRONT_Z, lay_stand_collar

_OUTSIDE = 3.0
"""How far outside the stand the rest is placed before draping, cm."""


@dataclass(frozen=True)
class TurnedCollar:
    """How the collar is cut."""

    stand: float
    """Neckline to the fold, cm."""
    fall: float
    """Fold to the outer edge behind, cm."""
    flare: float = 1.0
    """So much longer than the fold is the outer edge of each quarter, cm; it lies further out."""
    points: float | None = 3.0
    """So much further it reaches at its points, in front, cm; None sews its halves together there."""


def lay_turned_collar(table: CuttingTable, figure: Figure, shape: TurnedCollar) -> None:
    """Lays ``left_collar_front`` and ``_back``, which stand, and ``left_collar_fall_front`` and ``_back``.

    Args:
        table: Where the left half of a torso lies; `sew_turned_collar` joins the halves after its `mirror`.
        figure: The body.
        shape: How it is cut.
    """
    lay_stand_collar(table, figure, shape.stand)
    for face in ("front", "back"):
        long = table.length(f"left_collar_{face}.top")
        low = shape.stand - shape.fall
        if face == "front" and shape.points is not None:
            outline = Outline(shape.points / 2, low - shape.points)
            outline.quadratic("outer", (long / 2, low - 0.1 * shape.points), (long + shape.flare, low))
        else:
            outline = Outline(0.0, low).line("outer", long + shape.flare, low)
        outline.line("end", long, shape.stand).line("top", 0.0, shape.stand)
        outline.line("centre", *outline.sides[0].start)
        table.lay(
            f"left_collar_fall_{face}",
            outline.closed(),
            label="body",
            at=(
                0.0,
                figure.neck_y + ABOVE_NECK,
                CLOSE_FRONT_Z + _OUTSIDE if face == "front" else CLOSE_BACK_Z - _OUTSIDE,
            ),
            back=face == "back",
        )
        table.seam(f"left_collar_{face}.top", f"left_collar_fall_{face}.top", folded=True)
    table.seam("left_collar_fall_front.end", "left_collar_fall_back.end")


def sew_turned_collar(table: CuttingTable, *, joined: bool) -> None:
    """Sews what is turned down together behind and, where it goes all around, in front; the stand apart."""
    table.seam("left_collar_fall_back.centre", "right_collar_fall_back.centre")
    if joined:
        table.seam("right_collar_fall_front.centre", "left_collar_fall_front.centre")
