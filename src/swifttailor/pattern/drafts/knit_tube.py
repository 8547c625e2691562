"""A tube of knitted cloth around the chest: no darts, it is held up by being smaller than the body."""

from __future__ import annotations

from dataclasses import dataclass

from swifttailor.pattern.drafts.bodice import BACK_Z, FRONT_Z, ribs_at
from swifttailor.pattern.drafts.cutting_table import CuttingTable
from swifttailor.pattern.drafts.figure import Figure
from swifttailor.pattern.drafts.outline import Outline
from swifttailor.pattern.drafts.side_seam import as_long, side_length

_OVER_BUST_CM, _UNDER_ARM_CM = 7.0, 3.0
"""Height of its upper edge over the fullest part of the bust in front; how far below the armpit it is at the
sides and behind, cm."""
_SHORTEST_SIDE_CM = 6.0


@dataclass(frozen=True)
class KnitTube:
    """How it is cut."""

    bust_ease: float
    """On top of the girth of the body, over the body as its cloth is cut for it, cm around."""
    length: float
    """Hem below the waist, cm; negative ends above it."""


def lay_knit_tube(table: CuttingTable, figure: Figure, shape: KnitTube) -> None:
    """Lays and sews both halves of the left side.

    Edges of ``left_ftorso`` and ``left_btorso``: waist, which is the hem, side, top, centre.
    """
    chest = figure.bust.eased(shape.bust_ease)
    top_y = figure.armpit_y - _UNDER_ARM_CM
    hem_y = min(figure.waist_y - shape.length, top_y - _SHORTEST_SIDE_CM)
    below = ribs_at(figure, hem_y).eased(shape.bust_ease)
    length = None
    for side, at_chest, hem_x in (("f", chest.front, below.front), ("b", chest.back, below.back)):
        front = side == "f"
        corner, underarm = (hem_x, hem_y), (at_chest, top_y)
        if length is None:
            length = side_length(corner, underarm, 0.0)
        else:
            corner = as_long(length, corner, underarm, 0.0)
        fullness = figure.front_fullness if front else 0.0
        outline = Outline(0.0, hem_y - fullness).quadratic("waist", (0.6 * hem_x, hem_y - fullness), corner)
        outline.line("side", *underarm)
        middle = max(figure.bust_y + _OVER_BUST_CM, top_y) if front else top_y
        outline.quadratic("top", (0.55 * at_chest, middle), (0.0, middle))
        outline.line("centre", 0.0, hem_y - fullness)
        z = FRONT_Z if front else BACK_Z
        table.lay(f"left_{side}torso", outline.closed(), label="body", at=(0.0, 0.0, z), back=not front)
        table.label(f"left_{side}torso.top", "strapless_top")
    table.seam("left_ftorso.side", "left_btorso.side")
