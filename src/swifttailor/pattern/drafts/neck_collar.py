"""Which collar a garment's neckline is cut for: none, one folded down, or one that stands."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Literal

from swifttailor.pattern.drafts.cutting_table import CuttingTable
from swifttailor.pattern.drafts.figure import Figure
from swifttailor.pattern.drafts.fold_collar import FoldCollar, lay_fold_collar, sew_fold_collar
from swifttailor.pattern.drafts.neckline import Neckline
from swifttailor.pattern.drafts.options import Option
from swifttailor.pattern.drafts.stand_collar import lay_stand_collar, sew_collar

CollarShape = Literal["none", "folded", "standing"]
CollarOption = Annotated[
    CollarShape,
    Option("Collar: folded down over a V neck 7 to 16 cm deep, or standing on a close neck."),
]
SewnCollarOption = Annotated[
    Literal["folded", "standing"], Option("Collar: folded down, or standing on a close neck.")
]
CollarHeight = Annotated[float, Option("Height of a collar that stands.", "cm", 2.0, 14.0)]
_CLOSE, _BEHIND = 1.0, 1.5
"""Widest and lowest behind, cm, that a neckline may be to carry a collar."""
_FOLDED_DEPTH = 7.0, 16.0
_STANDING_WIDENING, _STANDING_DEPTH = 0.5, 6.5


@dataclass(frozen=True)
class NeckCollar:
    """The collar of a garment."""

    shape: CollarShape
    width: float
    """Of one folded down, on the shoulder, cm."""
    height: float
    """Of one that stands, cm."""

    def neckline(self, asked: Neckline) -> Neckline:
        """The neckline that it is sewn to; the one that is asked for where there is no collar."""
        if self.shape == "folded":
            low, high = _FOLDED_DEPTH
            return Neckline("v", min(asked.widening, _CLOSE), min(max(asked.front_depth, low), high), _BEHIND)
        if self.shape == "standing":
            return Neckline("round", _STANDING_WIDENING, _STANDING_DEPTH, _BEHIND)
        return asked

    def lay(self, table: CuttingTable, figure: Figure) -> None:
        """Lays its left half on the left torso; call before `CuttingTable.mirror`."""
        if self.shape == "folded":
            lay_fold_collar(table, FoldCollar(self.width))
        elif self.shape == "standing":
            lay_stand_collar(table, figure, self.height)

    def sew(self, table: CuttingTable) -> None:
        """Joins its halves, after `CuttingTable.mirror`."""
        if self.shape == "folded":
            sew_fold_collar(table)
        elif self.shape == "standing":
            sew_collar(table)
