"""The side seam of a loose torso: how far it runs back, how it is bent, how long it is."""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import pairwise

from swifttailor.pattern.drafts.figure import Halves
from swifttailor.pattern.drafts.outline import Outline, Point

SIDE_MINIMUM = 4.0
"""Shortest side seam and shortest centre, cm."""
SHORTEST_SLIT, OPEN_SHARE = 1.0, 0.8
"""What would be open for less is closed, cm; the share of a seam that may be open."""
_BEND = 0.35
"""Controls of a curved seam's pieces as parts of their rise."""
_BEND = 0.35
"""Controls of a curved seam's pieces as parts of their rise."""
_FURTHEST_BACK_CM, _HALVINGS = 3.0, 40
"""So far back may the seam run; and steps until front and back are equally long."""


def runs_back(chest: Halves, body: Halves, widening: float, side: float) -> float:
    """How far the side seam runs back down to the hem, cm, so that front and back have equal room there.

    More of the girth lies in front at the bust and behind at the hips: a back as narrow there as at the chest
    is held up by the seat, and its cloth gathers above.

    Args:
        chest: Half widths at the underarm.
        body: Half widths of the body at the hem.
        widening: How much wider each half is at the hem than at the underarm.
        side: Height of the side seam, cm; of a short one that slants much, both sides could not be as long.
    """
    room = (chest.front - body.front) - (chest.back - body.back)
    furthest = min(_FURTHEST_BACK_CM, side**2 / (8 * max(abs(widening), 1.0)))
    return min(max(room / 2, 0.0), furthest)


def _side(corner: Point, underarm: Point, shaping: float) -> Outline:
    """The side seam alone, up from the hem, bent inward by `shaping` cm."""
    outline = Outline(*corner)
    draw_side(outline, underarm, shaping, 0.0)
    return outline


def side_length(corner: Point, underarm: Point, shaping: float) -> float:
    """Length of the side seam, cm."""
    return sum(side.length for side in _side(corner, underarm, shaping).sides)


def as_long(length: float, corner: Point, underarm: Point, shaping: float) -> Point:
    """The corner at the hem, moved up or down until the side seam has a length, cm."""
    x, y = corner
    low, high = y - length, underarm[1] - 0.5 * SIDE_MINIMUM
    for _ in range(_HALVINGS):
        y = (low + high) / 2
        low, high = (y, high) if side_length((x, y), underarm, shaping) > length else (low, y)
    return x, y


def draw_side(outline: Outline, underarm: Point, shaping: float, slit: float) -> None:
    """Draws the side seam up to the underarm, bent inward by `shaping` cm."""
    x, y = outline.at
    if not shaping:
        share = min(slit / math.dist((x, y), underarm), OPEN_SHARE)
        if slit >= SHORTEST_SLIT:
            outline.line("slit", x + share * (underarm[0] - x), y + share * (underarm[1] - y))
        outline.line("side", *underarm)
        return
    reach = shaping / 0.75  # a symmetric cubic reaches three quarters of the way to its control points
    fall = underarm[1] - y
    outline.cubic(
        "side", (x - reach, y + 0.4 * fall), (underarm[0] - reach, underarm[1] - 0.4 * fall), underarm
    )


def draw_curve(outline: Outline, points: Sequence[Point]) -> None:
    """Draws a side seam through points, from the hem up, upright at each; a single piece is straight."""
    for below, above in pairwise(points):
        _piece(outline, below, above, straight=len(points) == 2)


def curve_as_long(other: Sequence[Point], points: Sequence[Point]) -> list[Point]:
    """The points of one edge of a seam, moved up or down so that each piece is as long as the other edge's.

    Args:
        other: Points of the other edge, from the hem up.
        points: As many, of which the last stays.
    """
    straight = len(points) == 2
    found = [points[-1]]
    for (low, high), (x, _) in zip(reversed(list(pairwise(other))), reversed(points[:-1]), strict=True):
        length, top = _piece_length(low, high, straight), found[0]
        down, up = top[1] - 2.0 * length, top[1] - 1e-3
        for _ in range(_HALVINGS):
            y = (down + up) / 2
            longer = _piece_length((x, y), top, straight) > length
            down, up = (y, up) if longer else (down, y)
        found.insert(0, (x, (down + up) / 2))
    return found


def _piece_length(below: Point, above: Point, straight: bool) -> float:
    outline = Outline(*below)
    _piece(outline, below, above, straight=straight)
    return outline.sides[0].length


def _piece(outline: Outline, below: Point, above: Point, *, straight: bool) -> None:
    if straight:
        outline.line("side", *above)
        return
    bend = _BEND * (above[1] - below[1])
    outline.cubic("side", (below[0], below[1] + bend), (above[0], above[1] - bend), above)
