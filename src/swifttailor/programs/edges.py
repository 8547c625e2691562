"""Edges of a panel while it is drafted: straight, Bezier, circular arc.

A vertex is a list of two numbers, in cm. Neighbouring edges share the list itself, so that what moves one end
moves the other; "the same vertex" therefore means the same list, not the same numbers.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import pairwise

from swifttailor.programs.design_error import DesignError
from swifttailor.programs.planar_curves import (
    ArcCurve,
    CubicCurve,
    LineCurve,
    PlanarCurve,
    QuadraticCurve,
    bezier,
    evenly_by_length,
)

Vertex = list[float]


def close_enough(first: float, second: float = 0.0, tolerance: float = 1e-4) -> bool:
    """Whether two numbers differ by less than a tolerance."""
    return abs(first - second) < tolerance


def to_complex(point: Sequence[float]) -> complex:
    """A point of the plane as a complex number."""
    return complex(point[0], point[1])


def to_vertex(point: complex) -> Vertex:
    """A complex number as a new vertex."""
    return [point.real, point.imag]


class Edge:
    """A straight edge between two vertices."""

    def __init__(self, start: Vertex, end: Vertex, label: str = "") -> None:
        """Makes an edge that keeps the given vertices themselves."""
        if close_enough(start[0], end[0]) and close_enough(start[1], end[1]):
            raise DesignError(
                f"An edge would begin and end at ({start[0]:.4g}, {start[1]:.4g}) cm; its ends must differ. "
                "Change the parameters that give it its length."
            )
        self.start = start
        self.end = end
        self.label = label
        self.geometric_id = 0
        """Number of the edge in its panel, known when the panel is assembled."""
        self.flipped = False
        """Whether a copy in an interface runs against the panel's edge."""

    # what it is

    def chord(self) -> complex:
        """The way from start to end."""
        return complex(self.end[0] - self.start[0], self.end[1] - self.start[1])

    def straight_length(self) -> float:
        """Distance between the ends, cm."""
        return math.hypot(self.end[0] - self.start[0], self.end[1] - self.start[1])

    def length(self) -> float:
        """Length along the edge, cm."""
        return self.straight_length()

    def midpoint(self) -> Vertex:
        """The point halfway along the edge."""
        return [(self.start[0] + self.end[0]) / 2, (self.start[1] + self.end[1]) / 2]

    def shortcut(self) -> tuple[Vertex, Vertex]:
        """Copies of start and end."""
        return list(self.start), list(self.end)

    def as_curve(self) -> PlanarCurve:
        """The shape as it is now."""
        return LineCurve(to_complex(self.start), to_complex(self.end))

    def points_inside(self, count: int | None = None) -> list[Vertex]:
        """Points between the ends, equally far along the edge; without a count as many as its bend needs."""
        count = count or 0
        s, d = to_complex(self.start), self.chord()
        return [to_vertex(s + d * k / (count + 1)) for k in range(1, count + 1)]

    # changes in place; all return the edge itself

    def reverse(self) -> Edge:
        """Swaps start and end."""
        self.start, self.end = self.end, self.start
        return self

    def reflect_features(self) -> Edge:
        """Carries the bend to the other side of the chord."""
        return self

    def snap_to(self, start: Sequence[float] = (0.0, 0.0)) -> Edge:
        """Moves the edge until it starts at a point."""
        x, y = start[0] - self.start[0], start[1] - self.start[1]
        self.end[:] = [self.end[0] + x, self.end[1] + y]
        self.start[:] = [start[0], start[1]]
        return self

    def rotate(self, angle: float) -> Edge:
        """Turns the edge about its start, radians."""
        turn = complex(math.cos(angle), math.sin(angle))
        self.end[:] = to_vertex(to_complex(self.start) + self.chord() * turn)
        return self

    # new edges

    def copy_between(self, start: Vertex, end: Vertex) -> Edge:
        """An edge of the same shape over other vertices, which it keeps."""
        other = self.__class__.__new__(self.__class__)
        other.__dict__.update(self.__dict__)
        other.start, other.end = start, end
        return other

    def subdivide_len(self, fractions: Sequence[float]) -> list[Edge]:
        """Edges that lie on this one and have these fractions of its length."""
        return self._subdivide(fractions, by_length=True)

    def subdivide_param(self, fractions: Sequence[float]) -> list[Edge]:
        """Edges that lie on this one and have these fractions of its parameter."""
        return self._subdivide(fractions, by_length=False)

    def _subdivide(self, fractions: Sequence[float], by_length: bool) -> list[Edge]:
        if not close_enough(sum(abs(f) for f in fractions), 1.0):
            raise DesignError(f"An edge is divided into fractions whose sum is 1, got {list(fractions)}.")
        curve = self.as_curve()
        total = curve.length() if by_length else 1.0
        covered, ends = 0.0, [0.0]
        for fraction in fractions:
            covered += fraction
            ends.append(curve.at_length(total * covered) if by_length else covered)
        parts = [edge_from_curve(curve.cropped(a, b)) for a, b in pairwise(ends)]
        parts[0].start, parts[-1].end = self.start, self.end
        for before, after in pairwise(parts):
            after.start = before.end
        return parts


class ArcEdge(Edge):
    """A circular arc through its ends and a third point over the middle of the chord."""

    def __init__(self, start: Vertex, end: Vertex, control_y: float, label: str = "") -> None:
        """Makes an arc; `control_y`: height of the third point, left of travel, in lengths of the chord."""
        super().__init__(start, end, label)
        self.control_y = control_y

    def radius(self) -> float:
        """Radius of the circle, cm."""
        h = abs(self.control_y)
        return (0.25 + h * h) / (2 * h) * self.straight_length() if h else math.inf

    def angle(self) -> float:
        """What of the circle it covers, radians."""
        return 4 * math.atan(2 * abs(self.control_y))

    def length(self) -> float:
        """Length along the edge, cm."""
        return self.radius() * self.angle() if self.control_y else self.straight_length()

    def is_large(self) -> bool:
        """Whether it covers more than half of the circle."""
        return abs(self.control_y) > 0.5

    def midpoint(self) -> Vertex:
        """The point halfway along the edge."""
        return to_vertex(to_complex(self.start) + self.chord() * complex(0.5, self.control_y))

    def as_curve(self) -> PlanarCurve:
        """The shape as it is now."""
        start, end = to_complex(self.start), to_complex(self.end)
        if not self.control_y:
            return LineCurve(start, end)
        return ArcCurve(start, end, self.radius(), self.is_large(), self.control_y < 0)

    def points_inside(self, count: int | None = None) -> list[Vertex]:
        """Points between the ends, equally far along the edge; nine of them without a count."""
        count = 9 if count is None else count
        curve = self.as_curve()
        return [to_vertex(curve.point(k / (count + 1))) for k in range(1, count + 1)]

    def reverse(self) -> ArcEdge:
        """Swaps start and end."""
        self.start, self.end = self.end, self.start
        self.control_y *= -1
        return self

    def reflect_features(self) -> ArcEdge:
        """Carries the bend to the other side of the chord."""
        self.control_y *= -1
        return self


class BezierEdge(Edge):
    """A Bezier curve with one or two control points, in the frame of the chord: start (0, 0), end (1, 0)."""

    def __init__(
        self,
        start: Vertex,
        end: Vertex,
        control_points: Sequence[Sequence[float]],
        relative: bool = True,
        label: str = "",
    ) -> None:
        """Makes a Bezier edge; the control points may be given in cm with ``relative=False``."""
        super().__init__(start, end, label)
        self.controls = tuple(to_complex(c) for c in control_points)
        if not relative:
            self.controls = tuple(to_relative(start, end, c) for c in self.controls)

    @property
    def control_points(self) -> list[Vertex]:
        """The control points in the frame of the chord."""
        return [to_vertex(c) for c in self.controls]

    def length(self) -> float:
        """Length along the edge, cm."""
        return self.as_curve().length()

    def midpoint(self) -> Vertex:
        """The point halfway along the edge."""
        curve = self.as_curve()
        return to_vertex(curve.point(curve.at_length(curve.length() / 2)))

    def as_curve(self) -> QuadraticCurve | CubicCurve:
        """The shape as it is now."""
        start, chord = to_complex(self.start), self.chord()
        return bezier(start, tuple(start + c * chord for c in self.controls), to_complex(self.end))

    def points_inside(self, count: int | None = None) -> list[Vertex]:
        """Points between the ends, equally far along the edge; nine of them without a count."""
        start, chord = to_complex(self.start), self.chord()
        inside = evenly_by_length(self.controls, 9 if count is None else count)
        return [to_vertex(start + p * chord) for p in inside]

    def reverse(self) -> BezierEdge:
        """Swaps start and end."""
        self.start, self.end = self.end, self.start
        self.controls = tuple(1 - c for c in self.controls[::-1])
        return self

    def reflect_features(self) -> BezierEdge:
        """Carries the bend to the other side of the chord."""
        self.controls = tuple(c.conjugate() for c in self.controls)
        return self


def to_relative(start: Sequence[float], end: Sequence[float], point: complex) -> complex:
    """A point in cm in the frame of the chord."""
    return (point - to_complex(start)) / (to_complex(end) - to_complex(start))


def edge_from_curve(curve: PlanarCurve) -> Edge:
    """An edge of the curve's shape, over new vertices."""
    start, end = to_vertex(curve.start), to_vertex(curve.end)
    if isinstance(curve, ArcCurve):
        return arc_from_points_radius(start, end, curve.radius, curve.large, curve.right)
    if isinstance(curve, QuadraticCurve):
        return BezierEdge(start, end, [to_vertex(curve.control)], relative=False)
    if isinstance(curve, CubicCurve):
        inner = [to_vertex(curve.control_1), to_vertex(curve.control_2)]
        return BezierEdge(start, end, inner, relative=False)
    return Edge(start, end)


def arc_from_points_radius(
    start: Vertex, end: Vertex, radius: float, large_arc: bool = False, right: bool = True
) -> ArcEdge:
    """The arc of a radius in cm between two vertices; `right` bulges to the right of travel."""
    chord = math.hypot(end[0] - start[0], end[1] - start[1])
    squared = radius * radius - chord * chord / 4
    if squared <= -1e-3:
        raise DesignError(
            f"An arc of radius {radius:.4g} cm cannot span {chord:.4g} cm; half of that is the least. "
            "Change the parameters that give the width."
        )
    height = 0.0 if close_enough(squared, 0.0, 1e-3) else math.sqrt(squared)
    control_y = (radius + height if large_arc else radius - height) / chord
    return ArcEdge(start, end, -control_y if right else control_y)
