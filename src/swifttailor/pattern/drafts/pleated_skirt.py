"""Skirts laid in pleats: at the upper edge the cloth of each pleat is sewn to itself."""

from __future__ import annotations

import math

from swifttailor.pattern.drafts.cutting_table import CuttingTable
from swifttailor.pattern.drafts.figure import Halves
from swifttailor.pattern.drafts.fitted_skirt import SKIRT_BACK_Z, SKIRT_FRONT_Z
from swifttailor.pattern.drafts.joins import sew_sides
from swifttailor.pattern.drafts.outline import Outline, Point

SEWN_DOWN = 0.6
"""Depth of the notch in which a pleat is sewn to itself: two edges on one line are no corner, cm."""
STRAIGHT = 0.02
"""Part of a circle; below it a skirt is cut straight, from a circle of so little."""


def lay_pleated_skirt(
    table: CuttingTable,
    waist: Halves,
    length: float,
    top_y: float,
    *,
    pleats: int,
    depth: float,
    fraction: float,
) -> None:
    """Lays two panels whose upper edges are as long as the waist once their pleats are laid.

    Edges: bottom, left_side, waist, dart, right_side.

    Args:
        table: Where they go.
        waist: Half widths of the upper edge, cm.
        length: Upper edge to hem, cm.
        top_y: World height of the middle of the upper edge, cm.
        pleats: How many on each panel.
        depth: Cloth of each pleat that is folded away at the upper edge, cm.
        fraction: Part of a circle that both panels make together; pleats of a circle deepen to the hem.
    """
    for name, half in (("skirt_front", waist.front), ("skirt_back", waist.back)):
        outline = _pleated_panel(2 * half, length, top_y, pleats, depth, max(fraction, STRAIGHT) / 2)
        front = name == "skirt_front"
        at = (0.0, 0.0, SKIRT_FRONT_Z if front else SKIRT_BACK_Z)
        table.lay(name, outline, label="leg", at=at, back=not front)
    sew_sides(table, "skirt")


def _pleated_panel(
    width: float, length: float, top_y: float, pleats: int, depth: float, turn: float
) -> Outline:
    """Draws `turn` of a circle, `width` cm wide at the top once its pleats, `depth` cm each, are laid."""
    # Between pleats runs a chord, half a one at either side; a chord of each pleat is folded away.
    each = width / pleats
    steps = [each / 2, *([depth, each] * (pleats - 1)), depth, each / 2]
    angle = 2 * math.pi * turn
    radius = _radius(steps, angle)
    center = top_y + radius

    def at(a: float, r: float) -> Point:
        return r * math.sin(a), center - r * math.cos(a)

    far = radius + length
    outline = Outline(*at(-angle / 2, far))
    outline.arc("bottom", at(angle / 2, far), far, right=True, large=angle > math.pi)
    outline.line("left_side", *at(angle / 2, radius))
    a = angle / 2
    for k, step in enumerate(steps):
        before, a = a, a - 2 * math.asin(step / (2 * radius))
        if k % 2:
            outline.dart(at((before + a) / 2, radius + SEWN_DOWN), at(a, radius))
        elif k < len(steps) - 1:
            outline.line("waist", *at(a, radius))
        else:
            outline.line("waist", *at(-angle / 2, radius))
    outline.line("right_side", *at(-angle / 2, far))
    return outline.closed()


def _radius(steps: list[float], angle: float) -> float:
    """Of the circle on which chords of these lengths, one after the other, span an angle."""
    low, high = 0.8 * sum(steps) / angle, 1.2 * sum(steps) / angle
    for _ in range(80):
        middle = (low + high) / 2
        spanned = sum(2 * math.asin(min(step / (2 * middle), 1.0)) for step in steps)
        low, high = (middle, high) if spanned > angle else (low, middle)
    return (low + high) / 2
