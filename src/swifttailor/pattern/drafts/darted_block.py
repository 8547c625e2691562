"""What fitted bodices begin with: widths, waist darts, and side seams with a bust dart in front."""

from __future__ import annotations

import math
from dataclasses import dataclass

from swifttailor.pattern.drafts.bust_dart import draw_side_with_bust_dart
from swifttailor.pattern.drafts.figure import Figure, Halves
from swifttailor.pattern.drafts.outline import Dart, Outline
from swifttailor.pattern.drafts.suppression import Suppression, dart_places, suppress

SIDE_MINIMUM = 8.0
"""Shortest side seam, cm."""
_LEANS = 0.6
"""How much of a dart that is laid together is lost at the underarm."""


@dataclass(frozen=True)
class DartedBlock:
    """The widths of a fitted bodice from the underarm to the waist."""

    figure: Figure
    waist: Halves
    """Sewn half widths at the waist, cm."""
    chest: Halves
    """Half widths at the underarm, cm."""
    taken: Suppression
    places: Halves
    """Of the waist darts, from the middle, cm."""
    under_y: float
    """Height of the underarm, cm."""

    @staticmethod
    def of(
        figure: Figure, *, bust_ease: float, waist_ease: float, drop: float, least: float = SIDE_MINIMUM
    ) -> DartedBlock:
        """The block for a body.

        Args:
            figure: Of the body.
            bust_ease: On top of the bust girth, cm around.
            waist_ease: On top of the waist girth, cm around.
            drop: Underarm below the armpit, cm.
            least: Shortest side seam, cm.
        """
        waist = figure.waist.eased(waist_ease)
        taken = suppress(figure.bust.eased(bust_ease), waist, 0.45, 3.0)
        under_y = max(figure.armpit_y - drop, figure.waist_y + least)
        return DartedBlock(figure, waist, taken.wide(waist), taken, dart_places(figure, waist), under_y)

    @staticmethod
    def of_knit(figure: Figure, *, bust_ease: float, waist_ease: float, drop: float) -> DartedBlock:
        """The block of cloth that stretches: no darts, all side seams take the same.

        Args:
            figure: Of the body, as its cloth is cut for it.
            bust_ease: On top of the bust girth, cm around.
            waist_ease: On top of the waist girth, cm around.
            drop: Underarm below the armpit, cm.
        """
        waist, chest = figure.waist.eased(waist_ease), figure.bust.eased(bust_ease)
        side = (chest.girth - waist.girth) / 4
        waist = Halves(chest.front - side, chest.back - side)
        under_y = max(figure.armpit_y - drop, figure.waist_y + SIDE_MINIMUM)
        return DartedBlock(figure, waist, chest, Suppression(side, 0.0, 0.0), waist, under_y)

    def begin_half(self, *, front: bool, bare: bool = False, darted: bool = True) -> Outline:
        """Draws the waist, from the middle outward, and the side seam up to the underarm.

        Of a back that is bare the dart is laid together, as it would end in the neckline: what is beside it
        leans inward from the waist on. Without darts what is too wide is eased in.
        """
        half, narrow, width, place = (
            (self.chest.front, self.waist.front, self.taken.front, self.places.front)
            if front
            else (self.chest.back, self.waist.back, self.taken.back, self.places.back)
        )
        waist_y = self.figure.waist_y
        room = self.under_y - waist_y
        reach = min(self.figure.bust_y - 3.0 - waist_y if front else room - 2.0, room - 1.5)
        darts = [Dart(place, width, max(reach, 5.0))] if width and darted else []
        under_y = self.under_y
        if bare:
            # Its side is as long as it was, as that of the front is.
            rise = math.hypot(half - narrow - width, under_y - waist_y) ** 2
            half, width, darts = half - _LEANS * width, 0.0, []
            under_y = waist_y + math.sqrt(max(rise - (half - narrow) ** 2, 1.0))
        outline = Outline(0.0, waist_y)
        outline.darted_line("waist", (narrow + (width if darted else 0.0), waist_y), darts)
        if front and darted:
            draw_side_with_bust_dart(outline, self.figure, (half, self.under_y))
        else:
            outline.line("side", half, under_y)
        return outline
