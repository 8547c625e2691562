"""Thin straps, and such as cross behind: each is a panel that runs to the other half of the back."""

from __future__ import annotations

from dataclasses import replace

from swifttailor.pattern.drafts.bodice import BACK_Z, BLADE_FULLNESS, sew_torso
from swifttailor.pattern.drafts.cutting_table import CuttingTable
from swifttailor.pattern.drafts.figure import Figure
from swifttailor.pattern.drafts.outline import Outline

TAKEN_IN = 1.5
"""So far the middle of the upper edge is taken in, on either side, cm: it would stand off the chest."""
STRAP_PLACE = 0.36
"""Where the straps lie, as a part of the way from neck to shoulder tip: further out they slide off."""
_ENDS_AT, _NEAREST_CM = 0.75, 1.0
"""Where a strap that crosses ends behind, as a part of how far aside it lies on the shoulder; and how far
from the middle its edge is there at least, cm."""
_APART_Z = 2.5
"""So far behind the other strap does one that crosses it stand before draping, cm."""
_STRAP, _OVER = "left_btorso_strap", "right_btorso_strap"
_END = "strap_end"


def strap_at(figure: Figure, strap: float) -> tuple[float, float]:
    """Distances of both edges of a strap of such a width from the middle, on the shoulder, cm."""
    middle_x = figure.neck_x + STRAP_PLACE * (figure.shoulder_x - figure.neck_x)
    middle_x = min(middle_x, figure.shoulder_x - strap)
    return middle_x - strap / 2, middle_x + strap / 2


def draw_top_below_strap(outline: Outline, figure: Figure, strap: float, base_y: float) -> None:
    """Draws a back from the underarm to the middle, straight across but for where a strap ends.

    Args:
        outline: Ends at the underarm.
        figure: The body.
        strap: Width of the strap, cm.
        base_y: World height of the upper edge, cm.
    """
    inner, outer = _end_at(figure, strap)
    x, y = outline.sides[-1].end
    outline.quadratic("armhole", (outer + 0.35 * (x - outer), y + 0.1), (outer, base_y))
    outline.line(_END, inner, base_y)
    outline.line("neck", min(TAKEN_IN, 0.5 * inner), base_y)


def lay_crossed_strap(table: CuttingTable, figure: Figure, strap: float, base_y: float) -> None:
    """Lays the strap from the left shoulder to the right half of the back; before the mirror.

    Edges: end, armhole, shoulder, neck.
    """
    inner, outer = strap_at(figure, strap)
    near, far = _end_at(figure, strap)
    lift = BLADE_FULLNESS * (figure.neck_y - figure.waist_y)
    outline = Outline(-far, base_y).line("end", -near, base_y)
    outline.line("armhole", outer, figure.shoulder_line(outer) + lift)
    outline.line("shoulder", inner, figure.shoulder_line(inner) + lift).line("neck", -far, base_y)
    table.lay(_STRAP, outline.closed(), label="body", at=(0.0, 0.0, BACK_Z), back=True)


def sew_torso_on_straps(table: CuttingTable, *, crossed: bool) -> None:
    """Sews the left half of what hangs on straps, and labels its edges; before the mirror."""
    if not crossed:
        sew_torso(table)
        return
    table.seam("left_ftorso.side", "left_btorso.side")
    table.seam("left_ftorso.shoulder", f"{_STRAP}.shoulder")
    for panel in ("left_ftorso", "left_btorso", _STRAP):
        table.label(f"{panel}.armhole", "left_armhole")
        table.label(f"{panel}.neck", "left_collar")


def sew_crossed_straps(table: CuttingTable) -> None:
    """Sews straps that cross to the other half of the back, the right one over the left one; mirrored."""
    over = table.pieces[_OVER]
    x, y, z = over.placement.translation
    over.placement = replace(over.placement, translation=(x, y, z - _APART_Z))
    table.seam(f"{_STRAP}.end", f"right_btorso.{_END}")
    table.seam(f"{_OVER}.end", f"left_btorso.{_END}")


def _end_at(figure: Figure, strap: float) -> tuple[float, float]:
    """Distances of both edges of its end behind from the middle, cm."""
    inner, _ = strap_at(figure, strap)
    near = max(_ENDS_AT * inner, _NEAREST_CM)
    return near, near + strap
