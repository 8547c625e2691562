"""Sleeves cut in one with the body: batwing, dolman and kimono-cut tops, dresses and coats."""

from __future__ import annotations

import math
from dataclasses import dataclass

from swifttailor.pattern.drafts.cutting_table import CuttingTable, Piece, turned
from swifttailor.pattern.drafts.figure import Figure
from swifttailor.pattern.drafts.outline import Outline, Point, Side
from swifttailor.pattern.drafts.sleeve import find_root

_LIFTED, _MOST_LIFTED, _LIFT_STEP = 5.0, 34.0, 1.0
"""By how many degrees the sleeve is cut higher than the arm is held: long ones cut higher slip off the arm
before they are sewn around it, short wide ones cut lower end within the side."""
_CLEAR_CM = 4.0
"""So far beyond the side the lower corner of the sleeve's end lies."""
_ROUNDED_CM = 12.0
"""So far beyond the shoulder tip the seam over the arm is rounded: with less, the neckline stands off."""
_SHORTEST_CM, _SHORTEST_SIDE_CM = 6.0, 5.0
"""Seam over the arm, and side seam that is left below the wing, at least."""
_REACH = 0.6
"""How far the curve under the arm reaches into the corner between side and arm."""
_LEAST_RISE_CM = 6.0
"""How far above the beginning of a wing that corner is: with less, the sleeve is narrow there."""
_WITHIN_CM = 1.0
"""A wing begins so far within the lower corner of the sleeve's end, at least: lower down, sides that slant
outward reach beyond it."""
_STEP_CM = 1.0
"""Steps in which such a wing is moved up, cm."""
_NARROWEST_CM = 20.0
"""Width around the end of sleeves that are made narrower, at least."""
_CUFF_GAP = 4.0
"""Between a sleeve and its cuff before draping, cm."""
_CUFF_FRONT_Z, _CUFF_BACK_Z = 15.5, -15.5
"""Where cuffs stand before draping, cm."""


@dataclass(frozen=True)
class CutInOne:
    """How the sleeves are cut."""

    length: float
    """From the shoulder tip along the arm to the sleeve's end, cm; without a cuff."""
    end_width: float
    """Width around at the end, cm."""
    drop: float
    """How far down its side, from the underarm of the torso, the wing begins, cm."""
    shoulder_extension: float = 0.0
    """How far the torso's shoulder seam reaches over the shoulder tip, cm."""


def cut_sleeve_in_one(table: CuttingTable, figure: Figure, shape: CutInOne) -> None:
    """Gives the left torso sleeves of its cloth; front and back are sewn together over and under the arm.

    Instead of their armholes ``left_ftorso`` and ``left_btorso`` get the edges under, end and over. The curve
    under the arm is the same on both, so that their sleeves differ a little in direction.

    Args:
        table: Must already hold the left torso, its side and shoulder sewn.
        figure: Gives the arm's direction.
        shape: Of the sleeve.
    """
    armholes = {side: _seen_from_front(table, side, "armhole") for side in "fb"}
    tip = _middle(*(armhole.end for armhole in armholes.values()))
    underarm = _middle(*(armhole.start for armhole in armholes.values()))
    length = max(shape.length - shape.shoulder_extension, _SHORTEST_CM)
    hem = _middle(*(_side_ends(table, side) for side in "fb"))
    degrees, length, half = _clear_of_torso(tip, underarm, hem, shape.end_width / 2, length, figure.arm_angle)
    over, under = _end(tip, degrees, length, half)
    corner = under[1] + (under[0] - underarm[0]) * math.tan(math.radians(degrees))
    _cut_side(table, shape.drop, underarm[1] - corner + _LEAST_RISE_CM, under[0] - _WITHIN_CM)
    beginnings = {side: _wing_begins(table, side) for side in "fb"}
    low = _middle(*beginnings.values())
    top = max(corner, low[1] + _LEAST_RISE_CM / 2)
    for side, begins in beginnings.items():
        aside, up = begins[0] - low[0], begins[1] - low[1]

        def beside(x: float, y: float, aside: float = aside, up: float = up) -> Point:
            return x + aside, y + up

        outline = Outline(*begins).cubic(
            "under",
            beside(low[0], low[1] + _REACH * (top - low[1])),
            beside(under[0] + _REACH * (low[0] - under[0]), under[1] + _REACH * (top - under[1])),
            beside(*under),
        )
        seam = _over_arm(_seen_from_front(table, side, "shoulder"), beside(*over), length)
        _put_in(table, side, outline.line("end", *seam.start).follow(seam))
    for edge in ("under", "over"):
        table.seam(f"left_ftorso.{edge}", f"left_btorso.{edge}")


def _middle(first: Point, second: Point) -> Point:
    return (first[0] + second[0]) / 2, (first[1] + second[1]) / 2


def _seen_from_front(table: CuttingTable, side: str, name: str) -> Side:
    """The one edge of that name of the front or back torso, in counter-clockwise order."""
    (found,) = table.pieces[f"left_{side}torso"].find(name)
    return found if side == "f" else found.reversed()


def _end(tip: Point, degrees: float, length: float, half: float) -> tuple[Point, Point]:
    """Upper and lower corner of the end of a sleeve that falls by so many degrees."""
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    over = (tip[0] + length * c, tip[1] - length * s)
    return over, (over[0] - half * s, over[1] - half * c)


def _clear_of_torso(
    tip: Point, underarm: Point, hem: Point, half: float, length: float, arm_angle: float
) -> tuple[float, float, float]:
    """Direction, degrees below the horizontal, length and half width of a sleeve that is clear of the torso.

    Its end lies beyond the side, and its lower edge above the side's lower end: it is raised until that is
    so, then made longer and narrower.
    """
    degrees = arm_angle - _LIFTED
    least = max(arm_angle - _MOST_LIFTED, 0.0)

    def lacks() -> tuple[float, float]:
        x, y = _end(tip, degrees, length, half)[1]
        over_hem = y + (x - hem[0]) * math.tan(math.radians(degrees))
        down = min(max((underarm[1] - y) / (underarm[1] - hem[1]), 0.0), 1.0)
        side = underarm[0] + down * (hem[0] - underarm[0])
        return side + _CLEAR_CM - x, hem[1] + _CLEAR_CM - over_hem

    while max(lacks()) > 0 and degrees > least:
        degrees = max(degrees - _LIFT_STEP, least)
    while lacks()[0] > 0:
        length += 1.0
    while lacks()[1] > 0 and half > _NARROWEST_CM / 2:
        half -= 0.5
    return degrees, length, half


def _upper_side(piece: Piece) -> Side:
    """The uppermost edge of the side seam."""
    return max((s for s in piece.sides if s.name == "side"), key=lambda s: max(s.start[1], s.end[1]))


def _cut_side(table: CuttingTable, drop: float, least: float, furthest: float) -> None:
    """Cuts the side seam below the underarm; front and back, which are sewn there, at once.

    Args:
        table: Where the torso lies.
        drop: How far below, cm.
        least: No less far than this, cm.
        furthest: How far from the middle it may be cut, cm; higher up where the side slants outward.
    """
    piece = table.pieces["left_ftorso"]
    whole, behind = (_upper_side(table.pieces[f"left_{side}torso"]) for side in "fb")
    share = min(max(drop, least) / whole.length, 1.0 - min(_SHORTEST_SIDE_CM / whole.length, 0.5))

    def beyond() -> bool:
        ends = whole.split([1.0 - share])[0].end, behind.split([share])[0].end
        return _middle(*ends)[0] > furthest

    while beyond() and share * whole.length > least + _STEP_CM:
        share -= _STEP_CM / whole.length
    table.cut_side(piece, whole, 1.0 - share)


def _side_ends(table: CuttingTable, side: str) -> Point:
    """The outermost point of the hem."""
    ends = [point for s in table.pieces[f"left_{side}torso"].find("hem") for point in (s.start, s.end)]
    return max(ends)


def _wing_begins(table: CuttingTable, side: str) -> Point:
    """Lower end of the uppermost edge of the side seam."""
    upper = _upper_side(table.pieces[f"left_{side}torso"])
    return min(upper.start, upper.end, key=lambda point: point[1])


def _over_arm(shoulder: Side, towards: Point, length: float) -> Side:
    """The seam over the arm, from the sleeve's end to the shoulder tip, rounded there and so long, cm."""
    tip, neck = shoulder.start, shoulder.end
    far, rest = math.dist(tip, neck), math.dist(tip, towards)
    along = ((towards[0] - tip[0]) / rest, (towards[1] - tip[1]) / rest)
    near = min(_ROUNDED_CM, 0.4 * length)

    def reaching(distance: float) -> Side:
        end = (tip[0] + distance * along[0], tip[1] + distance * along[1])
        back = 0.4 * distance
        return (
            Outline(*end)
            .cubic(
                "over",
                (end[0] - back * along[0], end[1] - back * along[1]),
                (tip[0] + near * (tip[0] - neck[0]) / far, tip[1] + near * (tip[1] - neck[1]) / far),
                tip,
            )
            .sides[0]
        )

    return reaching(find_root(lambda far: reaching(far).length - length, 0.5 * length, length, 1e-9))


def _put_in(table: CuttingTable, side: str, outline: Outline) -> None:
    """Puts the sleeve's edges in the place of armhole and upper side."""
    piece = table.pieces[f"left_{side}torso"]
    taken = [piece.sides.index(_upper_side(piece)), piece.sides.index(piece.find("armhole")[0])]
    new = outline.sides if side == "f" else [s.reversed() for s in reversed(outline.sides)]
    table.replace_sides(piece, min(taken), 2, new)


def lay_cuff_of_one(table: CuttingTable, figure: Figure, at: float, ease: float, height: float) -> None:
    """Lays the left cuff below a sleeve that is cut in one, and sews it on; see `band.lay_sleeve_cuff`."""
    total = table.length("left_ftorso.end", "left_btorso.end")
    width = min(figure.arm_girth(at) + ease, total)
    for side in "fb":
        torso, name = f"left_{side}torso", f"sl_left_cuff_{side}"
        end = _seen_from_front(table, side, "end")
        half = width * end.length / total
        across = ((end.end[0] - end.start[0]) / end.length, (end.end[1] - end.start[1]) / end.length)
        inset = (end.length - half) / 2
        outline = Outline(_CUFF_GAP, -half).line("under", _CUFF_GAP + height, -half)
        outline.line("end", _CUFF_GAP + height, 0.0).line("top", _CUFF_GAP, 0.0)
        outline.line("join", _CUFF_GAP, -half)
        corner = (end.end[0] - inset * across[0], end.end[1] - inset * across[1])
        table.lay(
            name,
            turned(outline.closed(), -90.0),
            label="arm",
            at=(*corner, _CUFF_FRONT_Z if side == "f" else _CUFF_BACK_Z),
            rotation=(0.0, 0.0, math.degrees(math.atan2(across[1], across[0]))),
            back=side == "b",
        )
        table.seam(f"{torso}.end", f"{name}.join", gathered=True)
    table.seam("sl_left_cuff_f.top", "sl_left_cuff_b.top")
    table.seam("sl_left_cuff_f.under", "sl_left_cuff_b.under")
