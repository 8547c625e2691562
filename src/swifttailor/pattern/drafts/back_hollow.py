"""The seam in the middle of the back of close tops and jackets, drawn in at the small of the back.

Sides that bend in leave the back straight from the shoulder blades to the seat, far from the body between.
"""

from __future__ import annotations

from dataclasses import dataclass

from swifttailor.pattern.drafts.outline import Outline, Point

_FROM_CM, _PER_CM, _MOST_CM = 1.0, 1.7, 3.2
"""Sides that bend in by more than the first leave a part of what is more to the back; and at most so much."""
_LEAST_CM = 0.8
_EASE_CM = 3.0
"""Room that stays at the waist, cm around."""
_SEAT_CM = 20.0
"""So far below the waist the seam is straight again, cm."""
_ABOVE_CM, _BELOW_CM = 10.0, 6.0
"""What has less back above the waist, or less below it, keeps a straight middle, cm."""
_REST_CM = 2.0
"""A shorter rest of the seam is no edge of its own."""
_UPPER, _LOWER = 0.4, 0.4
"""Controls of both pieces of the curve as parts of their rise."""


@dataclass(frozen=True)
class BackHollow:
    """How the middle of a half back is drawn in."""

    depth: float
    """At the waist, cm."""
    waist_y: float
    """Height of the waist, cm."""


def back_hollow(waist_y: float, *, shaping: float, room: float) -> BackHollow | None:
    """How the middle of the back of a torso is drawn in; None where its sides shape it enough.

    Args:
        waist_y: Height of the waist, cm.
        shaping: How far each side seam bends inward there, cm.
        room: Girth there over that of the body, before the back is drawn in, cm.
    """
    depth = min(_PER_CM * (shaping - _FROM_CM), (room - _EASE_CM) / 2, _MOST_CM)
    return BackHollow(depth, waist_y) if depth >= _LEAST_CM else None


def draw_centre_back(outline: Outline, low: Point, hollow: BackHollow) -> None:
    """Draws the middle of a half back, from the neckline down to the hem at `low`, upright at the waist."""
    x, top = outline.at
    waist = hollow.waist_y
    if top - waist < _ABOVE_CM or waist - low[1] < _BELOW_CM:
        outline.line("centre", *low)
        return
    seat = waist - _SEAT_CM if waist - _SEAT_CM - low[1] > _REST_CM else low[1]
    above, below = _UPPER * (top - waist), _LOWER * (waist - seat)
    inside = x + hollow.depth
    outline.cubic("centre", (x, top - above), (inside, waist + above), (inside, waist))
    outline.cubic("centre", (inside, waist - below), (x, seat + below), (x, seat))
    if seat != low[1]:
        outline.line("centre", *low)
