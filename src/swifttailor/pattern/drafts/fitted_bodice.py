"""The fitted bodice block: bust dart, waist darts, ends at the waist."""

from __future__ import annotations

import math
from dataclasses import dataclass

from swifttailor.pattern.drafts.bodice import lay_torso_half, sew_torso, shoulder_tip_x
from swifttailor.pattern.drafts.cutting_table import CuttingTable
from swifttailor.pattern.drafts.figure import Figure, Halves
from swifttailor.pattern.drafts.neckline import Neckline
from swifttailor.pattern.drafts.outline import Dart, Outline, Point
from swifttailor.pattern.drafts.suppression import dart_places, suppress

FRONT_BALANCE, BLADE_FULLNESS = 1.0, 0.04
"""Length of the front over the back of a straight fall, as a part of the body's extra length there; and of
the back over the shoulder blades, as a part of the waist line."""
SIDE_MINIMUM = 8.0
"""Shortest side seam, cm."""


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


def lay_fitted_bodice(table: CuttingTable, figure: Figure, shape: FittedBodice) -> Halves:
    """Lays and sews both halves of the left side, down to the waist.

    Edges of ``left_ftorso`` and ``left_btorso``: waist, side, armhole, shoulder, neck, centre, dart.

    Returns:
        The sewn half widths at the waist, cm.
    """
    waist = figure.waist.eased(shape.waist_ease)
    taken = suppress(figure.bust.eased(shape.bust_ease), waist, 0.45, 3.0)
    chest = taken.wide(waist)
    waist_y = figure.waist_y
    under_y = max(figure.armpit_y - shape.armhole_drop, waist_y + SIDE_MINIMUM)
    room = under_y - waist_y
    tip_x = shoulder_tip_x(figure, shape.neckline, shape.shoulder_extension)
    tip_x = min(tip_x, min(chest.front, chest.back) - 1.5)
    neck_x = min(shape.neckline.start_x(figure), tip_x - 3.0)
    places = dart_places(figure, waist)
    for side, half, narrow, place in (
        ("f", chest.front, waist.front, places.front),
        ("b", chest.back, waist.back, places.back),
    ):
        front = side == "f"
        width = taken.front if front else taken.back
        height = min(figure.bust_y - 3.0 - waist_y if front else room - 2.0, room - 1.5)
        darts = [Dart(place, width, max(height, 5.0))] if width else []
        outline = Outline(0.0, waist_y)
        outline.darted_line("waist", (narrow + width, waist_y), darts)
        if front:
            draw_side_with_bust_dart(outline, figure, (half, under_y))
        else:
            outline.line("side", half, under_y)
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
            blade=BLADE_FULLNESS,
        )
    sew_torso(table)
    return waist


def draw_side_with_bust_dart(outline: Outline, figure: Figure, underarm: Point) -> None:
    """Draws the front side seam with a dart that points to the bust.

    The seam is drawn as on the back and cut a little below the underarm; what lies above is turned about
    the tip of the dart. So the closed seam is exactly as long as the back's.
    """
    start = outline.sides[-1].end
    length = math.dist(start, underarm)
    t = 1 - min(6.0, 0.45 * length) / length
    mouth = (start[0] + t * (underarm[0] - start[0]), start[1] + t * (underarm[1] - start[1]))
    tip = (min(figure.bust_x + 2.5, mouth[0] - 4.0), min(figure.bust_y, underarm[1] - 1.0))
    reach = math.dist(tip, mouth)
    opening = min(0.9 * figure.front_fullness, 0.35 * reach)
    if opening < 0.8:
        outline.line("side", *underarm)
        return
    angle = 2 * math.asin(opening / (2 * reach))
    outline.line("side", *mouth)
    outline.dart(tip, _turned(mouth, tip, angle))
    outline.line("side", *_turned(underarm, tip, angle))


def _turned(point: Point, center: Point, angle: float) -> Point:
    c, s = math.cos(angle), math.sin(angle)
    x, y = point[0] - center[0], point[1] - center[1]
    return center[0] + c * x - s * y, center[1] + s * x + c * y
