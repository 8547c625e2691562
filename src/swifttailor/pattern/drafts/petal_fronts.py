"""Fronts of skirts that lie over each other like petals: their edges curve away from the middle."""

from __future__ import annotations

import math

from swifttailor.pattern.drafts.outline import Outline, Point, Side

LEAST_CM = 3.0
"""Lower ones are none, cm."""
_EDGE, _UNDER, _LEAST_UNDER = 0.45, 0.5, 0.15
"""Where the edge of the upper front comes down, and how far the lower one reaches under it, at most and at
least, from the middle, as parts of half the hem."""
_ASIDE = (0.15, 0.4)
"""How far beyond the middle each front's level hem ends, at least and at most, likewise."""
_TALLEST, _LEAST_CURVE = 0.68, 8.0
"""How high the curve of an edge begins, as a part of the height, and at least, cm."""
_LEVEL = 0.3
"""So much of a curve's length still counts as hem."""
_QUARTER = 0.5523
"""Where a cubic has its control points to be a quarter of an ellipse."""
_STEEPEST, _BESIDE_DART = 0.9, 0.4
"""How far aside an edge may run over how far it runs down, and how far from the tips of darts, cm."""


def petal_fronts(front: Outline, at: int, outer: Side, inner: Side, rise: float) -> tuple[Outline, Outline]:
    """The upper and the lower front.

    Args:
        front: Drawn whole; its hem is its last edge.
        at: Number of the edge of the waist at which they are parted.
        outer: What of that edge is the lower front's.
        inner: What of it is the upper front's.
        rise: How high above the hem they part in the middle, cm.
    """
    hem, begins = front.sides[-1], inner.start
    half = abs(hem.end[0])
    height = begins[1] - hem.end[1]
    steepest = max(min([_STEEPEST, *_slopes(front, begins)]), 0.05)
    # The lower front comes to lie under the middle before it begins to curve.
    way = (begins[0] + _LEAST_UNDER * half) / steepest
    curved = max(min(_TALLEST * height, height - way), _LEAST_CURVE)
    under = max(-_UNDER * half, begins[0] - steepest * (height - curved))
    edge = min(max(begins[0], _EDGE * half), 0.8 * half)
    beyond = min(max(_way_to(min(rise / curved, 0.9)) * edge, _ASIDE[0] * half), _ASIDE[1] * half)
    left, right = (hem.split([(x - hem.start[0]) / (hem.end[0] - hem.start[0])]) for x in (beyond, -beyond))
    upper_hem, lower_hem = right[0], left[1]

    upper = Outline(*inner.start)
    upper.darts = front.darts
    upper.sides = [inner, *front.sides[at + 1 : -1], upper_hem]
    turn = (edge, upper_hem.end[1] + curved)
    upper.sides += _curve(upper_hem.end, turn).line("edge", *begins).sides

    lower = Outline(*lower_hem.end)
    lower.sides = [*front.sides[:at], outer]
    turn = (under, lower_hem.start[1] + curved)
    back = [side.reversed() for side in reversed(_curve(lower_hem.start, turn).sides)]
    lower.sides += [*Outline(*outer.end).line("edge", *turn).sides, *back, lower_hem]
    return upper.closed(), lower.closed()


def _way_to(share: float) -> float:
    """How far a quarter of an ellipse goes on level before its middle, over the way from there to its end.

    Args:
        share: Of its height that it has risen in the middle.
    """
    part = math.sqrt(1 - (1 - share) ** 2)
    return part / (1 - part)


def _curve(start: Point, end: Point) -> Outline:
    """From the hem, level, to where an edge runs down, upright; cut where it begins to be steep."""
    (x0, y0), (x1, y1) = start, end
    first = (x0 + _QUARTER * (x1 - x0), y0)
    second = (x1, y1 - _QUARTER * (y1 - y0))
    whole = Outline(*start).cubic("edge", first, second, end)
    whole.sides = whole.sides[0].split([_LEVEL])
    return whole


def _slopes(front: Outline, begins: Point) -> list[float]:
    """How far aside over how far down the darts lie that an edge must not come near."""
    return [
        (begins[0] - x - _BESIDE_DART) / (begins[1] - y)
        for side in front.sides
        if side.name.endswith("_dart")
        for x, y in (side.start, side.end)
        if y < begins[1] - 1.0 and x < begins[0]
    ]
