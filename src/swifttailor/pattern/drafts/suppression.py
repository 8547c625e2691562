"""How a garment gets from a wide girth to a narrow one: at the side seams and in darts."""

from __future__ import annotations

from dataclasses import dataclass

from swifttailor.pattern.drafts.figure import Figure, Halves
from swifttailor.pattern.drafts.outline import Dart

SMALLEST_DART = 0.8
"""A dart narrower than this is not worth sewing, cm."""
TWO_DARTS = 3.2
"""More than this is divided over two darts, cm."""


@dataclass(frozen=True)
class Suppression:
    """Widths to lose in one half of the body, cm."""

    side: float
    """At the side seam, the same on front and back so that both seams are equally long."""
    front: float
    """In front darts; 0 for none."""
    back: float
    """In back darts; 0 for none."""

    def wide(self, narrow: Halves) -> Halves:
        """The wide halves that belong to the narrow ones; the side seam may have moved a little."""
        return Halves(narrow.front + self.side + self.front, narrow.back + self.side + self.back)


def suppress(wide: Halves, narrow: Halves, side_share: float, side_limit: float) -> Suppression:
    """Distributes the difference of two girths; keeps both girths, moves the side seam for tiny darts.

    Args:
        wide: Halves at bust or hips with ease, cm.
        narrow: Halves at the waist with ease, cm.
        side_share: Part of the smaller of front's and back's difference that the side seam takes.
        side_limit: The side seam takes no more than this on each panel, cm.
    """
    total = (wide.girth - narrow.girth) / 2
    if total < 2 * SMALLEST_DART:
        return Suppression(total / 2, 0.0, 0.0)
    gaps = (wide.front - narrow.front, wide.back - narrow.back)
    side = min(max(side_share * min(gaps), 0.15 * total), side_limit, total / 2)
    rest = total - 2 * side
    front = min(max(gaps[0] - side, 0.0), rest)
    if front < SMALLEST_DART:
        front = 0.0
    back = rest - front
    if back < SMALLEST_DART:
        front, back = (rest, 0.0) if front else (0.0, 0.0)
        side = (total - front) / 2
    return Suppression(side, front, back)


def dart_places(figure: Figure, waist: Halves) -> Halves:
    """How far from the middle the waist darts nearest to it are, along the sewn waist, cm.

    Bodices, skirts and trousers share these places, so that darts meet where they are sewn together.
    """
    front = min(max(figure.bust_x - 0.8, 0.35 * waist.front), 0.6 * waist.front)
    return Halves(front, 0.42 * waist.back)


def waist_darts(sewn: float, lost: float, place: float, depth: float) -> list[Dart]:
    """One or two darts along a half waist that is drawn from the side to the middle.

    Args:
        sewn: Sewn length of the half waist, cm.
        lost: Widths of all its darts together, cm.
        place: Distance of the first dart from the middle, cm; a second one lies between it and the side.
        depth: Length of the first dart, cm.
    """
    if not lost:
        return []
    if lost <= TWO_DARTS:
        return [Dart(sewn - place, lost, depth)]
    return [Dart(0.48 * (sewn - place), 0.46 * lost, 0.82 * depth), Dart(sewn - place, 0.54 * lost, depth)]
