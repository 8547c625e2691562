"""Skirts shaped by side seams and back darts: pencil, A-line, pegged."""

from __future__ import annotations

import math
from dataclasses import dataclass

from swifttailor.pattern.curve import Arc
from swifttailor.pattern.drafts.cutting_table import CuttingTable
from swifttailor.pattern.drafts.figure import Figure, Halves
from swifttailor.pattern.drafts.joins import sew_sides
from swifttailor.pattern.drafts.outline import Outline, Side
from swifttailor.pattern.drafts.petal_fronts import LEAST_CM, petal_fronts
from swifttailor.pattern.drafts.suppression import dart_places, suppress, waist_darts
from swifttailor.pattern.names import UNDER_FRONT

_BESIDE = 4.0
"""Least of the upper edge and the hem that is left on either side of an overlap, cm."""
_SHORTER_CM, _COVERED_CM, _BEHIND_CM = 4.4, 4.0, 6.0
"""So much higher the hem of the lower one ends, whose free corner sinks and would be seen; from so far under
the edge of the upper one it rises; and so far behind it stands before draping."""
SOFT_CM, FLARED = 6.0, 4.0
"""The curve from waist to hip ends so far below the hips, where it ends on them cloth puckers to a point; and
the flare, degrees, from which it need not."""
_TAKEN_IN = 0.24
"""Hems are narrower than the hips by no more than this part of them: they go around both legs."""
SKIRT_FRONT_Z = 25.0
"""Where front skirt panels stand before draping, cm."""
SKIRT_BACK_Z = -22.0
"""Where back skirt panels stand before draping, cm."""


_LEAST_HIDDEN_CM = 6.0
"""What of the lower one's hem is covered is cut apart from the rest where it is longer than this."""
_STEEPEST, _BESIDE_DART = 0.9, 0.4
"""How far aside an edge may run over how far it runs down, and how far from the tips of darts, cm."""


@dataclass(frozen=True)
class Overlap:
    """Two fronts that are sewn to the waist side by side and lie on each other below."""

    aside: float
    """Where they meet at the waist, from the middle to the wearer's left, cm."""
    edge: float
    """Where the edge of the upper one meets the hem, likewise."""
    under: float
    """By how much further to the wearer's right the lower one reaches there, cm."""
    petals: float = 0.0
    """How high above the hem they part like petals in the middle, cm; then the last two say nothing."""


@dataclass(frozen=True)
class FittedSkirt:
    """How the skirt is cut."""

    length: float
    """From the body's waist to the hem along the middle, cm."""
    hip_ease: float
    """On top of the hip girth, cm around."""
    flare: float
    """Slant of the side seams below the hips, degrees; negative narrows the hem."""
    overlap: Overlap | None = None
    """How its fronts overlap, where there are two."""


def lay_fitted_skirt(
    table: CuttingTable, figure: Figure, shape: FittedSkirt, waist: Halves, top_y: float
) -> None:
    """Lays ``skirt_front`` and ``skirt_back`` and sews their sides.

    Edges: hem, left_side, left_waist, right_waist, right_side, dart.

    Args:
        table: Where they go.
        figure: The body.
        shape: The cut.
        waist: Sewn half widths of the upper edge, cm.
        top_y: World height of the upper edge, cm.
    """
    taken = suppress(figure.hips.eased(shape.hip_ease), waist, 1.0, 3.5)
    hips = taken.wide(waist)
    hem_y = figure.waist_y - shape.length
    rise = min(0.8, 0.25 * max(taken.side, 0.0))
    # Below the hips the side seam is as long as the middle, so its corner lies higher by `lift`.
    slant, below = math.radians(shape.flare), figure.hip_y - hem_y
    narrowest = -min(_TAKEN_IN * hips.girth / 4, min(hips.front, hips.back) - 8.0)
    widening = max(below * math.sin(slant), narrowest)
    slant = math.asin(widening / below)
    lift = below * (1 - math.cos(slant))
    corner_y = hem_y + lift
    places = dart_places(figure, waist)
    for name, hip, narrow, lost, place in (
        ("skirt_front", hips.front, waist.front, taken.front, places.front),
        ("skirt_back", hips.back, waist.back, taken.back, places.back),
    ):
        front = name == "skirt_front"
        corner = hip + widening
        soft_y = figure.hip_y - (min(SOFT_CM, 0.3 * below) if shape.flare < FLARED else 0.0)
        soft_x = hip + widening * (figure.hip_y - soft_y) / below
        outline = Outline(corner, corner_y).line("side", soft_x, soft_y)
        # The waist line is straight and rises a little to the side; its length is what counts.
        side_x = math.sqrt((narrow + lost) ** 2 - rise**2)
        fall = top_y + rise - soft_y
        outline.cubic(
            "side",
            (soft_x - math.tan(slant) * 0.4 * fall, soft_y + 0.4 * fall),
            (side_x + 0.3 * taken.side, top_y + rise - 0.35 * fall),
            (side_x, top_y + rise),
        )
        depth = min(9.5 if front else 13.0, 0.6 * (top_y + rise - figure.hip_y))
        outline.darted_line("waist", (0.0, top_y), waist_darts(narrow, lost, place, depth))
        whole = outline.both_halves()
        _draw_hem(whole, corner, corner_y, slant, lift)
        at = (0.0, 0.0, SKIRT_FRONT_Z if front else SKIRT_BACK_Z)
        if front and shape.overlap is not None:
            upper, lower = overlapping(whole.closed(), shape.overlap)
            lay_overlapping(table, upper, lower)
        else:
            table.lay(name, whole.closed(), label="leg", at=at, back=not front)
    if shape.overlap is None:
        sew_sides(table, "skirt")
    else:
        sew_overlapping_sides(table)


def lay_overlapping(table: CuttingTable, upper: Outline, lower: Outline) -> None:
    """Lays ``skirt_front`` and the front that lies under it."""
    table.lay("skirt_front", upper, label="leg", at=(0.0, 0.0, SKIRT_FRONT_Z))
    table.lay(UNDER_FRONT, lower, label="leg", at=(0.0, 0.0, SKIRT_FRONT_Z - _BEHIND_CM))


def sew_overlapping_sides(table: CuttingTable) -> None:
    """Sews the sides of a skirt with two fronts."""
    table.seam(f"{UNDER_FRONT}.left_side", "skirt_back.left_side")
    table.seam("skirt_front.right_side", "skirt_back.right_side")


_FRONTS = ("skirt_front.right_waist", "skirt_front.left_waist", f"{UNDER_FRONT}.left_waist")
_BACK = ("skirt_back.right_waist", "skirt_back.left_waist")


def sew_overlap_to_band(table: CuttingTable) -> None:
    """Sews a skirt with two fronts to the lower edge of the waistband."""
    table.seam("wb_front.bottom", list(_FRONTS))
    table.seam("wb_back.bottom", list(_BACK[::-1]))


def sew_overlap_to_bodice(table: CuttingTable, upper: str) -> None:
    """Sews it to a bodice of which one front, the ``right``, has all of the waist; labels the edges."""
    for edge in (*_FRONTS, *_BACK):
        table.label(edge, "lower_interface")
    table.seam(list(_FRONTS[::-1]), f"{upper}_ftorso.waist")
    table.seam(list(_BACK), ["right_btorso.waist", "left_btorso.waist"])


def _draw_hem(outline: Outline, corner: float, corner_y: float, slant: float, lift: float) -> None:
    """Closes the outline with a curve that meets both side seams at right angles, `lift` deep."""
    depth = lift / 0.75  # a symmetric cubic reaches three quarters of the way to its control points
    if depth < 1e-3:
        outline.line("hem", corner, corner_y)
        return
    reach = min(depth / math.tan(abs(slant)), 0.6 * corner)
    low = corner_y - depth
    outline.cubic("hem", (reach - corner, low), (corner - reach, low), (corner, corner_y))


def overlapping(front: Outline, shape: Overlap) -> tuple[Outline, Outline]:
    """The upper and the lower front, of one that is drawn whole; its hem is its last edge."""
    hem = front.sides[-1]
    half = abs(hem.end[0])
    at, outer, inner = _parted_at(front, shape.aside)
    if shape.petals >= LEAST_CM:
        return petal_fronts(front, at, outer, inner, shape.petals)
    begins = inner.start
    steepest = [
        (begins[0] - x - _BESIDE_DART) / (begins[1] - y)
        for side in front.sides
        if side.name.endswith("_dart")
        for x, y in (side.start, side.end)
        if y < begins[1] - 1.0 and x < begins[0]
    ]
    leftmost = begins[0] - max(min([_STEEPEST, *steepest]), 0.0) * (begins[1] - hem.end[1])
    edge = min(max(shape.edge, _BESIDE - half, leftmost), half - _BESIDE)
    under = max(edge - shape.under, _BESIDE - half, leftmost)
    upper_hem, lower_hem = (
        hem.split([(x - hem.start[0]) / (hem.end[0] - hem.start[0])])[k] for k, x in ((0, edge), (1, under))
    )
    upper, lower = Outline(*inner.start), Outline(*lower_hem.end)
    upper.darts = front.darts
    upper.sides = [inner, *front.sides[at + 1 : -1], upper_hem]
    upper.sides += Outline(*upper_hem.end).line("edge", *inner.start).sides
    raised = (lower_hem.start[0], lower_hem.start[1] + _SHORTER_CM)
    lower.sides = [*front.sides[:at], outer]
    below = Outline(*outer.end).line("edge", *raised)
    covered, wide = edge - _COVERED_CM - under, lower_hem.end[0] - under
    hidden, seen = lower_hem, []
    if covered > _LEAST_HIDDEN_CM:
        hidden, *seen = lower_hem.split([covered / wide])
    if isinstance(lower_hem.curve, Arc):  # a straight one would cut off much of a skirt cut from a circle
        below.arc("hem", hidden.end, lower_hem.curve.radius, right=True)
    else:
        below.line("hem", *hidden.end)
    lower.sides += [*below.sides, *seen]
    return upper.closed(), lower.closed()


def _parted_at(front: Outline, x: float) -> tuple[int, Side, Side]:
    """Which edge of the left waist is cut at `x`, or near to it where a dart is there, and its two parts."""
    pieces = [(k, s) for k, s in enumerate(front.sides) if s.name == "left_waist"]

    def clear(side: Side) -> float:
        beside = min(_BESIDE, 0.3 * (side.start[0] - side.end[0]))
        return min(max(x, side.end[0] + beside), side.start[0] - beside)

    at, side = min(pieces, key=lambda piece: abs(clear(piece[1]) - x))
    outer, inner = side.split([(side.start[0] - clear(side)) / (side.start[0] - side.end[0])])
    return at, outer, inner
