"""Skirts shaped by side seams and back darts: pencil, A-line, pegged."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from swifttailor.pattern.drafts.cutting_table import CuttingTable
from swifttailor.pattern.drafts.figure import Figure, Halves
from swifttailor.pattern.drafts.joins import sew_sides
from swifttailor.pattern.drafts.outline import Outline
from swifttailor.pattern.drafts.suppression import dart_places, suppress, waist_darts

_UPRIGHT = 0.2
"""How far the left edge of an opening slants outward, as a part of its width."""
_BESIDE = 4.0
"""Least of the hem that is left on either side of an opening, cm."""
SOFT_CM, FLARED = 6.0, 4.0
"""The curve from waist to hip ends so far below the hips, where it ends on them cloth puckers to a point; and
the flare, degrees, from which it need not."""
SKIRT_FRONT_Z = 25.0
"""Where front skirt panels stand before draping, cm."""
SKIRT_BACK_Z = -22.0
"""Where back skirt panels stand before draping, cm."""


@dataclass(frozen=True)
class Opening:
    """A front that is open from the hem up, between a steep edge on the left and a slanted one."""

    height: float
    """Hem to its upper end, cm; less where the skirt is short."""
    width: float
    """Along the hem, cm."""
    aside: float
    """Upper end from the middle to the wearer's left, cm."""


@dataclass(frozen=True)
class FittedSkirt:
    """How the skirt is cut."""

    length: float
    """From the body's waist to the hem along the middle, cm."""
    hip_ease: float
    """On top of the hip girth, cm around."""
    flare: float
    """Slant of the side seams below the hips, degrees; negative narrows the hem."""
    opening: Opening | None = None
    """Where the front is open."""


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
    widening = max(below * math.sin(slant), 8.0 - min(hips.front, hips.back))
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
        if front and shape.opening is not None:
            _cut_open(whole, shape.opening, figure.hip_y - hem_y)
        at = (0.0, 0.0, SKIRT_FRONT_Z if front else SKIRT_BACK_Z)
        table.lay(name, whole.closed(), label="leg", at=at, back=not front)
    sew_sides(table, "skirt")


def _draw_hem(outline: Outline, corner: float, corner_y: float, slant: float, lift: float) -> None:
    """Closes the outline with a curve that meets both side seams at right angles, `lift` deep."""
    depth = lift / 0.75  # a symmetric cubic reaches three quarters of the way to its control points
    if depth < 1e-3:
        outline.line("hem", corner, corner_y)
        return
    reach = min(depth / math.tan(abs(slant)), 0.6 * corner)
    low = corner_y - depth
    outline.cubic("hem", (reach - corner, low), (corner - reach, low), (corner, corner_y))


def _cut_open(outline: Outline, shape: Opening, most: float) -> None:
    """Parts the hem, which is the last edge, and leads it up to the end of the opening and down again."""
    hem = outline.sides.pop()
    height = min(shape.height, most)
    half = abs(hem.end[0])
    left = min(shape.aside + _UPRIGHT * shape.width, half - _BESIDE)
    right = max(left - shape.width, _BESIDE - half)
    points = np.array([hem.start, hem.end])
    shares = [(x - points[0, 0]) / (points[1, 0] - points[0, 0]) for x in (right, left)]
    first, _, last = hem.split(shares)
    top = (min(shape.aside, left - 0.5), hem.end[1] + height)
    # The slanted edge leaves the upper end upright and curves away.
    bend = (top[0] - 0.1 * (top[0] - first.end[0]), first.end[1] + 0.55 * height)
    outline.sides.append(first)
    opened = Outline(*first.end).quadratic("opening", bend, top).line("opening", *last.start)
    outline.sides += [*opened.sides, last]
