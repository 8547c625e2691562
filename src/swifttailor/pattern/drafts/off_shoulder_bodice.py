"""The bodice below the shoulders: the loose block and its sleeves, cut off level around body and arms."""

from __future__ import annotations

import math
from dataclasses import dataclass

from swifttailor.pattern.drafts import darted_block
from swifttailor.pattern.drafts.armholes import armhole
from swifttailor.pattern.drafts.bodice import (
    BACK_Z,
    FRONT_Z,
    HEM_BALANCE,
    SIDE_MINIMUM,
    ribs_at,
    shoulder_tip_x,
)
from swifttailor.pattern.drafts.bust_dart import draw_side_with_bust_dart
from swifttailor.pattern.drafts.cutting_table import CuttingTable
from swifttailor.pattern.drafts.figure import Figure, Halves
from swifttailor.pattern.drafts.neckline import Neckline
from swifttailor.pattern.drafts.outline import Dart, Outline, Side
from swifttailor.pattern.drafts.sleeve import HIGHEST_CAP, Cap, fit_cap, place_on_arm
from swifttailor.pattern.drafts.suppression import dart_places, suppress

SCOOPS = {"f": 0.72, "b": 0.5}
"""How deep the armholes are cut, front and back."""
LEAST_HEAD = 2.5
"""Armhole that remains below the edge, cm."""
_ON_RIBS_CM, _STEEPEST = 5.0, 0.2
"""Room at a hem above the waist, cm around, and the steepest sides that narrow to it."""


@dataclass(frozen=True)
class OffShoulderBodice:
    """How the bodice is cut."""

    chest_ease: float
    """On top of the bust girth, cm around."""
    length: float
    """Hem below the waist, cm."""
    above_underarm: float
    """Height of the upper edge over the underarm, cm."""
    flare: float
    """Extra width at the hem, cm around."""
    sleeve_length: float
    """From the shoulder tip, which is bare, to the end, cm."""
    arm_ease: float
    """On top of the upper arm girth, cm around."""
    sleeve_end: float
    """Width around at the end, cm; never wider than at the underarm."""
    waist_ease: float | None = None
    """On top of the waist girth where darts shape the bodice and it ends at the waist, cm around."""


def lay_off_shoulder_bodice(table: CuttingTable, figure: Figure, shape: OffShoulderBodice) -> Halves | None:
    """Lays and sews both left halves and the left sleeve; call before `CuttingTable.mirror`.

    Edges of ``left_ftorso`` and ``left_btorso``: hem (or waist and dart), side, armhole, neck, centre; of
    ``left_sleeve_f`` and ``left_sleeve_b``: under, hem, top, neck, cap.

    Returns:
        The sewn half widths at the waist where it ends there, cm.
    """
    if shape.waist_ease is None:
        whole, waist = _lay_to_hem(table, figure, shape), None
    else:
        waist = figure.waist.eased(shape.waist_ease)
        whole = _lay_to_waist(table, figure, shape, waist)
    table.seam("left_ftorso.side", "left_btorso.side")
    _lay_sleeve(table, figure, shape, whole)
    return waist


def _lay_to_hem(table: CuttingTable, figure: Figure, shape: OffShoulderBodice) -> dict[str, Side]:
    chest = figure.bust.eased(shape.chest_ease)
    hem_y = figure.waist_y - shape.length
    under_y = max(figure.armpit_y - 1.5, hem_y + SIDE_MINIMUM)
    body = figure.girth_below_waist(shape.length).eased(6.0)
    widening = max(body.girth - chest.girth, 0.0) / 4
    if shape.length <= 0:  # what hangs from the bust would stand off like a bell
        narrower = chest.girth - ribs_at(figure, hem_y).eased(_ON_RIBS_CM).girth
        widening = -min(max(narrower / 4, 0.0), _STEEPEST * (under_y - hem_y))
    widening += shape.flare / 4
    whole = {}
    for side, half in _sides(chest):
        drop = HEM_BALANCE * figure.front_fullness if side == "f" else 0.0
        outline = Outline(0.0, hem_y - drop)
        outline.quadratic("hem", ((half + widening) * 0.6, hem_y - drop), (half + widening, hem_y + 0.5))
        outline.line("side", half, under_y)
        whole[side] = _armhole(figure, half, under_y, side)
        _lay_half(table, shape, outline, whole[side], side)
    return whole


def _lay_to_waist(
    table: CuttingTable, figure: Figure, shape: OffShoulderBodice, waist: Halves
) -> dict[str, Side]:
    taken = suppress(figure.bust.eased(shape.chest_ease), waist, 0.45, 3.0)
    chest = taken.wide(waist)
    under_y = max(figure.armpit_y - 1.5, figure.waist_y + darted_block.SIDE_MINIMUM)
    places = dart_places(figure, waist)
    whole = {}
    for side, half, narrow, lost, place in (
        ("f", chest.front, waist.front, taken.front, places.front),
        ("b", chest.back, waist.back, taken.back, places.back),
    ):
        reach = min(figure.bust_y - 3.0, under_y - 1.5) - figure.waist_y
        outline = Outline(0.0, figure.waist_y)
        darts = [Dart(place, lost, max(reach, 2.5))] if lost else []
        outline.darted_line("waist", (narrow + lost, figure.waist_y), darts)
        if side == "f":
            draw_side_with_bust_dart(outline, figure, (half, under_y))
        else:
            outline.line("side", half, under_y)
        whole[side] = _armhole(figure, *outline.sides[-1].end, side)
        _lay_half(table, shape, outline, whole[side], side)
    return whole


def _sides(chest: Halves) -> tuple[tuple[str, float], tuple[str, float]]:
    return ("f", chest.front), ("b", chest.back)


def _armhole(figure: Figure, half: float, under_y: float, side: str) -> Side:
    """The armhole of the loose block, from the underarm to the shoulder."""
    tip_x = shoulder_tip_x(figure, Neckline(), 0.0)
    outline = Outline(half, under_y - 1.0).line("side", half, under_y)
    armhole(outline, (tip_x, figure.shoulder_line(tip_x)), figure.slope, SCOOPS[side])
    return outline.sides[-1]


def _lay_half(
    table: CuttingTable, shape: OffShoulderBodice, outline: Outline, whole: Side, side: str
) -> None:
    """Draws the upper end of a left half from the underarm on, and lays it."""
    kept = whole.split([_kept(whole, shape)])[0]
    outline.follow(kept)
    outline.line("neck", 0.0, kept.end[1])
    outline.line("centre", *outline.sides[0].start).closed()
    front = side == "f"
    z = FRONT_Z if front else BACK_Z
    table.lay(f"left_{side}torso", outline, label="body", at=(0.0, 0.0, z), back=not front)
    table.label(f"left_{side}torso.armhole", "left_armhole")
    table.label(f"left_{side}torso.neck", "strapless_top")


def _kept(whole: Side, shape: OffShoulderBodice) -> float:
    """The part of the armhole's length that lies below the upper edge."""
    rise = min(shape.above_underarm, 0.7 * (whole.end[1] - whole.start[1]))
    low, high = 0.0, 1.0
    while high - low > 1e-6:
        middle = (low + high) / 2
        at = whole.split([middle])[0].end[1] - whole.start[1]
        low, high = (middle, high) if at < rise else (low, middle)
    return max(low, LEAST_HEAD / whole.length)


def _lay_sleeve(
    table: CuttingTable, figure: Figure, shape: OffShoulderBodice, whole: dict[str, Side]
) -> None:
    width = figure.upper_arm + shape.arm_ease
    cap = fit_cap(whole["f"].length, whole["b"].length, width, HIGHEST_CAP)
    top_y = max(side.split([_kept(side, shape)])[0].end[1] for side in whole.values())
    tip = max((side.end for side in whole.values()), key=lambda end: end[1])
    ridge = (tip[1] - top_y) / math.sin(math.radians(max(figure.arm_angle, 20.0)))
    length = max(shape.sleeve_length, max(ridge, cap.height) + SIDE_MINIMUM)
    narrowing = max((cap.front + cap.back - shape.sleeve_end) / 2, 0.0)
    narrowing = min(narrowing, min(cap.front, cap.back) - 3.0)
    for side in "fb":
        outline = _sleeve(cap, length, narrowing, ridge, table.length(f"left_{side}torso.armhole"), side)
        place_on_arm(table, figure, f"left_sleeve_{side}", outline, tip=tip)
        table.seam(f"left_{side}torso.armhole", f"left_sleeve_{side}.cap", gathered=True)
        table.label(f"left_sleeve_{side}.neck", "strapless_top")
    table.seam("left_sleeve_f.top", "left_sleeve_b.top")
    table.seam("left_sleeve_f.under", "left_sleeve_b.under")


def _sleeve(cap: Cap, length: float, narrowing: float, ridge: float, head: float, side: str) -> Outline:
    """Half a sleeve without the upper part of its cap, `head` cm of which are sewn to the armhole."""
    from swifttailor.pattern.drafts.sleeve import sleeve_outline

    block = sleeve_outline(cap, length, narrowing, front=side == "f")
    curve = next(s for s in block.sides if s.name == "cap")
    kept = curve.split([max(1 - head / curve.length, 0.02)])[1]
    outline = Outline(*kept.end)
    half = cap.front if side == "f" else cap.back
    outline.line("under", length, -half + narrowing).line("hem", length, 0.0).line("top", ridge, 0.0)
    outline.line("neck", *kept.start).follow(kept)
    return outline.closed()
