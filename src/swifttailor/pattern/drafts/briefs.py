"""The lower end of one-piece garments without legs: cut out over the legs, joined between them by a strip."""

from __future__ import annotations

from dataclasses import dataclass

from swifttailor.pattern.drafts.cutting_table import CuttingTable
from swifttailor.pattern.drafts.figure import Figure, Halves
from swifttailor.pattern.drafts.outline import Outline
from swifttailor.pattern.drafts.trousers import BACK_Z, FRONT_Z, LEGS_APART_X

_STRIP_CM = 3.2
"""Half of the width of the strip between the legs."""
_UNDER_FRONT, _UNDER_BACK = 0.058, 0.095
"""How far front and back reach under the crotch, as a part of the hip girth."""
_SIDE_MINIMUM = 5.0
"""Shortest side seam below the waist, cm."""


@dataclass(frozen=True)
class Briefs:
    """How it is cut."""

    hip_ease: float
    """On top of the hip girth, cm around."""
    leg_height: float
    """Where the side seam ends over the widest part of the hips, cm; more bares more of the leg."""
    crotch_drop: float
    """Below the body's crotch, cm."""
    seat: float = 1.0
    """How much of the seat the back covers; 0 leaves a strip in the middle."""


def lay_briefs(table: CuttingTable, figure: Figure, shape: Briefs, waist: Halves, top_y: float) -> None:
    """Lays the left half and sews its side and the strip; see `sew_legs` for the rest.

    Edges of ``pant_f_l`` and ``pant_b_l``: hem, side, waist, centre, inseam; named as legs, of which there
    are next to none.

    Args:
        table: Where they go.
        figure: The body.
        shape: The cut.
        waist: Sewn half widths of the upper edge, cm.
        top_y: World height of the upper edge, cm.
    """
    hips = figure.hips.eased(shape.hip_ease)
    # Front and back side seams slant alike; what the back has more goes into its middle.
    side = max(min(hips.front - waist.front, hips.back - waist.back), 0.0)
    leg_y = min(figure.hip_y + shape.leg_height, top_y - _SIDE_MINIMUM)
    share = min((top_y - leg_y) / max(top_y - figure.hip_y, 1.0), 1.0)
    for face, half, under in (("f", waist.front, _UNDER_FRONT), ("b", waist.back, _UNDER_BACK)):
        low = figure.crotch_y - shape.crotch_drop - under * figure.hips.girth
        end = (half + share * side, leg_y)
        outline = Outline(_STRIP_CM, low)
        if face == "f":
            outline.cubic("hem", (_STRIP_CM, figure.crotch_y + 3.0), (0.5 * end[0], leg_y - 4.0), end)
        else:
            full, bare = ((_STRIP_CM + 1.0, low + 9.0), (end[0], leg_y - 12.0)), _bared(end, low)
            first, second = [_between(*ends, shape.seat) for ends in zip(bare, full, strict=True)]
            outline.cubic("hem", first, second, end)
        outline.cubic(
            "side",
            (end[0], leg_y + 0.35 * (top_y - leg_y)),
            (half + 0.35 * share * side, top_y - 0.35 * (top_y - leg_y)),
            (half, top_y),
        )
        outline.line("waist", 0.0, top_y).line("centre", 0.0, low).line("inseam", _STRIP_CM, low)
        back = face == "b"
        table.lay(
            f"pant_{face}_l",
            outline.closed(),
            label="leg",
            at=(LEGS_APART_X, 0.0, BACK_Z if back else FRONT_Z),
            back=back,
        )
    table.seam("pant_f_l.side", "pant_b_l.side")
    table.seam("pant_b_l.inseam", "pant_f_l.inseam")


def _bared(end: tuple[float, float], low: float) -> tuple[tuple[float, float], tuple[float, float]]:
    """What draws the edge of the leg near to the middle of the back, up to the hips."""
    return (_STRIP_CM - 1.2, low + 0.55 * (end[1] - low)), (_STRIP_CM - 1.2, end[1] - 1.0)


def _between(bare: tuple[float, float], full: tuple[float, float], share: float) -> tuple[float, float]:
    """A place so far on the way from the first to the second."""
    return bare[0] + share * (full[0] - bare[0]), bare[1] + share * (full[1] - bare[1])
