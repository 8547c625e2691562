"""The collar of a coat: a stand behind the neck that runs out along the lapels, turned down over itself."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Literal

from swifttailor.pattern.drafts.bodice import FRONT_Z
from swifttailor.pattern.drafts.cutting_table import CuttingTable
from swifttailor.pattern.drafts.figure import Figure
from swifttailor.pattern.drafts.fold_collar import neckline_sides
from swifttailor.pattern.drafts.outline import Outline, Point
from swifttailor.pattern.drafts.stand_collar import ABOVE_NECK, CLOSE_BACK_Z, lean

LapelShape = Literal["notched", "shawl"]
_STAND_CM = 2.8
"""Height of the stand at shoulder and back; along the lapels it runs out."""
_STAND_Z, _FALL_Z = 2.0, 4.0
"""How far outside the torso its front stands before draping, cm, and what is turned down."""
_OUTSIDE = 3.0
"""How far outside the stand behind what is turned down is placed, cm."""
_BELOW_STAND = 0.5
"""So far beyond its stand the collar falls, over its width on the shoulder."""
_FLARE = 1.5
"""So much longer than the fold is the outer edge of each quarter, cm; it lies further out."""
_GORGE = 0.62
"""Where the points of the lapels are, as a part of the way up the fold."""


@dataclass(frozen=True)
class LapelCollar:
    """How the collar is cut."""

    width: float
    """Neckline to outer edge at the shoulder, cm."""
    lapels: LapelShape
    """Its shape in front."""
    lapel_width: float
    """Fold to outer edge where lapels are widest, cm."""

    @property
    def fall(self) -> float:
        """Fold to outer edge at shoulder and back, cm."""
        return _STAND_CM + _BELOW_STAND * self.width

    def lay(self, table: CuttingTable, figure: Figure) -> None:
        """Lays its left half on the left torso; call before `CuttingTable.mirror`."""
        lay_lapel_collar(table, figure, self)

    def sew(self, table: CuttingTable) -> None:
        """Joins its halves, after `CuttingTable.mirror`."""
        sew_lapel_collar(table)


@dataclass(frozen=True)
class _Along:
    """Coordinates along a line, and outward from it, cm."""

    start: Point
    end: Point

    @property
    def long(self) -> float:
        """Its length, cm."""
        return math.dist(self.start, self.end)

    def __call__(self, along: float, out: float) -> Point:
        """The point so far along it, as a part of its length, and so far outward, cm."""
        (x, y), long = self.start, self.long
        u, v = (self.end[0] - x) / long, (self.end[1] - y) / long
        return x + along * long * u + out * v, y + along * long * v - out * u


def lay_lapel_collar(table: CuttingTable, figure: Figure, shape: LapelCollar) -> None:
    """Lays ``left_collar_front`` and ``_back``, which stand, and ``left_collar_fall_front`` and ``_back``.

    In front all of it lies as on the torso: the stand covers what is between the neckline and the line from
    its lower end to beside the neck, along which lapels are turned down.

    Args:
        table: Where the left half of a torso lies; `sew_lapel_collar` joins the halves after its `mirror`.
        figure: The body.
        shape: How it is cut.
    """
    neck = neckline_sides(table.pieces["left_ftorso"], back=False)
    low, shoulder = neck[-1].end, neck[0].start
    end = math.hypot(_STAND_CM, lean(_STAND_CM, table.length("left_btorso.neck")))
    run = end / math.hypot(1.0, figure.slope)
    inner = shoulder[0] - run, shoulder[1] + run * figure.slope
    stand = Outline(*low)
    for side in [side.reversed() for side in reversed(neck)]:
        stand.follow(side)
    stand.line("end", *inner).line("top", *low)
    table.lay("left_collar_front", stand.closed(), label="body", at=(0.0, 0.0, FRONT_Z + _STAND_Z))
    table.seam("left_ftorso.neck", "left_collar_front.neck")

    fold = _Along(low, inner)
    front = Outline(*low)
    _draw_lapel(front, fold, shape)
    front.line("end", *inner).line("top", *low)
    table.lay("left_collar_fall_front", front.closed(), label="body", at=(0.0, 0.0, FRONT_Z + _FALL_Z))
    _lay_back(table, figure, shape.fall)
    for face in ("front", "back"):
        table.seam(f"left_collar_{face}.top", f"left_collar_fall_{face}.top", folded=True)
    table.seam("left_collar_front.end", "left_collar_back.end")
    table.seam("left_collar_fall_front.end", "left_collar_fall_back.end")


def _draw_lapel(outline: Outline, fold: _Along, shape: LapelCollar) -> None:
    wide, fall = shape.lapel_width, shape.fall
    end = fold(1.0 + _FLARE / fold.long, fall)
    if shape.lapels == "shawl":
        outline.cubic("outer", fold(0.18, 0.75 * wide), fold(0.42, 1.05 * wide), fold(_GORGE, wide))
        outline.quadratic("outer", fold(0.82, fall + 0.5 * (wide - fall)), end)
        return
    outline.quadratic("outer", fold(0.32, 0.9 * wide), fold(_GORGE, wide))
    notch, corner = fold(_GORGE + 0.07, 0.5 * wide), fold(_GORGE + 0.07 + 0.1, 0.45 * wide + 0.45 * fall)
    outline.line("outer", *notch).line("outer", *corner)
    outline.quadratic("outer", fold(0.9, 1.02 * fall), end)


def _lay_back(table: CuttingTable, figure: Figure, fall: float) -> None:
    """Lays both strips behind and sews the lower one to the neckline."""
    long = table.length("left_btorso.neck")
    at = (0.0, figure.neck_y + ABOVE_NECK, CLOSE_BACK_Z)
    stand = Outline(0.0, 0.0).line("neck", long, 0.0).line("end", long - lean(_STAND_CM, long), _STAND_CM)
    stand.line("top", 0.0, _STAND_CM).line("centre", 0.0, 0.0)
    piece = table.lay("left_collar_back", stand.closed(), label="body", at=at, back=True)
    table.seam("left_btorso.neck", "left_collar_back.neck")
    top, low = piece.length("top"), _STAND_CM - fall
    turned = Outline(0.0, low).line("outer", top + _FLARE, low).line("end", top, _STAND_CM)
    turned.line("top", 0.0, _STAND_CM).line("centre", 0.0, low)
    at = (*at[:2], CLOSE_BACK_Z - _OUTSIDE)
    table.lay("left_collar_fall_back", turned.closed(), label="body", at=at, back=True)


def sew_lapel_collar(table: CuttingTable) -> None:
    """Sews the halves together behind; in front they lie apart."""
    for part in ("collar_back", "collar_fall_back"):
        table.seam(f"left_{part}.centre", f"right_{part}.centre")
