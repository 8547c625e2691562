"""Darts from the hem of a short jacket: what hangs from the bust is taken in to the waist by them."""

from __future__ import annotations

from dataclasses import dataclass

from swifttailor.pattern.drafts.figure import Figure
from swifttailor.pattern.drafts.outline import Outline, Point

_EASE_CM = 2.0
"""Room at the hem over the body there, cm around."""
_WIDEST = {True: 5.0, False: 4.5}
"""Of a dart in front and behind, cm; wider ones pucker at their tips."""
_LEAST = {True: 2.5, False: 2.0}
"""The same: without one, cloth hangs straight down from the bust, however narrow its hem."""
_BELOW_BUST_CM, _BELOW_UNDERARM_CM = 2.0, 3.0
"""How far below the bust, and behind below the underarm, a dart ends."""
_SHORTEST_CM = 6.0
_ASIDE = 0.46
"""Where a dart of the back is, as a part of the way to the side."""
_FROM_EDGES_CM = 2.0
"""A dart leaves so much hem on both sides."""
_BESIDE_BUST_CM = 2.0
"""A dart in front points no farther beside the bust."""


@dataclass(frozen=True)
class HemDart:
    """A dart that points up from a hem."""

    x: float
    """Of its tip, from the middle, cm."""
    width: float
    """Between its legs at the hem, cm."""
    tip_y: float
    """Height of its tip, cm."""


def darted_half(figure: Figure, length: float, *, front: bool) -> float:
    """The least half width of a hem with a dart before that is sewn, cm.

    Args:
        figure: The body.
        length: Hem below the waist, cm.
        front: Of the front, or of the back.
    """
    body = figure.girth_below_waist(max(length, 0.0)).eased(_EASE_CM)
    return (body.front if front else body.back) + _LEAST[front]


def hem_dart(
    figure: Figure, length: float, hem: tuple[float, float], under_y: float, *, front: bool
) -> HemDart | None:
    """The dart of a half front or back; None where nothing is to be taken in.

    Args:
        figure: The body.
        length: Hem below the waist, cm.
        hem: Where it begins and ends, from the middle, cm.
        under_y: Height of the underarm, cm.
        front: Of the front, or of the back.
    """
    room = hem[1] - darted_half(figure, length, front=front) + _LEAST[front]
    width = min(room, _WIDEST[front])
    tip_y = figure.bust_y - _BELOW_BUST_CM if front else under_y - _BELOW_UNDERARM_CM
    if tip_y - (figure.waist_y - length) < _SHORTEST_CM:
        return None
    x = figure.bust_x if front else _ASIDE * hem[1]
    x = max(x, hem[0] + width / 2 + _FROM_EDGES_CM)
    if front and x > figure.bust_x + _BESIDE_BUST_CM:  # its tip would lie in the bust dart
        return None
    return HemDart(x, width, tip_y) if x + width / 2 + _FROM_EDGES_CM < hem[1] else None


def draw_darted_hem(outline: Outline, corner: Point, dart: HemDart) -> None:
    """Draws a straight hem with a dart up to the side seam.

    Args:
        outline: Has come to the middle of the hem, or to the point of a pointed one.
        corner: Lower end of the side seam.
        dart: To draw.
    """
    (x, y), half = outline.at, dart.width / 2
    middle = max(dart.x, x + half + _FROM_EDGES_CM)
    mouth_y = y + (corner[1] - y) * (middle - x) / (corner[0] - x)
    outline.line("hem", middle - half, mouth_y)
    outline.dart((middle, dart.tip_y), (middle + half, mouth_y)).line("hem", *corner)
