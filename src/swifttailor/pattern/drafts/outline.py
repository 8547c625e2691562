"""Draws the outline of a panel edge by edge, with a name for every edge."""

from __future__ import annotations

import math
from dataclasses import dataclass, field, replace
from itertools import count

import numpy as np

from swifttailor.arrays import Floats
from swifttailor.pattern import curve as curves
from swifttailor.pattern.curve import Arc, Cubic, Curve, Line, Quadratic, to_relative

Point = tuple[float, float]

_serials = count()


@dataclass(frozen=True)
class Side:
    """One named edge of an outline, from `start` to `end` (local cm)."""

    name: str
    start: Point
    end: Point
    curve: Curve = field(default_factory=Line)
    serial: int = field(default_factory=lambda: next(_serials))
    """Identity of the edge, so that stitches survive splits elsewhere in the loop."""

    @property
    def chord(self) -> Floats:
        """Start and end (2, 2), cm."""
        return np.array([self.start, self.end])

    @property
    def length(self) -> float:
        """Arc length, cm."""
        return curves.length(self.curve, self.chord)

    def reversed(self) -> Side:
        """The same edge travelled the other way, with the same identity."""
        return replace(self, start=self.end, end=self.start, curve=curves.reverse(self.curve))

    def mirrored(self) -> Side:
        """A new edge: this one reflected in the y axis and travelled the other way, so loops stay CCW."""
        (x1, y1), (x2, y2) = self.start, self.end
        curve = curves.reverse(curves.mirror(self.curve))
        return Side(self.name, (-x2, y2), (-x1, y1), curve)

    def renamed(self, name: str) -> Side:
        """The same edge under another name."""
        return replace(self, name=name)

    def split(self, fractions: list[float]) -> list[Side]:
        """New edges of the same name: this one cut at increasing fractions of its length."""
        cuts = curves.parameters_by_length(self.curve, self.chord, fractions)
        pieces: list[Side] = []
        rest, start, done = self.curve, self.start, 0.0
        for t in map(float, cuts):
            first, rest, point = curves.split(rest, [start, self.end], (t - done) / (1 - done))
            middle = (float(point[0]), float(point[1]))
            pieces.append(Side(self.name, start, middle, first))
            start, done = middle, t
        return [*pieces, Side(self.name, start, self.end, rest)]


@dataclass(frozen=True)
class Dart:
    """A dart to put into a seam: a wedge whose two equal legs are sewn together."""

    at: float
    """Distance of the closed dart from the start of the seam line, cm."""
    width: float
    """Opening at the mouth, cm."""
    depth: float
    """Mouth to tip, at right angles to the seam line, cm."""


class Outline:
    """A counter-clockwise outline under construction, in local cm."""

    def __init__(self, x: float, y: float) -> None:
        self.sides: list[Side] = []
        self.darts: list[tuple[int, int]] = []
        """Serials of the two legs of each dart."""
        self._at: Point = (float(x), float(y))

    @property
    def at(self) -> Point:
        """Where it has come to, local cm."""
        return self._at

    def line(self, name: str, x: float, y: float) -> Outline:
        """A straight edge to (x, y)."""
        return self._add(name, (x, y), Line())

    def quadratic(self, name: str, control: Point, end: Point) -> Outline:
        """A quadratic Bezier; `control` in local cm."""
        chord = np.array([self._at, end])
        return self._add(name, end, Quadratic(to_relative(control, chord)))

    def cubic(self, name: str, control_1: Point, control_2: Point, end: Point) -> Outline:
        """A cubic Bezier; control points in local cm."""
        chord = np.array([self._at, end])
        return self._add(name, end, Cubic(to_relative(control_1, chord), to_relative(control_2, chord)))

    def arc(self, name: str, end: Point, radius: float, *, right: bool, large: bool = False) -> Outline:
        """A circular arc of `radius` cm that bulges to the right or the left of travel."""
        return self._add(name, end, Arc(float(radius), large, right))

    def follow(self, side: Side) -> Outline:
        """An edge that was drawn elsewhere and begins where this outline is."""
        assert math.dist(self._at, side.start) < 1e-6, f"the edge begins at {side.start}, not at {self._at}"
        return self._add(side.name, side.end, side.curve)

    def adopt(self, side: Side) -> Outline:
        """An edge of another outline, with its identity: what is sewn to it stays so."""
        assert math.dist(self._at, side.start) < 1e-6, f"the edge begins at {side.start}, not at {self._at}"
        self.sides.append(side)
        self._at = side.end
        return self

    def darted_line(self, name: str, end: Point, darts: list[Dart]) -> Outline:
        """A straight seam line to `end` with darts pointing into the panel.

        The chord is the sewn length plus the widths of the darts; `Dart.at` counts the sewn length.
        """
        start = np.array(self._at)
        along = np.array(end) - start
        along /= math.hypot(*along)
        inward = np.array([-along[1], along[0]])
        opened = 0.0
        for dart in darts:
            mouth = start + (dart.at + opened) * along
            tip = mouth + dart.width / 2 * along + dart.depth * inward
            self.line(name, *mouth).line("dart", *tip)
            self.line("dart", *(mouth + dart.width * along))
            self.darts.append((self.sides[-2].serial, self.sides[-1].serial))
            opened += dart.width
        return self.line(name, *end)

    def dart(self, tip: Point, end: Point) -> Outline:
        """A dart from the current point over `tip` to `end`; both legs must be equally long."""
        self.line("dart", *tip).line("dart", *end)
        self.darts.append((self.sides[-2].serial, self.sides[-1].serial))
        return self

    def both_halves(self) -> Outline:
        """The whole panel of a left half drawn from its lowest corner to the middle line x = 0.

        Edges get ``left_`` and ``right_`` before their names. The outline stays open between the two lowest
        corners, for the hem.
        """
        whole = Outline(*self.sides[0].start)
        twins = {s.serial: s.mirrored() for s in self.sides}
        whole.sides = [s.renamed(f"left_{s.name}") for s in self.sides]
        whole.sides += [twins[s.serial].renamed(f"right_{s.name}") for s in reversed(self.sides)]
        whole.darts = [*self.darts, *((twins[b].serial, twins[a].serial) for a, b in self.darts)]
        whole._at = whole.sides[-1].end
        return whole

    def closed(self) -> Outline:
        """Checks that the outline has come back to its first point, and makes that exact."""
        first, last = self.sides[0].start, self.sides[-1].end
        assert math.dist(first, last) < 1e-6, f"outline open between {last} and {first}"
        self.sides[-1] = replace(self.sides[-1], end=first)
        return self

    def _add(self, name: str, end: Point, curve: Curve) -> Outline:
        end = (float(end[0]), float(end[1]))
        self.sides.append(Side(name, self._at, end, curve))
        self._at = end
        return self


def annular_sector(top: str, inner: float, outer: float, height: float, middle_top: float) -> Outline:
    """A band or skirt piece between two concentric arcs, centred on x = 0, sewn width along the arcs.

    Args:
        top: Name of the upper edge; the others are ``left_side``, ``right_side`` and ``bottom``.
        inner: Length of the upper edge, cm.
        outer: Length of the lower edge, cm; not shorter than the upper one.
        height: Distance between the arcs, cm.
        middle_top: y of the middle of the upper edge, cm.

    Returns:
        The closed outline; a rectangle where both lengths agree.
    """
    if outer - inner < 1e-3 * height:
        half = inner / 2
        outline = Outline(-half, middle_top - height).line("bottom", half, middle_top - height)
        outline.line("left_side", half, middle_top).line(top, -half, middle_top)
        return outline.line("right_side", -half, middle_top - height).closed()
    radius = height * inner / (outer - inner)
    half_angle = inner / (2 * radius)
    center = middle_top + radius
    s, c = math.sin(half_angle), math.cos(half_angle)
    far, large = radius + height, half_angle > math.pi / 2
    outline = Outline(-far * s, center - far * c)
    outline.arc("bottom", (far * s, center - far * c), far, right=True, large=large)
    outline.line("left_side", radius * s, center - radius * c)
    outline.arc(top, (-radius * s, center - radius * c), radius, right=False, large=large)
    return outline.line("right_side", -far * s, center - far * c).closed()
