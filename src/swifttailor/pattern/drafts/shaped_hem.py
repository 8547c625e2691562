"""Hems of skirts that are not level: longer behind than in front, cut in small arcs, or hanging in points."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from swifttailor.pattern.drafts.outline import Outline, Point, annular_sector

_AT_THE_SIDE = 0.4
"""Part of the dip that the hem has at the side seams."""
_PIECES = 6
"""Curves that a dipped hem is drawn of."""
_STEP = 1e-4


NARROWEST_CM = 2.0
"""Narrower scallops are none."""
LEAST_POINTS_CM = 4.0
"""Lower points are none, cm."""
_POINTS = 3
"""Arcs of a panel between points, which hang down at both side seams and twice between them."""


@dataclass(frozen=True)
class HemShape:
    """How the hem is cut."""

    dip: float = 0.0
    """How much lower the middle of the back is than that of the front, cm."""
    scallop_width: float = 0.0
    """Width of the arcs about, cm; none when 0."""
    scallop_depth: float = 4.0
    """How far the arcs rise between their lowest points, cm."""
    points: float = 0.0
    """How far points hang down below the rest, cm; see `LEAST_POINTS_CM`."""

    @property
    def level(self) -> bool:
        """Whether nothing is to be drawn."""
        return not self.dip and self.scallop_width < NARROWEST_CM and not self.pointed

    @property
    def pointed(self) -> bool:
        """Whether it hangs in points."""
        return not self.dip and self.points >= LEAST_POINTS_CM


LEVEL = HemShape()
"""As most hems are."""


def shaped_sector(
    inner: float, outer: float, height: float, middle_top: float, hem: HemShape, *, front: bool
) -> Outline:
    """An `annular_sector` called ``waist`` above, with such a hem.

    Args:
        inner: Length of the upper edge, cm.
        outer: Length of the lower edge where it is level, cm.
        height: Upper edge to hem in front, cm.
        middle_top: y of the middle of the upper edge, cm.
        hem: Its shape; dips come before points, and those before arcs.
        front: Or back.
    """
    plain = annular_sector("waist", inner, outer, height, middle_top)
    if hem.level:
        return plain
    sides = {side.name: side for side in plain.sides}
    place = _places(inner, outer, height, middle_top)
    level = hem.points if hem.pointed else -hem.scallop_depth
    drop = _dipped(hem.dip, front) if hem.dip else lambda _: level
    outline = Outline(*place(-1.0, drop(-1.0)))
    if hem.dip:
        _draw_curve(outline, lambda u: place(u, drop(u)))
    elif hem.pointed:
        _draw_points(outline, place, hem.points)
    else:
        _draw_arcs(outline, place, max(round(outer / hem.scallop_width), 2), hem.scallop_depth)
    upper = sides["waist"]
    outline.line("left_side", *upper.start)
    outline.follow(upper)
    return outline.line("right_side", *place(-1.0, drop(-1.0))).closed()


def _places(inner: float, outer: float, height: float, middle_top: float) -> Callable[[float, float], Point]:
    """Gives the point at a part of the way from the middle of the hem to its end, so much below the hem."""
    if outer - inner < 1e-3 * height:
        return lambda u, down: (u * inner / 2, middle_top - height - down)
    radius = height * inner / (outer - inner)
    half_angle, center = inner / (2 * radius), middle_top + radius

    def place(u: float, down: float) -> Point:
        far = radius + height + down
        return far * math.sin(u * half_angle), center - far * math.cos(u * half_angle)

    return place


def _dipped(dip: float, front: bool) -> Callable[[float], float]:
    """How much the hem lies lower than in the middle of the front; level there, behind and at the sides."""
    at_side = _AT_THE_SIDE * dip
    middle = 0.0 if front else dip
    return lambda u: at_side + (middle - at_side) * (1 + math.cos(math.pi * u)) / 2


def _draw_curve(outline: Outline, at: Callable[[float], Point]) -> None:
    ends = np.linspace(-1.0, 1.0, _PIECES + 1)
    for low, high in pairwise(ends):
        third = (high - low) / 3
        before, after = (_slope(at, float(u)) for u in (low, high))
        start, end = at(float(low)), at(float(high))
        first = (start[0] + third * before[0], start[1] + third * before[1])
        second = (end[0] - third * after[0], end[1] - third * after[1])
        outline.cubic("bottom", first, second, end)


def _slope(at: Callable[[float], Point], u: float) -> Point:
    low, high = at(u - _STEP), at(u + _STEP)
    return (high[0] - low[0]) / (2 * _STEP), (high[1] - low[1]) / (2 * _STEP)


def _draw_arcs(outline: Outline, place: Callable[[float, float], Point], count: int, depth: float) -> None:
    ends = np.linspace(-1.0, 1.0, count + 1)
    down = depth / 0.75 - depth  # a cubic reaches three quarters of the way to its controls
    for low, high in pairwise(map(float, ends)):
        inset = 0.08 * (high - low)
        outline.cubic("bottom", place(low + inset, down), place(high - inset, down), place(high, -depth))


def _draw_points(outline: Outline, place: Callable[[float, float], Point], depth: float) -> None:
    ends = np.linspace(-1.0, 1.0, _POINTS + 1)
    up = -depth / 3  # as above: in the middle the hem is where a level one would be
    for low, high in pairwise(map(float, ends)):
        inset = 0.3 * (high - low)
        outline.cubic("bottom", place(low + inset, up), place(high - inset, up), place(high, depth))
