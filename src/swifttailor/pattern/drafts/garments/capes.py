"""Capes: cloth that falls from the neck over body and arms, open in front or closed, as a poncho is."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Annotated, Literal

from swifttailor.pattern.drafts import declared
from swifttailor.pattern.drafts.bodice import BACK_Z, FRONT_Z, sew_centres
from swifttailor.pattern.drafts.cutting_table import CuttingTable
from swifttailor.pattern.drafts.figure import Figure
from swifttailor.pattern.drafts.hood import Hood, lay_hood, sew_hood
from swifttailor.pattern.drafts.measurements import Measurements
from swifttailor.pattern.drafts.neck_collar import CollarHeight, NeckCollar
from swifttailor.pattern.drafts.neckline import Neckline, draw_neckline
from swifttailor.pattern.drafts.options import Option
from swifttailor.pattern.drafts.outline import Outline
from swifttailor.pattern.pattern import Pattern

_SHOULDER_LIFT_CM = 1.0
"""Room over the shoulder, cm."""
_OPEN_AT_LEAST_CM = 2.0
"""What stays open above the hem, however much of the front is to be closed."""
_FRONT_AT_LEAST_CM = 4.0
"""What is left below the neckline of a short cape, however deep it is to be."""
_OPEN_AT_MOST = 0.6
"""How far the edge of a short cape moves back, as a part of the way to the seam over the arm."""


@dataclass(frozen=True)
class CapeOptions:
    """Options of the cape."""

    length: Annotated[float, Option("Hem below the waist; negative ends above it.", "cm", -20.0, 100.0)] = (
        55.0
    )
    spread: Annotated[
        float,
        Option(
            "How far the seams over the arms fall below the horizontal: less is wider.", "degrees", 25.0, 65.0
        ),
    ] = 45.0
    neck_widening: declared.HighNeckWidening = 1.5
    neck_depth: declared.HighNeckDepth = 8.0
    opening: declared.Opening = 8.0
    closed: Annotated[
        float,
        Option(
            "How much of the front is sewn together below the neck, as by a clasp; never all of it.",
            "cm",
            3.0,
            110.0,
        ),
    ] = 6.0
    front: Annotated[
        Literal["open", "closed"], Option("Closed is a poncho: sewn together from the neck to the hem.")
    ] = "open"
    hood: Annotated[bool, Option("Sew a hood to the neckline.")] = False
    collar: Annotated[
        Literal["none", "shirt", "flat", "standing", "rolled"],
        Option(
            "Collar, where there is no hood: a shirt's, one that lies flat, one that stands, or one that "
            "stands and is turned down over itself."
        ),
    ] = "none"
    collar_width: declared.CollarWidth = 5.5
    collar_height: CollarHeight = 4.0
    hood_height: declared.HoodHeight = 6.0
    hood_depth: declared.HoodDepth = 6.0


def draft_cape(options: CapeOptions, measurements: Measurements) -> Pattern:
    """Drafts the cape for a body: held at the neck, open below or closed."""
    figure, table = Figure.of(measurements), CuttingTable("cape")
    collar = NeckCollar(
        "none" if options.hood else options.collar, options.collar_width, options.collar_height
    )
    neckline = collar.neckline(Neckline("round", options.neck_widening, options.neck_depth, 2.0))
    for face in "fb":
        front = face == "f"
        outline = _half(figure, options, neckline, front=front)
        z = FRONT_Z if front else BACK_Z
        table.lay(f"left_{face}torso", outline, label="body", at=(0.0, 0.0, z), back=not front)
    for edge in ("shoulder", "arm"):
        table.seam(f"left_ftorso.{edge}", f"left_btorso.{edge}")
    for panel in ("left_ftorso", "left_btorso"):
        table.label(f"{panel}.neck", "left_collar")
    if options.hood:
        lay_hood(table, figure, Hood(options.hood_height, options.hood_depth))
    collar.lay(table, figure)
    table.mirror()
    sew_centres(table)
    if options.hood:
        sew_hood(table)
    collar.sew(table)
    return table.finish()


def _half(figure: Figure, options: CapeOptions, neckline: Neckline, *, front: bool) -> Outline:
    """Half of front or back: a sector of a circle around the neck, out to the seam over the arm."""
    hem_y = figure.waist_y - options.length
    neck_x = neckline.start_x(figure)
    neck = (neck_x, figure.shoulder_line(neck_x) + _SHOULDER_LIFT_CM)
    radius = neck[1] - hem_y
    fall = math.radians(options.spread)
    end = (neck[0] + radius * math.cos(fall), neck[1] - radius * math.sin(fall))
    opens = front and options.front == "open"
    middle = (min(options.opening, _OPEN_AT_MOST * end[0]) if opens else 0.0, hem_y)
    outline = Outline(*middle)
    # Both ends of the hem leave at right angles to the seams there.
    reach = 4.0 / 3.0 * math.tan((math.pi / 2 - fall) / 4) * radius
    outline.cubic(
        "hem",
        (neck[0] + reach, hem_y),
        (end[0] - reach * math.sin(fall), end[1] - reach * math.cos(fall)),
        end,
    )
    tip = (figure.shoulder_x + 1.0, figure.shoulder_line(figure.shoulder_x) + _SHOULDER_LIFT_CM)
    slant = figure.slope * (tip[0] - neck[0])
    outline.quadratic("arm", (tip[0] + 0.5 * (tip[0] - neck[0]), tip[1] - 0.5 * slant), tip)
    outline.line("shoulder", *neck)
    depth = (neckline.front_depth if front else neckline.back_depth) - (figure.neck_y - neck[1])
    depth = max(min(depth, radius - _FRONT_AT_LEAST_CM), 0.5)
    draw_neckline(outline, neck, depth, figure.slope, neckline.shape)
    x, y = outline.sides[-1].end
    if opens:
        closed = min(options.closed, y - hem_y - _OPEN_AT_LEAST_CM)
        outline.line("centre", x, y - closed).line("edge", *middle)
    else:
        outline.line("centre", *middle)
    return outline.closed()
