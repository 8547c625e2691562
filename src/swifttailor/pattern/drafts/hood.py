"""A hood of two panels, high and deep enough for a head."""

from __future__ import annotations

import math
from dataclasses import dataclass

from swifttailor.pattern import curve as curves
from swifttailor.pattern.curve import Quadratic
from swifttailor.pattern.drafts.cutting_table import CuttingTable
from swifttailor.pattern.drafts.figure import Figure
from swifttailor.pattern.drafts.outline import Outline, Point

SIDE_X = 15.5
"""Distance of the hood panels from the middle before draping, cm."""
THROAT_RISE = 0.2
"""How much higher than the nape the throat of a folded hood is drawn, over the depth."""
BACK_Z = -12.0
"""z of the nape end of the hood panels before draping, cm."""
_BACK_BEND, _FRONT_BEND = Quadratic((0.5, 0.08)), Quadratic((0.5, 0.1))


@dataclass(frozen=True)
class Hood:
    """How the hood is cut."""

    height: float
    """From the neckline over the crown, on top of the head length, cm."""
    depth: float
    """Front to back at the widest, on top of the head length, cm."""


def lay_hood(table: CuttingTable, figure: Figure, shape: Hood) -> None:
    """Lays ``left_hood`` and sews it to the left neckline; `sew_hood` joins both halves."""
    front = table.length("left_ftorso.neck")
    back = table.length("left_btorso.neck")
    height, depth = figure.head_length + shape.height, 0.8 * figure.head_length + shape.depth
    outline = hood_outline(front, back, height, depth)
    at = (max(SIDE_X, figure.neck_x + 5.0), figure.neck_y + 4.0, BACK_Z)
    table.lay("left_hood", outline, label="body", at=at, rotation=(0.0, 90.0, 0.0))
    table.seam("left_ftorso.neck", "left_hood.neck_front")
    table.seam("left_btorso.neck", "left_hood.neck_back")


def hood_outline(front: float, back: float, height: float, depth: float, *, folded: bool = False) -> Outline:
    """Draws half a hood in profile, the face toward -x, the nape at the origin.

    Edges: neck_front, neck_back, centre, face.

    Args:
        front: Length of half the neckline in front, cm.
        back: Of half of it behind, cm.
        height: From the nape over the crown, cm.
        depth: Front to back at the widest, cm; more where the neckline asks for it.
        folded: Whether the edge at a neckline that is longer than the hood is deep rises to the shoulder
            instead.
    """
    # From the nape forward the neck edge runs level, then falls toward the chin.
    shoulder = _along((0.0, 0.0), back, math.radians(176.0), _BACK_BEND)
    throat = _along(shoulder, front, math.radians(180.0 + 24.0), _FRONT_BEND)
    if folded and -throat[0] * 0.9 > depth:
        throat = (-depth / 0.9, THROAT_RISE * depth)
        shoulder = _corner(throat, math.dist(shoulder, (0.0, 0.0)), _chord(front, _FRONT_BEND))
    depth = max(depth, -throat[0] * 0.9)
    face_x = min(throat[0] + 1.0, -depth + 3.5)
    outline = Outline(*throat)
    outline.quadratic("neck_front", _control(shoulder, throat, _FRONT_BEND), shoulder)
    outline.quadratic("neck_back", _control((0.0, 0.0), shoulder, _BACK_BEND), (0.0, 0.0))
    rear = max(3.0, depth + face_x + 2.0)
    middle: Point = (0.2 * rear, 0.62 * height)
    crown: Point = (face_x + 1.5, height)
    outline.cubic("centre", (0.15 * rear, 0.16 * height), (rear * 0.9, 0.36 * height), middle)
    outline.cubic("centre", (-0.55 * rear, 0.92 * height), (0.5 * crown[0], height + 0.6), crown)
    outline.quadratic("face", (face_x - 0.8, 0.45 * height), throat)
    return outline.closed()


def sew_hood(table: CuttingTable) -> None:
    """Sews both halves of the hood along crown and back."""
    table.seam("left_hood.centre", "right_hood.centre")


def _along(start: Point, length: float, angle: float, bend: Quadratic) -> Point:
    """Where a bent edge of that arc length ends when its chord leaves `start` at that angle."""
    chord = _chord(length, bend)
    return start[0] + chord * math.cos(angle), start[1] + chord * math.sin(angle)


def _chord(length: float, bend: Quadratic) -> float:
    return length / curves.length(bend, [[0.0, 0.0], [1.0, 0.0]])


def _corner(throat: Point, back: float, front: float) -> Point:
    """Where two chords from the nape and the throat meet above both, cm."""
    span = math.dist(throat, (0.0, 0.0))
    if not abs(back - front) < span < back + front:
        return throat[0] * back / (back + front), throat[1] * back / (back + front)
    along = (back**2 - front**2 + span**2) / (2 * span)
    rise = math.sqrt(back**2 - along**2)
    x, y = throat[0] / span, throat[1] / span
    return along * x + rise * y, along * y - rise * x


def _control(start: Point, end: Point, bend: Quadratic) -> Point:
    """Control point of the bent edge between two points, seen from `start` whatever way it is drawn."""
    x, y = curves.to_absolute(bend.control, [start, end])
    return float(x), float(y)
