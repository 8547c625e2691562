"""Skirts of several tapered panels: gores."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from swifttailor.pattern.drafts.around_body import around
from swifttailor.pattern.drafts.cutting_table import CuttingTable
from swifttailor.pattern.drafts.figure import Halves
from swifttailor.pattern.drafts.outline import Outline


@dataclass(frozen=True)
class Gores:
    """How the skirt is cut."""

    length: float
    """Upper edge to hem, cm."""
    in_front: int
    """And as many behind."""
    flare: float
    """Width of the hem over that of the hips, cm around."""


def lay_gored_skirt(
    table: CuttingTable, waist: Halves, shape: Gores, top_y: float, *, hips: Halves, to_hips: float
) -> None:
    """Lays the gores ``skirt_panel_0`` ... from the wearer's right to the left, in front and then behind.

    Edges: hem, right, top, left; `sew_gores_to_band` sews the upper ones.

    Args:
        table: Where they go.
        waist: Half widths of the upper edge, cm.
        shape: The cut.
        top_y: World height of the upper edge, cm.
        hips: Half widths that it has there, cm.
        to_hips: Upper edge to the hips, cm.
    """
    count = shape.in_front
    # Front and back widen alike, so that their sides are equally long.
    wider = max(hips.front - waist.front, hips.back - waist.back) / count
    for back, half in ((False, waist.front), (True, waist.back)):
        top = 2 * half / count
        hip = top + 2 * wider
        for k in range(count):
            place = around((k + 0.5) / count)
            at, along = (v * [1.0, -1.0] for v in place) if back else place
            table.lay(
                _name(k, count, back=back),
                _gore(top, hip, hip + shape.flare / (2 * count), shape.length, to_hips),
                label="leg",
                at=(at[0], top_y, at[1]),
                rotation=(0.0, math.degrees(np.arctan2(-along[1], along[0])), 0.0),
                back=back,
            )
        for k in range(count - 1):
            table.seam(f"{_name(k, count, back=back)}.right", f"{_name(k + 1, count, back=back)}.left")
    for k, side in ((0, "left"), (count - 1, "right")):
        table.seam(f"{_name(k, count, back=False)}.{side}", f"{_name(k, count, back=True)}.{side}")


def sew_gores_to_band(table: CuttingTable, in_front: int) -> None:
    """Sews the gores to the lower edge of the waistband."""
    for face in ("front", "back"):
        edges = [f"{_name(k, in_front, back=face == 'back')}.top" for k in range(in_front)]
        table.seam(f"wb_{face}.bottom", edges if face == "front" else edges[::-1])


def _name(k: int, count: int, *, back: bool) -> str:
    return f"skirt_panel_{k + count if back else k}"


def _gore(top: float, hip: float, hem: float, length: float, to_hips: float) -> Outline:
    """One gore, its upper edge around the origin: curved to the hips, straight to a hem that hangs level."""
    below = length - to_hips
    out = (hem - hip) / 2
    side_y = -to_hips - math.sqrt(max(below**2 - out**2, 1.0))
    outline = Outline(-hem / 2, side_y).quadratic("hem", (0.0, -2 * length - side_y), (hem / 2, side_y))
    outline.line("right", hip / 2, -to_hips)
    lean = 0.25 * out / max(below, 1.0) * to_hips
    low, high = (hip / 2 - lean, -0.6 * to_hips), (top / 2 + 0.225 * (hip - top), -0.3 * to_hips)
    outline.cubic("right", low, high, (top / 2, 0.0)).line("top", -top / 2, 0.0)
    outline.cubic("left", (-high[0], high[1]), (-low[0], low[1]), (-hip / 2, -to_hips))
    return outline.line("left", -hem / 2, side_y).closed()
