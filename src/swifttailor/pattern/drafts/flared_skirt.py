"""Skirts cut from circles, and gathered skirts: an upper edge and a hem, no shaping at the hips."""

from __future__ import annotations

import math
from dataclasses import replace

from swifttailor.pattern.drafts.cutting_table import CuttingTable
from swifttailor.pattern.drafts.figure import Figure, Halves
from swifttailor.pattern.drafts.fitted_skirt import (
    SKIRT_BACK_Z,
    SKIRT_FRONT_Z,
    Overlap,
    lay_overlapping,
    overlapping,
    sew_overlapping_sides,
)
from swifttailor.pattern.drafts.joins import sew_sides
from swifttailor.pattern.drafts.outline import Outline, annular_sector
from swifttailor.pattern.drafts.shaped_hem import LEVEL, HemShape, shaped_sector

SHORTEST_FLOUNCE = 8.0
"""Cm; shorter skirts have less of their close part."""
LOWEST_HEM_BAND = 1.0
"""Cm; skirts with less of a band have none."""
_ROOM_TO_STEP_CM = 6.0
"""Of a band at the hem, on top of the hips, which have to pass through it."""
_EDGE_SHARE, _UNDER_SHARE = 0.8, 0.7
"""Where the edge of a front cut from a circle meets the hem, and how far the other one lies under it there,
over what hangs plumb."""
LARGEST_TURN = 0.93
"""Most of a full turn that one panel may cover."""


def lay_flared_skirt(
    table: CuttingTable,
    waist: Halves,
    length: float,
    top_y: float,
    fraction: float,
    hem: HemShape = LEVEL,
) -> None:
    """Lays ``skirt_front`` and ``skirt_back`` cut from one circle and sews their sides.

    Edges: bottom, left_side, waist, right_side.

    Args:
        table: Where they go.
        waist: Half widths of the upper edge, cm.
        length: Upper edge to hem, cm.
        top_y: World height of the middle of the upper edge, cm.
        fraction: Part of a full circle that both panels make together; 1 is a full circle skirt.
        hem: Its shape.
    """
    radius = waist.girth / (2 * math.pi * fraction)
    for name, half in (("skirt_front", waist.front), ("skirt_back", waist.back)):
        upper = 2 * half
        turn = min(upper / radius / (2 * math.pi), LARGEST_TURN)
        lower = upper + 2 * math.pi * turn * length
        front = name == "skirt_front"
        _lay(table, name, shaped_sector(upper, lower, length, top_y, hem, front=front), front)
    sew_sides(table, "skirt")


def lay_round_wrap_skirt(
    table: CuttingTable, waist: Halves, length: float, top_y: float, fraction: float, overlap: Overlap
) -> None:
    """Lays a skirt cut from a circle whose fronts lie over each other, and sews its sides.

    Its panels have the edges of `lay_fitted_skirt`.

    Args:
        table: Where they go.
        waist: Half widths of the upper edge, cm.
        length: Upper edge to hem, cm.
        top_y: World height of the middle of the upper edge, cm.
        fraction: Part of a full circle that front and back make together.
        overlap: How the fronts lie over each other, where they would hang straight down.
    """
    radius = waist.girth / (2 * math.pi * fraction)
    wider = 1 + length / radius  # edges that hang plumb are as much farther aside at the hem
    shape = replace(
        overlap, edge=overlap.edge * wider * _EDGE_SHARE, under=overlap.under * wider * _UNDER_SHARE
    )
    for half, front in ((waist.front, True), (waist.back, False)):
        outline = _round_half(half, half * wider, length, top_y).both_halves()
        far, (x, y) = radius + length, outline.at
        outline.arc("hem", (-x, y), far, right=True).closed()
        if front:
            lay_overlapping(table, *overlapping(outline, shape))
        else:
            _lay(table, "skirt_back", outline, front)
    sew_overlapping_sides(table)


def _round_half(upper: float, lower: float, length: float, top_y: float) -> Outline:
    """The left half of a skirt piece, from the lower end of its side over its waist to the middle."""
    radius = length * upper / (lower - upper)
    angle, centre = upper / radius, top_y + radius
    ends = [(r * math.sin(angle), centre - r * math.cos(angle)) for r in (radius + length, radius)]
    outline = Outline(*ends[0]).line("side", *ends[1])
    return outline.arc("waist", (0.0, top_y), radius, right=False)


def lay_flounce(table: CuttingTable, length: float, top_y: float, fraction: float) -> None:
    """Lays ``skirt_front_0`` and ``skirt_back_0``, sews their sides, and them to the hems of the skirt above.

    Edges: bottom, left_side, waist, right_side.

    Args:
        table: Where the skirt lies already, its hems called ``hem``.
        length: Seam to hem, cm.
        top_y: World height of the middle of the seam, cm.
        fraction: Part of a full circle that both panels make together.
    """
    halves = {part: table.length(f"skirt_{part}.hem") / 2 for part in ("front", "back")}
    radius = 2 * sum(halves.values()) / (2 * math.pi * fraction)
    for part, half in halves.items():
        outline = annular_sector("waist", 2 * half, 2 * half * (1 + length / radius), length, top_y)
        _lay(table, f"skirt_{part}_0", outline, part == "front")
        table.seam(f"skirt_{part}.hem", f"skirt_{part}_0.waist")
    for side in ("left_side", "right_side"):
        table.seam(f"skirt_front_0.{side}", f"skirt_back_0.{side}")


def lay_gathered_skirt(
    table: CuttingTable, waist: Halves, length: float, top_y: float, fullness: float, flare: float = 0.0
) -> None:
    """Lays two panels, `fullness` times as wide as the waist, and sews their sides.

    Their hems are wider by `flare` cm together. Edges: bottom, left_side, waist, right_side.
    """
    for name, half in (("skirt_front", waist.front), ("skirt_back", waist.back)):
        width = 2 * half * fullness
        outline = annular_sector("waist", width, width + flare / 2, length, top_y)
        _lay(table, name, outline, name == "skirt_front")
    sew_sides(table, "skirt")


def lay_bubble_skirt(
    table: CuttingTable,
    figure: Figure,
    waist: Halves,
    length: float,
    top_y: float,
    fullness: float,
    band: float,
    flare: float = 0.0,
) -> None:
    """Lays a gathered skirt, and below it a band that draws its hem together, so that it puffs out.

    The band's edges are those of a tier: ``skirt_front_0`` and ``skirt_back_0``.

    Args:
        table: Where they go.
        figure: The band is as wide as its hips and some room, and never wider than the skirt.
        waist: Half widths of the upper edge, cm.
        length: Upper edge to hem, cm.
        top_y: World height of the middle of the upper edge, cm.
        fullness: Width over that of the upper edge.
        band: Height of the band, cm; less than `LOWEST_HEM_BAND` is none.
        flare: Width of the hem of a skirt without a band over its gathered edge, cm together.
    """
    height = band if band >= LOWEST_HEM_BAND else 0.0
    lay_gathered_skirt(table, waist, length - height, top_y, fullness, 0.0 if height else flare)
    if not height:
        return
    room = figure.hips.eased(_ROOM_TO_STEP_CM)
    for part, half in (("front", room.front), ("back", room.back)):
        width = min(2 * half, table.length(f"skirt_{part}.bottom"))
        outline = annular_sector("waist", width, width, height, top_y - length + height)
        _lay(table, f"skirt_{part}_0", outline, part == "front")
        table.seam(f"skirt_{part}_0.waist", f"skirt_{part}.bottom", gathered=True)
    for side in ("left_side", "right_side"):
        table.seam(f"skirt_front_0.{side}", f"skirt_back_0.{side}")


def _lay(table: CuttingTable, name: str, outline: Outline, front: bool) -> None:
    at = (0.0, 0.0, SKIRT_FRONT_Z if front else SKIRT_BACK_Z)
    table.lay(name, outline, label="leg", at=at, back=not front)
