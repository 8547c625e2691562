"""Which collar a garment's neckline is cut for: none, a shirt's, one that lies flat, or one that stands."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Annotated, Literal

from swifttailor.pattern.drafts.cutting_table import CuttingTable
from swifttailor.pattern.drafts.figure import Figure
from swifttailor.pattern.drafts.fold_collar import (
    FoldCollar,
    FrontShape,
    lay_fold_collar,
    sew_fold_collar,
)
from swifttailor.pattern.drafts.hood import Hood, lay_hood, sew_hood
from swifttailor.pattern.drafts.lapel_collar import LapelCollar
from swifttailor.pattern.drafts.neckline import Neckline
from swifttailor.pattern.drafts.options import Option
from swifttailor.pattern.drafts.stand_collar import lay_stand_collar, sew_collar
from swifttailor.pattern.drafts.turned_collar import TurnedCollar, lay_turned_collar, sew_turned_collar

SewnCollarShape = Literal[
    "shirt", "folded", "flat", "sailor", "standing", "mandarin", "rolled", "revers", "hood"
]
CollarShape = Literal["none", "loose", SewnCollarShape]
_SHAPES = (
    "shirt: a stand on a close neck, turned down over itself; folded: flat over a V neck 7 to 16 cm deep; "
    "flat: with rounded ends on a close neck; sailor: from the point of a V to a square on the back; "
    "standing: on a close neck; mandarin: the same, open in front; rolled: the same, turned down over "
    "itself; revers: small lapels on a V neck 16 to 20 cm deep; hood: a hood instead."
)
CollarOption = Annotated[CollarShape, Option(f"Collar. {_SHAPES}")]
SewnCollarOption = Annotated[SewnCollarShape, Option(f"Collar. {_SHAPES}")]
CollarHeight = Annotated[float, Option("Height of a collar that stands.", "cm", 2.0, 14.0)]
_CLOSE, _BEHIND = 1.0, 1.5
"""Widest and lowest behind, cm, that a neckline may be to carry a collar."""
_FOLDED_DEPTH = 7.0, 16.0
_STANDING_WIDENING, _STANDING_DEPTH, _STANDING_BEHIND = -0.8, 6.0, 2.2
"""Of necklines of collars that stand, cm: on wider ones, or higher ones behind, they stand away from the
neck."""
_LOOSE_WIDENING, _LOOSE_DEPTH, _LOOSE_BEHIND = 2.0, 9.5, 3.0
"""Of necklines of a wide collar that falls in folds over itself, cm."""
_LOOSE_STAND, _LOOSE_FLARE_CM = 0.6, 2.5
"""How much of its height it stands, and the room of what falls over that, a quarter, cm."""
_FLAT_WIDENING, _FLAT_DEPTH = -0.5, 9.0
"""Of necklines of flat collars, cm."""
_REVERS_DEPTH, _REVERS_CM = (16.0, 20.0), 6.5
"""Fall of the V of a collar with small lapels, at least and at most, and their width, cm."""
_HOOD_WIDENING, _HOOD_DEPTH = 2.0, 10.0
_HOOD = Hood(6.0, 5.0)
_SAILOR_DEPTH, _SAILOR_WIDTH = (14.0, 18.0), 10.5
"""Fall of the V of a sailor collar, at least and at most, and how wide that is on the shoulder, cm."""
_STAND_CM, _FALL_OVER_WIDTH = 2.5, 0.85
"""Height of the stand of a shirt collar; what is turned down over the width of one that lies flat."""
_STAND_SHOWS_CM, _ROLL_FLARE_CM = 1.2, 1.0
"""What is seen of the stand below what is turned down of a roll neck, whose room around it is the other, a
quarter."""
_FOLDED: Mapping[str, FrontShape | None] = {"folded": None, "flat": "rounded", "sailor": "sailor"}
"""What those that lie on the torso have in front."""


@dataclass(frozen=True)
class NeckCollar:
    """The collar of a garment."""

    shape: CollarShape
    width: float
    """Of one folded down, on the shoulder, cm; a shirt's is a little narrower."""
    height: float
    """Of one that stands, turned down or not, cm."""

    def neckline(self, asked: Neckline) -> Neckline:
        """The neckline that it is sewn to; the one that is asked for where there is no collar."""
        if self.shape == "folded":
            low, high = _FOLDED_DEPTH
            return Neckline("v", min(asked.widening, _CLOSE), min(max(asked.front_depth, low), high), _BEHIND)
        if self.shape == "sailor":
            low, high = _SAILOR_DEPTH
            return Neckline("v", min(asked.widening, _CLOSE), min(max(asked.front_depth, low), high), _BEHIND)
        if self.shape == "revers":
            low, high = _REVERS_DEPTH
            depth = min(max(asked.front_depth, low), high)
            return Neckline("v", min(asked.widening, 0.0), depth, _BEHIND)
        if self.shape == "hood":
            return Neckline("round", _HOOD_WIDENING, _HOOD_DEPTH, _BEHIND)
        if self.shape == "flat":
            return Neckline("round", _FLAT_WIDENING, _FLAT_DEPTH, _STANDING_BEHIND)
        if self.shape == "loose":
            return Neckline("round", _LOOSE_WIDENING, _LOOSE_DEPTH, _LOOSE_BEHIND)
        if self.shape in ("standing", "mandarin", "shirt", "rolled"):
            return Neckline("round", _STANDING_WIDENING, _STANDING_DEPTH, _STANDING_BEHIND)
        return asked

    def lay(self, table: CuttingTable, figure: Figure) -> None:
        """Lays its left half on the left torso; call before `CuttingTable.mirror`."""
        if self.shape in _FOLDED:
            width = _SAILOR_WIDTH if self.shape == "sailor" else self.width
            lay_fold_collar(table, FoldCollar(width, _FOLDED[self.shape]))
        elif self.shape == "shirt":
            lay_turned_collar(table, figure, TurnedCollar(_STAND_CM, _FALL_OVER_WIDTH * self.width))
        elif self.shape == "rolled":
            rolled = TurnedCollar(self.height, self.height - _STAND_SHOWS_CM, _ROLL_FLARE_CM, points=None)
            lay_turned_collar(table, figure, rolled)
        elif self.shape == "loose":
            loose = TurnedCollar(_LOOSE_STAND * self.height, self.height, _LOOSE_FLARE_CM, points=None)
            lay_turned_collar(table, figure, loose)
        elif self.shape in ("standing", "mandarin"):
            lay_stand_collar(table, figure, self.height, split=self.shape == "mandarin", away=True)
        elif self.shape == "hood":
            lay_hood(table, figure, _HOOD)
        elif self.shape == "revers":
            self._revers.lay(table, figure)

    @property
    def _revers(self) -> LapelCollar:
        return LapelCollar(min(self.width, 5.0), "notched", _REVERS_CM)

    def sew(self, table: CuttingTable) -> None:
        """Joins its halves, after `CuttingTable.mirror`."""
        if self.shape in _FOLDED:
            sew_fold_collar(table)
        elif self.shape == "hood":
            sew_hood(table)
        elif self.shape == "revers":
            self._revers.sew(table)
        elif self.shape != "none":
            sew_collar(table, split=self.shape == "mandarin")
        if self.shape in ("shirt", "rolled", "loose"):
            sew_turned_collar(table, joined=self.shape != "shirt")


NO_COLLAR = NeckCollar("none", 0.0, 0.0)
"""Of a garment that has none."""
