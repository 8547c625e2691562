"""Raglan sleeves: their seams run from the underarm to the neckline, and the shoulder is part of them."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np

from swifttailor.pattern import curve as curves
from swifttailor.pattern.drafts.cutting_table import CuttingTable
from swifttailor.pattern.drafts.figure import Figure
from swifttailor.pattern.drafts.outline import Outline, Point, Side
from swifttailor.pattern.drafts.sleeve import LOWEST_CAP, Sleeve, find_root, place_on_arm

NECK_CM = {"f": 3.5, "b": 2.5}
"""How much of the neckline in front and behind, from the shoulder on, lies on the sleeve."""
_LEAST_NECK = 0.4
"""Part of a short neckline that stays on the torso."""
_ROUNDED_CM = 7.0
"""So far on both sides of the shoulder tip the seam over the arm is rounded."""
_ROOM_CM = 0.6
"""How far the seam over the arm lies above the tip, for the bone below it."""
_JOINT = {"f": 0.48, "b": 0.5}
"""Where on the armhole, as a part of its length from the underarm, the raglan line leaves it."""
_BENT_CM = 5.0
"""So far from there it still bends."""
_LIFTED, _MOST_LIFTED = 4.0, 22.0
"""By how many degrees at least and at most the sleeve is cut higher than the arm is held: more is wider."""
_CAP_REACH = 0.8
"""So far along the arm, over its length, the lower curve of a cap goes at most."""
_LEAST_UNDER_CM = 3.0
"""Underarm seam of the shortest sleeves."""
_UNDER = {"f": 0.5, "b": 0.4}
"""How square the sleeve's lower curve meets the underarm."""


@dataclass(frozen=True)
class _Yoke:
    """What is cut off one torso half above the raglan line, as seen from the front."""

    shoulder: Side
    """From its tip to the neckline."""
    neck: Side
    """From there to where the raglan line meets it."""
    line: Side
    """From there to where the raglan line leaves the armhole."""
    underarm: Point
    """Where the armhole begins."""
    down: Point
    """Unit direction of the armhole there, downwards."""
    under: float
    """Length of the armhole below, cm."""


def lay_raglan_sleeve(table: CuttingTable, figure: Figure, shape: Sleeve) -> None:
    """Cuts the left torso along raglan lines, lays the left sleeve with what is cut off, and sews it on.

    What is sewn to the neckline, a collar or a hood, stays sewn to it; so it lies on the table already.

    Edges of ``left_sleeve_f`` and ``left_sleeve_b``: under, hem, top, shoulder, neck, cap.

    Args:
        table: Must already hold the left torso with its shoulder seam, and what is sewn to its neckline.
        figure: Gives the arm's direction and girth.
        shape: Of the sleeve; its cap has no fullness.
    """
    length = max(shape.length - shape.shoulder_extension, LOWEST_CAP + 4.0)
    yokes = {side: _cut_torso(table, side) for side in "fb"}
    tip = yokes["f"].shoulder.start
    frames, cap = _lifted(yokes, figure.arm_angle, figure.upper_arm + shape.arm_ease)
    length = max(length, cap + _LEAST_UNDER_CM)
    halves = {side: _half_width(yoke, side, cap) for side, yoke in frames.items()}
    narrowing = max((sum(halves.values()) - shape.end_width) / 2, 0.0)
    narrowing = -shape.flare / 2 if shape.flare else min(narrowing, min(halves.values()) - 3.0)
    for side, yoke in frames.items():
        half = halves[side]
        outline = Outline(cap, -half).line("under", length, -half + narrowing).line("hem", length, 0.0)
        _draw_over_arm(outline, yoke.shoulder)
        outline.adopt(yoke.neck).follow(yoke.line)
        _draw_lower_cap(outline, yoke, side, cap, half)
        name = f"left_sleeve_{side}"
        place_on_arm(table, figure, name, outline.closed(), tip=tip)
        table.seam(f"left_{side}torso.armhole", f"{name}.cap")
        table.label(f"left_{side}torso.armhole", "left_armhole")
    table.seam("left_sleeve_f.top", "left_sleeve_b.top")
    table.seam("left_sleeve_f.under", "left_sleeve_b.under")


def _cut_torso(table: CuttingTable, side: str) -> _Yoke:
    """Cuts the shoulder off one half of the left torso; its armhole becomes the raglan line, two edges."""
    piece = table.pieces[f"left_{side}torso"]
    step = 1 if side == "f" else -1  # backs run clockwise

    def shoulder_at() -> int:
        return next(k for k, each in enumerate(piece.sides) if each.name == "shoulder")

    k = shoulder_at()
    neck = piece.sides[k + step]
    share = min(NECK_CM[side] / neck.length, 1.0 - _LEAST_NECK)
    table.cut_side(piece, neck, share if side == "f" else 1.0 - share)
    k = shoulder_at()
    shoulder, neck, armhole = (piece.sides[k + j * step] for j in (0, 1, -1))
    if side == "b":
        shoulder, neck, armhole = shoulder.reversed(), neck.reversed(), armhole.reversed()
    under = armhole.split([_JOINT[side]])[0]
    joint, down = under.end, _end_direction(under)
    line = Outline(*neck.end)
    far = math.dist(joint, neck.end)
    straight = (0.6 * neck.end[0] + 0.4 * joint[0], 0.6 * neck.end[1] + 0.4 * joint[1])
    reach = min(_BENT_CM, 0.4 * far)
    line.cubic("cap", straight, (joint[0] - reach * down[0], joint[1] - reach * down[1]), joint)
    cut = line.sides[0].reversed().renamed("armhole")
    own = Side("armhole", cut.start, cut.end, cut.curve)
    piece.sides[k - 1 : k + 2] = [under, own] if side == "f" else [own.reversed(), under.reversed()]
    return _Yoke(shoulder, neck, line.sides[0], under.start, down, under.length)


def _end_direction(side: Side) -> Point:
    """Unit direction at the end of an edge, seen back along it."""
    before, end = curves.evaluate(side.curve, side.chord, np.array([0.999, 1.0]))
    x, y = before - end
    size = math.hypot(x, y)
    return float(x / size), float(y / size)


def _on_arm(yoke: _Yoke, degrees: float) -> _Yoke:
    """What is cut off, from the tip x along an arm that falls by so many degrees, and y across it."""
    angle = math.radians(degrees)
    c, s = math.cos(angle), math.sin(angle)
    tip = yoke.shoulder.start

    def turn(p: Point, origin: Point = tip) -> Point:
        x, y = p[0] - origin[0], p[1] - origin[1]
        return c * x - s * y, s * x + c * y

    def moved(side: Side) -> Side:
        return replace(side, start=turn(side.start), end=turn(side.end))

    return _Yoke(
        moved(yoke.shoulder),
        moved(yoke.neck),
        moved(yoke.line),
        turn(yoke.underarm),
        turn(yoke.down, (0.0, 0.0)),
        yoke.under,
    )


def _lifted(yokes: dict[str, _Yoke], arm_angle: float, width: float) -> tuple[dict[str, _Yoke], float]:
    """What was cut off as the sleeve takes it on, and where along the arm its underarm is, cm.

    The lower end of each cap is that of the armhole, turned over; the higher the sleeve is cut, the wider is
    it there. Where even the lowest is too wide, its underarm moves down.
    """

    def at(lift: float) -> tuple[dict[str, _Yoke], float]:
        frames = {side: _on_arm(yoke, arm_angle - lift) for side, yoke in yokes.items()}
        return frames, _within(frames, sum(map(_turned_over, frames.values())) / len(frames))

    def excess(frames: dict[str, _Yoke], cap: float) -> float:
        return sum(_half_width(yoke, side, cap) for side, yoke in frames.items()) - width

    def short_of(lift: float) -> float:
        return excess(*at(lift))

    if short_of(_MOST_LIFTED) <= 0:
        return at(_MOST_LIFTED)
    if short_of(_LIFTED) < 0:
        return at(find_root(short_of, _LIFTED, _MOST_LIFTED, 1e-3))
    frames, cap = at(_LIFTED)
    lowest = _within(frames, math.inf)
    if excess(frames, lowest) >= 0:
        return frames, lowest
    return frames, find_root(lambda place: excess(frames, place), cap, lowest, 1e-4)


def _within(yokes: dict[str, _Yoke], cap: float) -> float:
    """The nearest place along the arm where both lower curves can reach the underarm."""
    low = max(yoke.line.end[0] - _CAP_REACH * yoke.under for yoke in yokes.values())
    high = min(yoke.line.end[0] + _CAP_REACH * yoke.under for yoke in yokes.values())
    return min(max(cap, low), high)


def _turned_over(yoke: _Yoke) -> float:
    """How far along the arm the underarm of the torso is, turned over the direction of the armhole, cm."""
    (x, y), (u, v) = yoke.line.end, yoke.down
    a, b = yoke.underarm[0] - x, yoke.underarm[1] - y
    return x + 2 * (a * u + b * v) * u - a


def _half_width(yoke: _Yoke, side: str, cap: float) -> float:
    """Half width at which the lower curve of the sleeve is as long as that of the armhole, cm."""
    least = -yoke.line.end[1]

    def excess(half: float) -> float:
        outline = Outline(*yoke.line.end)
        _draw_lower_cap(outline, yoke, side, cap, half)
        return outline.sides[0].length - yoke.under

    return find_root(excess, least + 0.05 * yoke.under, least + 1.05 * yoke.under, 1e-9)


def _draw_lower_cap(outline: Outline, yoke: _Yoke, side: str, cap: float, half: float) -> None:
    """Draws from where the raglan line ends, smoothly on, to the underarm."""
    x, y = yoke.line.end
    reach = 0.4 * math.hypot(cap - x, half + y)
    on = (x + reach * yoke.down[0], y + reach * yoke.down[1])
    outline.cubic("cap", on, (cap, -half + _UNDER[side] * max(half + y, 0.0)), (cap, -half))


def _draw_over_arm(outline: Outline, shoulder: Side) -> None:
    """Draws from the sleeve's end over the shoulder tip to the neckline, rounded at the tip."""
    wrist = outline.sides[-1].end
    neck = shoulder.end
    far = math.hypot(*neck)
    back = (neck[0] / far, neck[1] / far)
    # The bone of the shoulder is turned around half-way between arm and shoulder.
    bisector = (back[0] - 1.0, back[1])
    size = math.hypot(*bisector)
    aside = (bisector[0] / size, bisector[1] / size)
    tip = (0.0, _ROOM_CM)
    near = min(_ROUNDED_CM, 0.4 * far)
    outline.cubic(
        "top",
        (max(wrist[0] - 0.5 * wrist[0], _ROUNDED_CM), wrist[1]),
        (tip[0] - _ROUNDED_CM * aside[0], tip[1] - _ROUNDED_CM * aside[1]),
        tip,
    )
    bent = Outline(*tip)
    onward = (tip[0] + near * aside[0], tip[1] + near * aside[1])
    bent.cubic("shoulder", onward, (neck[0] - 0.4 * neck[0], neck[1] - 0.4 * neck[1]), neck)
    outline.adopt(replace(bent.sides[0], serial=shoulder.serial))
