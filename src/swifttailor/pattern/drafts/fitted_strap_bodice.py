"""The fitted bodice on thin straps: darts as in the fitted block, straight across at the bust."""

from __future__ import annotations

from dataclasses import dataclass

from swifttailor.pattern.drafts.bodice import BACK_Z, FRONT_Z, sew_torso
from swifttailor.pattern.drafts.cutting_table import CuttingTable
from swifttailor.pattern.drafts.figure import Figure, Halves
from swifttailor.pattern.drafts.fitted_bodice import SIDE_MINIMUM, draw_side_with_bust_dart
from swifttailor.pattern.drafts.outline import Dart, Outline
from swifttailor.pattern.drafts.strap_bodice import OVER_BUST, OVER_UNDERARM, STRAP_LIFT, draw_top_on_strap
from swifttailor.pattern.drafts.suppression import dart_places, suppress

LOWEST = 6.0
"""Height of the front's middle over the waist at least, cm."""


@dataclass(frozen=True)
class FittedStrapBodice:
    """How the bodice is cut."""

    strap: float
    """Width of the straps, cm."""
    bust_ease: float
    """On top of the bust girth, cm around."""
    waist_ease: float
    """On top of the waist girth, cm around."""
    dip: float
    """How far the front falls between the straps, cm."""


def lay_fitted_strap_bodice(table: CuttingTable, figure: Figure, shape: FittedStrapBodice) -> Halves:
    """Lays and sews both halves of the left side, down to the waist.

    Edges of ``left_ftorso`` and ``left_btorso``: waist, side, armhole, shoulder, neck, centre, dart.

    Returns:
        The sewn half widths at the waist, cm.
    """
    waist = figure.waist.eased(shape.waist_ease)
    taken = suppress(figure.bust.eased(shape.bust_ease), waist, 0.45, 3.0)
    chest = taken.wide(waist)
    under_y = max(figure.armpit_y - 1.5, figure.waist_y + SIDE_MINIMUM)
    room = under_y - figure.waist_y
    places = dart_places(figure, waist)
    for side in "fb":
        front = side == "f"
        half, narrow, width, place = (
            (chest.front, waist.front, taken.front, places.front)
            if front
            else (chest.back, waist.back, taken.back, places.back)
        )
        reach = min(figure.bust_y - 3.0 - figure.waist_y if front else room - 2.0, room - 1.5)
        darts = [Dart(place, width, max(reach, 5.0))] if width else []
        outline = Outline(0.0, figure.waist_y)
        outline.darted_line("waist", (narrow + width, figure.waist_y), darts)
        if front:
            draw_side_with_bust_dart(outline, figure, (half, under_y))
        else:
            outline.line("side", half, under_y)
        y = outline.sides[-1].end[1]
        base_y = max(figure.bust_y + OVER_BUST if front else under_y + OVER_UNDERARM, y + 0.5)
        low = max(base_y - (shape.dip if front else 0.0), figure.waist_y + LOWEST)
        lift = STRAP_LIFT * figure.front_fullness if front else 0.0
        draw_top_on_strap(outline, figure, shape.strap, base_y=base_y, low=low, lift=lift)
        if front and low > figure.bust_y + 1.0:
            outline.line("centre", 0.0, figure.bust_y)
        outline.line("centre", 0.0, figure.waist_y).closed()
        z = FRONT_Z if front else BACK_Z
        table.lay(f"left_{side}torso", outline, label="body", at=(0.0, 0.0, z), back=not front)
    sew_torso(table)
    return waist
