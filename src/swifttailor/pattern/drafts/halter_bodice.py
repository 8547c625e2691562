"""The halter: its front rises to the neck and is held by a strap behind it; back and shoulders are bare."""

from __future__ import annotations

import math
from dataclasses import dataclass

from swifttailor.pattern.drafts import darted_block
from swifttailor.pattern.drafts.bodice import BACK_Z, FRONT_Z, HEM_BALANCE, SIDE_MINIMUM, ribs_at
from swifttailor.pattern.drafts.bust_dart import draw_side_with_bust_dart
from swifttailor.pattern.drafts.cutting_table import CuttingTable
from swifttailor.pattern.drafts.figure import Figure, Halves
from swifttailor.pattern.drafts.neckline import Neckline, draw_neckline
from swifttailor.pattern.drafts.outline import Dart, Outline
from swifttailor.pattern.drafts.side_seam import as_long, runs_back, side_length
from swifttailor.pattern.drafts.suppression import dart_places, suppress

FRONT_LIFT = 0.6
"""Part of the front's extra length over the bust that its upper end has."""
STRAP_Z = -14.0
"""Where the strap stands before draping, cm."""
BEHIND_NECK = 1.3
"""Way from the side of the neck to the middle behind it, over half the neck's width."""
_BARE, _BARE_ABOVE = 8.0, 2.0
"""A back that falls farther is bare, and ends at least so far above the waist, cm."""
_LEANS = 0.6
"""How much of a dart that would end in its edge is lost at the underarm instead."""
_CLOSER = 4.5
"""How much narrower each half of a fitted back is at its upper edge, so that it does not stand off, cm."""
_CLOSER_LOOSE = 2.0
"""The same of a top that hangs."""
_ON_RIBS = 0.4
"""Part of the front's extra length over the bust that what lies on the ribs has at its hem."""
STRAP = "left_btorso_strap"


@dataclass(frozen=True)
class HalterBodice:
    """How the bodice is cut."""

    chest_ease: float
    """On top of the bust girth, cm around."""
    length: float
    """Hem below the waist, cm."""
    strap: float
    """Width of the front where it meets the neck, and of the strap, cm."""
    neckline: Neckline
    """Of the front."""
    flare: float
    """Extra width at the hem, cm around."""
    waist_ease: float | None = None
    """On top of the waist girth where darts shape the bodice and it ends at the waist, cm around."""
    back_fall: float = 5.0
    """How far the back falls from the underarm to its middle, cm."""
    stretches: bool = False
    """Whether it is of cloth that stretches: what ends above the waist is as narrow as the ribs there."""


def lay_halter_bodice(table: CuttingTable, figure: Figure, shape: HalterBodice) -> Halves | None:
    """Lays and sews both left halves and half of the strap; call before `CuttingTable.mirror`.

    Edges of ``left_ftorso``: hem (or waist and dart), side, armhole, shoulder, neck, centre; of
    ``left_btorso``: hem, side, top, centre; of the strap: lower, centre, upper, end.

    Returns:
        The sewn half widths at the waist where it ends there, cm.
    """
    if shape.waist_ease is None:
        _lay_to_hem(table, figure, shape)
        waist = None
    else:
        waist = figure.waist.eased(shape.waist_ease)
        _lay_to_waist(table, figure, shape, waist)
    table.seam("left_ftorso.side", "left_btorso.side")
    table.label("left_ftorso.neck", "left_collar")
    _lay_strap(table, figure, shape.strap)
    return waist


def _lay_to_hem(table: CuttingTable, figure: Figure, shape: HalterBodice) -> None:
    chest = figure.bust.eased(shape.chest_ease)
    hem_y = figure.waist_y - shape.length
    under_y = max(figure.armpit_y - 1.0, hem_y + SIDE_MINIMUM)
    body = figure.girth_below_waist(shape.length).eased(6.0)
    widening = max(body.girth - chest.girth, 0.0) / 4 if shape.length > 0 else 0.0
    hugs = shape.stretches and shape.length < 0
    if hugs:
        body = ribs_at(figure, hem_y).eased(shape.chest_ease)
        widening = (body.girth - chest.girth) / 4
    widening += shape.flare / 4
    behind = runs_back(chest, body, widening, under_y - hem_y) if hugs else 0.0
    front_side = side_length((chest.front + widening - behind, hem_y + 0.5), (chest.front, under_y), 0.0)
    for side, half in (("f", chest.front), ("b", chest.back)):
        front = side == "f"
        drop = HEM_BALANCE * figure.front_fullness if front else 0.0
        drop *= _ON_RIBS if hugs else 1.0
        outline = Outline(0.0, hem_y - drop)
        corner = (half + widening + (-behind if front else behind), hem_y + 0.5)
        if hugs and not front:
            corner = as_long(front_side, corner, (half, under_y), 0.0)
        outline.quadratic("hem", (corner[0] * 0.6, hem_y - drop), corner)
        outline.line("side", half, under_y)
        _lay_half(table, figure, shape, outline, front=front)


def _lay_to_waist(table: CuttingTable, figure: Figure, shape: HalterBodice, waist: Halves) -> None:
    taken = suppress(figure.bust.eased(shape.chest_ease), waist, 0.45, 3.0)
    chest = taken.wide(waist)
    under_y = max(figure.armpit_y - 1.0, figure.waist_y + darted_block.SIDE_MINIMUM)
    room = under_y - figure.waist_y
    places = dart_places(figure, waist)
    for front, half, narrow, lost, place in (
        (True, chest.front, waist.front, taken.front, places.front),
        (False, chest.back, waist.back, taken.back, places.back),
    ):
        # Behind, the dart ends below the low edge.
        reach = (
            min(figure.bust_y - 3.0 - figure.waist_y, room - 1.5) if front else room - shape.back_fall - 1.0
        )
        darts = [Dart(place, lost, max(reach, 2.5))] if lost else []
        under = under_y
        if not front and shape.back_fall > _BARE:  # its side stays as long as that of the front
            long = math.hypot(half - narrow - lost, room) ** 2
            half, lost, darts = half - _LEANS * lost, 0.0, []
            under = figure.waist_y + math.sqrt(max(long - (half - narrow) ** 2, 1.0))
        outline = Outline(0.0, figure.waist_y)
        outline.darted_line("waist", (narrow + lost, figure.waist_y), darts)
        if front:
            draw_side_with_bust_dart(outline, figure, (half, under_y))
        else:
            outline.line("side", half, under)
        _lay_half(table, figure, shape, outline, front=front)


def _lay_half(
    table: CuttingTable, figure: Figure, shape: HalterBodice, outline: Outline, *, front: bool
) -> None:
    """Draws the upper end of a left half from the underarm on, and lays it."""
    half, under_y = outline.sides[-1].end
    foot = outline.sides[0].start
    if front:
        _draw_top(outline, figure, shape, (half, under_y))
    else:
        is_bare = shape.back_fall > _BARE
        low = max(under_y - shape.back_fall, foot[1] + (_BARE_ABOVE if is_bare else SIDE_MINIMUM))
        closer = 0.0 if is_bare else _CLOSER_LOOSE if shape.waist_ease is None else _CLOSER
        outline.quadratic("top", (0.55 * half, low), (closer, low))
    outline.line("centre", *foot).closed()
    name, z = ("left_ftorso", FRONT_Z) if front else ("left_btorso", BACK_Z)
    table.lay(name, outline, label="body", at=(0.0, 0.0, z), back=not front)


def sew_strap(table: CuttingTable) -> None:
    """Sews both halves of the strap together behind the neck."""
    table.seam(f"{STRAP}.centre", f"{STRAP.replace('left_', 'right_')}.centre")


def _draw_top(outline: Outline, figure: Figure, shape: HalterBodice, underarm: tuple[float, float]) -> None:
    half, under_y = underarm
    lift = FRONT_LIFT * figure.front_fullness
    inner = figure.neck_x + shape.neckline.widening
    outer = inner + shape.strap
    high = max(figure.shoulder_line(outer) + lift, under_y + 6.0)
    rise = high - under_y
    outline.cubic(
        "armhole",
        (half - 0.45 * (half - outer), under_y + 1.0),
        (outer, under_y + 0.45 * rise),
        (outer, high),
    )
    top = figure.shoulder_line(inner) + lift
    outline.line("shoulder", inner, max(top, high))
    start = outline.sides[-1].end
    low = outline.sides[0].start[1] + SIDE_MINIMUM
    depth = max(min(shape.neckline.front_depth, start[1] - low), 1.0)
    draw_neckline(outline, start, depth, figure.slope, shape.neckline.shape)


def _lay_strap(table: CuttingTable, figure: Figure, width: float) -> None:
    end = table.length("left_ftorso.shoulder")
    long = BEHIND_NECK * figure.neck_x
    low = figure.neck_y - 0.5 * end
    outline = Outline(0.0, low).line("lower", long, low).line("end", long, low + end)
    outline.line("upper", 0.0, low + end).line("centre", 0.0, low).closed()
    table.lay(STRAP, outline, label="body", at=(0.0, 0.0, STRAP_Z), back=True)
    table.seam("left_ftorso.shoulder", f"{STRAP}.end")
    table.label(f"{STRAP}.upper", "left_collar")
