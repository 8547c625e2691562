"""The halter: its front rises to the neck and is held by a strap behind it; back and shoulders are bare."""

from __future__ import annotations

from dataclasses import dataclass

from swifttailor.pattern.drafts.bodice import BACK_Z, FRONT_Z, HEM_BALANCE, SIDE_MINIMUM
from swifttailor.pattern.drafts.cutting_table import CuttingTable
from swifttailor.pattern.drafts.figure import Figure
from swifttailor.pattern.drafts.neckline import Neckline, draw_neckline
from swifttailor.pattern.drafts.outline import Outline

FRONT_LIFT = 0.6
"""Part of the front's extra length over the bust that its upper end has."""
STRAP_Z = -14.0
"""Where the strap stands before draping, cm."""
BEHIND_NECK = 1.3
"""Way from the side of the neck to the middle behind it, over half the neck's width."""
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


def lay_halter_bodice(table: CuttingTable, figure: Figure, shape: HalterBodice) -> None:
    """Lays and sews both left halves and half of the strap; call before `CuttingTable.mirror`.

    Edges of ``left_ftorso``: hem, side, armhole, shoulder, neck, centre; of ``left_btorso``: hem, side, top,
    centre; of the strap: lower, centre, upper, end.
    """
    chest = figure.bust.eased(shape.chest_ease)
    hem_y = figure.waist_y - shape.length
    under_y = max(figure.armpit_y - 1.0, hem_y + SIDE_MINIMUM)
    body = figure.girth_below_waist(shape.length).eased(6.0)
    widening = max(body.girth - chest.girth, 0.0) / 4 if shape.length > 0 else 0.0
    widening += shape.flare / 4
    for side, half in (("f", chest.front), ("b", chest.back)):
        front = side == "f"
        drop = HEM_BALANCE * figure.front_fullness if front else 0.0
        outline = Outline(0.0, hem_y - drop)
        outline.quadratic("hem", ((half + widening) * 0.6, hem_y - drop), (half + widening, hem_y + 0.5))
        outline.line("side", half, under_y)
        if front:
            _draw_top(outline, figure, shape, (half, under_y))
        else:
            low = max(under_y - 5.0, hem_y + SIDE_MINIMUM)
            outline.quadratic("top", (0.55 * half, low), (0.0, low))
        outline.line("centre", *outline.sides[0].start).closed()
        z = FRONT_Z if front else BACK_Z
        table.lay(f"left_{side}torso", outline, label="body", at=(0.0, 0.0, z), back=not front)
    table.seam("left_ftorso.side", "left_btorso.side")
    table.label("left_ftorso.neck", "left_collar")
    _lay_strap(table, figure, shape.strap)


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
