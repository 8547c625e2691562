"""A collar folded down over the torso: cut along the neckline, in four, with points or rounded ends."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import Literal

from swifttailor.pattern.drafts.bodice import BACK_Z, FRONT_Z
from swifttailor.pattern.drafts.cutting_table import CuttingTable, Piece
from swifttailor.pattern.drafts.outline import Outline, Point, Side

FrontShape = Literal["rounded", "sailor"]
_OUTSIDE = 4.0
"""How far outside the torso it stands before draping, cm."""
_BELOW = 5.0
"""How far below its neckline it stands then, cm: sewn from there it is drawn up to the neck, and lies; from
as high as the neckline it may spring up around the neck.
"""
_POINT_OUT = 0.55
"""Distance of a point from the middle, over the width of the collar."""
_POINT_DOWN = 1.45
"""Fall of a point below the end of the neckline, over the width of the collar."""
_LEAF_OUT, _LEAF_DOWN = 0.8, 1.0
"""Where the front edge of a rounded leaf is lowest, beside and below the end of the neckline, over its width:
leaves that met in the middle would look like a ring."""
_LEAF_ROUND, _LEAF_BEND, _ROUND_OUT = 0.75, 0.45, 0.85
"""How far down and out, as parts of the way, that edge bends, and how far out the lower edge runs level, over
how far out the shoulder is."""
_SAILOR_DOWN, _SAILOR_SQUARE = 15.0, 0.97
"""How far a sailor collar hangs down behind, cm, and its half width there over that at the shoulder."""
_SAILOR_OUT, _SAILOR_UP = 0.62, 0.3
"""Where the outer edge of its front bends, as parts of the way out and up to the shoulder."""
_OF_SHOULDER = 0.86
"""Part of the shoulder that a collar covers at most."""


@dataclass(frozen=True)
class FoldCollar:
    """How the collar is cut."""

    width: float
    """Neckline to outer edge at the shoulder, cm."""
    ends: FrontShape | None = None
    """What it has in front; None for two points at the end of the neckline. A sailor collar ends in the point
    of the neckline, and behind in a deep square."""


def lay_fold_collar(table: CuttingTable, shape: FoldCollar) -> None:
    """Lays ``left_collar_front`` and ``left_collar_back`` on the left torso and sews them to its neckline.

    The edges that meet in a seam run the same way, since the collar lies folded on the torso; call before
    `CuttingTable.mirror`, and `sew_fold_collar` after it.
    """
    for face, torso in (("front", "left_ftorso"), ("back", "left_btorso")):
        front = face == "front"
        neck = neckline_sides(table.pieces[torso], back=not front)
        low = neck[-1].end[1]
        ends = _shoulder(table.pieces[torso], back=not front)
        outer = _along(ends, min(shape.width, _OF_SHOULDER * math.dist(*ends)))
        outline = Outline(0.0, low)
        if not front and shape.ends == "sailor":
            outline.line("centre", 0.0, low - _SAILOR_DOWN)
            outline.line("outer", _SAILOR_SQUARE * outer[0], low - _SAILOR_DOWN).line("outer", *outer)
        elif not front:
            outline.line("centre", 0.0, low - shape.width)
            across, down = (0.6 * outer[0], low - shape.width), (outer[0] - 1.0, outer[1] - 0.5 * shape.width)
            outline.cubic("outer", across, down, outer)
        elif shape.ends is None:
            _draw_points(outline, neck, shape.width, outer)
        elif shape.ends == "rounded":
            _draw_leaf(outline, low, shape.width, outer)
        else:
            bend = (_SAILOR_OUT * outer[0], low + _SAILOR_UP * (outer[1] - low))
            outline.quadratic("outer", bend, outer)
        outline.line("shoulder", *neck[0].start)
        for side in neck:
            outline.follow(side)
        z = FRONT_Z + _OUTSIDE if front else BACK_Z - _OUTSIDE
        name = f"left_collar_{face}"
        table.lay(name, outline.closed(), label="body", at=(0.0, -_BELOW, z), back=not front)
        table.seam(f"{torso}.neck", f"{name}.neck", folded=True)
    table.seam("left_collar_front.shoulder", "left_collar_back.shoulder")


def _draw_leaf(outline: Outline, low: float, width: float, outer: Point) -> None:
    """A front with a rounded end, which leaves the middle at the end of the neckline."""
    lowest = (_LEAF_OUT * width, low - _LEAF_DOWN * width)
    bend = _LEAF_BEND * lowest[0], low - _LEAF_ROUND * _LEAF_DOWN * width
    outline.cubic("outer", bend, (_LEAF_BEND * lowest[0], lowest[1]), lowest)
    across = max(_ROUND_OUT * outer[0], lowest[0] + 1.0)
    outline.cubic("outer", (1.6 * lowest[0], lowest[1]), (across, outer[1] - 1.2 * width), outer)


def _draw_points(outline: Outline, neck: list[Side], width: float, outer: Point) -> None:
    low, high = neck[-1].end[1], neck[0].start[1]
    outline.line("end", _POINT_OUT * width, low - _POINT_DOWN * width)
    outline.quadratic("outer", (outer[0], (low + high) / 2 - width), outer)


def sew_fold_collar(table: CuttingTable) -> None:
    """Sews the halves together behind; in front they lie apart."""
    table.seam("left_collar_back.centre", "right_collar_back.centre")


def neckline_sides(piece: Piece, *, back: bool) -> list[Side]:
    """Copies of the edges of the neckline, from the shoulder to the middle."""
    sides = piece.find("neck")
    sides = [side.reversed() for side in reversed(sides)] if back else sides
    return [replace(side, serial=Side("", (0.0, 0.0), (1.0, 0.0)).serial) for side in sides]


def _shoulder(piece: Piece, *, back: bool) -> tuple[Point, Point]:
    """Ends of the shoulder seam, neck first."""
    (side,) = piece.find("shoulder")
    return (side.start, side.end) if back else (side.end, side.start)


def _along(ends: tuple[Point, Point], distance: float) -> Point:
    (x1, y1), (x2, y2) = ends
    share = distance / ((x2 - x1) ** 2 + (y2 - y1) ** 2) ** 0.5
    return x1 + share * (x2 - x1), y1 + share * (y2 - y1)
