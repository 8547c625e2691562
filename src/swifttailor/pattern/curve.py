"""Exact geometry of the four edge shapes of a sewing pattern: line, quadratic, cubic, circular arc.

A curve is stored as GarmentCode stores it, without its end points. Bezier control points are relative to
the chord: (0, 0) is the start, (1, 0) the end and +y lies to the left of travel, so that the shape follows
when the end points move. An arc keeps its absolute radius in cm. Every function takes the chord, a
(2, 2) array of start and end in cm; curve parameters run from 0 to 1.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from functools import lru_cache
from itertools import pairwise

import numpy as np
from numpy.typing import ArrayLike

from swifttailor.arrays import Floats, read_only

_GAUSS_POINTS = 8
_LENGTH_TOLERANCE = 1e-13
_MAX_INTERVALS = 4096
_REMEMBERED = 4096
"""Curves whose lengths, samples and polylines are kept: while a pattern is altered and checked, most of its
edges stay as they are and are asked for the same again and again. Chords are told apart by their bytes, since
-0.0 equals 0.0 but may give other points."""


@dataclass(frozen=True)
class Line:
    """A straight edge."""


@dataclass(frozen=True)
class Quadratic:
    """A quadratic Bezier with one chord-relative control point."""

    control: tuple[float, float]


@dataclass(frozen=True)
class Cubic:
    """A cubic Bezier with two chord-relative control points, in travel order."""

    control_1: tuple[float, float]
    control_2: tuple[float, float]


@dataclass(frozen=True)
class Arc:
    """A circular arc of absolute radius.

    ``right`` arcs bulge to the right of travel and run counter-clockwise (y up); ``large`` arcs sweep more
    than half a turn. In SVG terms with y up: ``A radius radius 0 large right``.
    """

    radius: float
    large: bool
    right: bool


Curve = Line | Quadratic | Cubic | Arc
Point = tuple[float, float]


def to_relative(point: ArrayLike, chord: ArrayLike) -> tuple[float, float]:
    """Expresses a point (2,) in cm in the frame of the chord (2, 2)."""
    start, end = np.asarray(chord, float)
    d, v = end - start, np.asarray(point, float) - start
    squared = float(d @ d)
    if squared == 0.0:
        return 0.0, 0.0
    return float(v @ d) / squared, float(d[0] * v[1] - d[1] * v[0]) / squared


def to_absolute(relative: ArrayLike, chord: ArrayLike) -> Floats:
    """Turns chord-relative coordinates (2,) back into cm (2,)."""
    return np.array(_absolute(*np.asarray(relative, float).tolist(), *_ends(chord)))


def control_polygon(curve: Quadratic | Cubic, chord: ArrayLike) -> Floats:
    """Gives the Bezier control points in cm, (3, 2) or (4, 2), end points included."""
    start, end = ends = _ends(chord)
    inner = (curve.control,) if isinstance(curve, Quadratic) else (curve.control_1, curve.control_2)
    return np.array([start, *(_absolute(float(x), float(y), *ends) for x, y in inner), end])


@dataclass(frozen=True)
class ArcGeometry:
    """Centre (2,) in cm, radius in cm, start angle and signed sweep in radians of an arc over its chord."""

    center: Floats
    radius: float
    start_angle: float
    sweep: float


def arc_geometry(arc: Arc, chord: ArrayLike) -> ArcGeometry:
    """Finds the circle of an arc.

    A radius below half the chord cannot span it; it is then taken as half the chord (a semicircle), which
    is also what absorbs rounding in files. `swifttailor.pattern.check_pattern` reports the real cases.
    """
    start, end = np.asarray(chord, float)
    d = end - start
    length = float(np.hypot(*d))
    if length == 0.0:
        return ArcGeometry(start.copy(), arc.radius, 0.0, 0.0)
    radius = max(float(arc.radius), length / 2)
    height = math.sqrt(max(radius * radius - length * length / 4, 0.0))
    left = np.array([-d[1], d[0]]) / length
    side = 1.0 if arc.right != arc.large else -1.0
    center = (start + end) / 2 + side * height * left
    half = math.asin(min(1.0, length / (2 * radius)))
    sweep = 2 * (math.pi - half if arc.large else half)
    offset = start - center
    return ArcGeometry(center, radius, math.atan2(offset[1], offset[0]), sweep if arc.right else -sweep)


def evaluate(curve: Curve, chord: ArrayLike, parameters: ArrayLike) -> Floats:
    """Points (n, 2) in cm at curve parameters (n,); parameters 0 and 1 give the chord's ends exactly."""
    t = np.atleast_1d(np.asarray(parameters, float))[:, None]
    start, end = np.asarray(chord, float)
    if isinstance(curve, Line):
        points = start + (end - start) * t
    elif isinstance(curve, Arc):
        g = arc_geometry(curve, chord)
        angle = g.start_angle + g.sweep * t[:, 0]
        points = g.center + g.radius * np.stack([np.cos(angle), np.sin(angle)], axis=1)
    else:
        points = _bezier(control_polygon(curve, chord), t)
    points[t[:, 0] == 0.0] = start
    points[t[:, 0] == 1.0] = end
    return points


def derivative(curve: Curve, chord: ArrayLike, parameters: ArrayLike) -> Floats:
    """First derivative (n, 2) with respect to the curve parameter, in cm."""
    t = np.atleast_1d(np.asarray(parameters, float))[:, None]
    start, end = np.asarray(chord, float)
    if isinstance(curve, Line):
        return np.repeat((end - start)[None], len(t), axis=0)
    if isinstance(curve, Arc):
        g = arc_geometry(curve, chord)
        angle = g.start_angle + g.sweep * t[:, 0]
        return g.radius * g.sweep * np.stack([-np.sin(angle), np.cos(angle)], axis=1)
    control = control_polygon(curve, chord)
    return _bezier(np.diff(control, axis=0) * (len(control) - 1), t)


def length(curve: Curve, chord: ArrayLike) -> float:
    """True arc length in cm (closed form for lines and arcs, quadrature to 1e-13 for Beziers)."""
    start, end = np.asarray(chord, float)
    if isinstance(curve, Line):
        return float(np.hypot(*(end - start)))
    if isinstance(curve, Arc):
        g = arc_geometry(curve, chord)
        return g.radius * abs(g.sweep)
    return float(_length_table(curve, _bytes(chord))[1][-1])


def parameters_by_length(curve: Curve, chord: ArrayLike, fractions: ArrayLike) -> Floats:
    """Curve parameters (n,) at which the given fractions (n,) of the arc length have been travelled."""
    fractions = np.atleast_1d(np.asarray(fractions, float))
    if isinstance(curve, Line | Arc):
        return fractions.copy()
    knots, table = _length_table(curve, _bytes(chord))
    if table[-1] == 0.0:
        return fractions.copy()
    target = fractions * table[-1]
    t = np.interp(target, table, knots)
    cell = np.clip(np.searchsorted(table, target, side="right") - 1, 0, len(table) - 2)
    low, high = knots[cell], knots[cell + 1]
    control = control_polygon(curve, chord)
    for _ in range(8):  # Newton on the length from the cell's start
        speed = _speed(control, t)
        excess = table[cell] + _interval_lengths(control, low, t) - target
        step = np.divide(excess, speed, out=np.zeros_like(t), where=speed > 1e-12)
        updated = np.clip(t - step, low, high)
        done = bool(np.all(np.abs(updated - t) < 1e-15))
        t = updated
        if done:
            break
    t[fractions == 0.0], t[fractions == 1.0] = 0.0, 1.0
    return t


def sample_by_length(curve: Curve, chord: ArrayLike, count: int) -> Floats:
    """Points (count, 2) in cm, equally spaced by arc length, both ends included."""
    return _sampled(curve, _bytes(chord), count).copy()


def reverse(curve: Curve) -> Curve:
    """The same shape travelled from end to start."""
    if isinstance(curve, Quadratic):
        return Quadratic(_turn(curve.control))
    if isinstance(curve, Cubic):
        return Cubic(_turn(curve.control_2), _turn(curve.control_1))
    return replace(curve, right=not curve.right) if isinstance(curve, Arc) else curve


def mirror(curve: Curve) -> Curve:
    """The shape after its end points have been reflected (x -> -x, or any other mirror line)."""
    if isinstance(curve, Quadratic):
        return Quadratic((curve.control[0], -curve.control[1]))
    if isinstance(curve, Cubic):
        (x1, y1), (x2, y2) = curve.control_1, curve.control_2
        return Cubic((x1, -y1), (x2, -y2))
    return replace(curve, right=not curve.right) if isinstance(curve, Arc) else curve


def scale(curve: Curve, factor: float) -> Curve:
    """The shape after its end points have been scaled by `factor`: only absolute radii change."""
    return replace(curve, radius=curve.radius * factor) if isinstance(curve, Arc) else curve


def split(curve: Curve, chord: ArrayLike, parameter: float) -> tuple[Curve, Curve, Floats]:
    """Cuts a curve at a parameter in (0, 1) into two curves that trace exactly the same points.

    Returns:
        The first and second curve, each relative to its own chord, and the cut point (2,) in cm.
    """
    chord = np.asarray(chord, float)
    point = evaluate(curve, chord, [parameter])[0]
    first, second = np.array([chord[0], point]), np.array([point, chord[1]])
    if isinstance(curve, Line):
        return curve, curve, point
    if isinstance(curve, Arc):
        g = arc_geometry(curve, chord)
        whole = replace(curve, radius=max(g.radius, curve.radius))
        sweep = abs(g.sweep)
        return (
            replace(whole, large=sweep * parameter > math.pi),
            replace(whole, large=sweep * (1 - parameter) > math.pi),
            point,
        )
    left, right = _de_casteljau(control_polygon(curve, chord), parameter)
    return _from_polygon(left, first), _from_polygon(right, second), point


def bounding_box(curve: Curve, chord: ArrayLike) -> Floats:
    """Tight axis-aligned box [[min x, min y], [max x, max y]] in cm, from the exact extrema."""
    chord = np.asarray(chord, float)
    parameters = [0.0, 1.0]
    if isinstance(curve, Arc):
        g = arc_geometry(curve, chord)
        if g.sweep != 0.0:
            quarter_turns = np.arange(-8, 9) * (math.pi / 2)
            candidates = (quarter_turns - g.start_angle) / g.sweep
            parameters += [float(t) for t in candidates if 0.0 < t < 1.0]
    elif not isinstance(curve, Line):
        steps = np.diff(control_polygon(curve, chord), axis=0)
        for axis in (0, 1):
            parameters += _bezier_roots(steps[:, axis])
    points = evaluate(curve, chord, parameters)
    return np.array([points.min(axis=0), points.max(axis=0)])


def flatten(curve: Curve, chord: ArrayLike, tolerance: float) -> Floats:
    """Polyline (n, 2) in cm that stays within `tolerance` cm of the curve, both ends included."""
    if isinstance(curve, Line):
        return np.array(chord, float)
    return _flattened(curve, _bytes(chord), tolerance).copy()


def _turn(point: tuple[float, float]) -> tuple[float, float]:
    return 1.0 - point[0], -point[1]


def _ends(chord: ArrayLike) -> tuple[Point, Point]:
    """Start and end of a chord as plain numbers, which are computed with faster than arrays of two."""
    (x, y), (to_x, to_y) = np.asarray(chord, float).tolist()
    return (x, y), (to_x, to_y)


def _bytes(chord: ArrayLike) -> bytes:
    return np.asarray(chord, float).tobytes()


def _absolute(x: float, y: float, start: Point, end: Point) -> Point:
    along, up = end[0] - start[0], end[1] - start[1]
    return start[0] + x * along + y * -up, start[1] + x * up + y * along


def _bezier(control: Floats, t: Floats) -> Floats:
    """De Casteljau on a stack of parameters (n, 1); returns (n, 2)."""
    s = 1 - t
    layers = list(control)
    while len(layers) > 1:
        layers = [s * a + t * b for a, b in pairwise(layers)]
    return layers[0]


def _de_casteljau(control: Floats, t: float) -> tuple[Floats, Floats]:
    left, right = [control[0]], [control[-1]]
    while len(control) > 1:
        control = (1 - t) * control[:-1] + t * control[1:]
        left.append(control[0])
        right.append(control[-1])
    return np.array(left), np.array(right[::-1])


def _from_polygon(control: Floats, chord: Floats) -> Curve:
    inner = [to_relative(p, chord) for p in control[1:-1]]
    return Quadratic(inner[0]) if len(inner) == 1 else Cubic(inner[0], inner[1])


def _bezier_roots(coefficients: Floats) -> list[float]:
    """Roots in (0, 1) of a Bezier polynomial of degree one or two given by its coefficients."""
    if len(coefficients) == 2:
        start, end = (float(c) for c in coefficients)
        roots = [start / (start - end)] if start != end else []
    else:
        start, middle, end = (float(c) for c in coefficients)
        # a t^2 - 2 h t + start = 0, solved without cancellation, so that a near zero (a cubic that is almost
        # a quadratic) loses no digits.
        a, h = start - 2 * middle + end, start - middle
        discriminant = h * h - a * start
        q = h + math.copysign(math.sqrt(max(discriminant, 0.0)), h)
        roots = [numerator / part for numerator, part in ((q, a), (start, q)) if part != 0.0]
        roots = roots if discriminant >= 0.0 else []
    return [t for t in roots if 0.0 < t < 1.0]


@lru_cache(maxsize=1)
def gauss_rule() -> tuple[Floats, Floats]:
    """Nodes in [0, 1] and weights of the quadrature along a curve."""
    nodes, weights = np.polynomial.legendre.leggauss(_GAUSS_POINTS)
    return read_only((nodes + 1) / 2), read_only(weights / 2)


def _speed(control: Floats, t: Floats) -> Floats:
    return np.hypot(*_bezier(np.diff(control, axis=0) * (len(control) - 1), t[:, None]).T)


def _interval_lengths(control: Floats, low: Floats, high: Floats) -> Floats:
    nodes, weights = gauss_rule()
    t = low[:, None] + (high - low)[:, None] * nodes
    return (_speed(control, t.ravel()).reshape(t.shape) @ weights) * (high - low)


@lru_cache(maxsize=_REMEMBERED)
def _sampled(curve: Curve, ends: bytes, count: int) -> Floats:
    chord = np.frombuffer(ends).reshape(2, 2)
    return evaluate(curve, chord, parameters_by_length(curve, chord, np.linspace(0.0, 1.0, count)))


@lru_cache(maxsize=_REMEMBERED)
def _flattened(curve: Quadratic | Cubic | Arc, ends: bytes, tolerance: float) -> Floats:
    chord = np.frombuffer(ends).reshape(2, 2)
    if isinstance(curve, Arc):
        g = arc_geometry(curve, chord)
        step = 2 * math.acos(max(1 - tolerance / max(g.radius, tolerance), -1.0))
        count = math.ceil(abs(g.sweep) / max(step, 1e-3))
    else:
        control = control_polygon(curve, chord)
        bend = (
            np.abs(np.diff(control, n=2, axis=0)).max(initial=0.0) * (len(control) - 1) * (len(control) - 2)
        )
        count = math.ceil(math.sqrt(bend * math.sqrt(2) / (8 * tolerance)))
    return evaluate(curve, chord, np.linspace(0.0, 1.0, min(max(count, 2), 2000) + 1))


@lru_cache(maxsize=_REMEMBERED)
def _length_table(curve: Quadratic | Cubic, ends: bytes) -> tuple[Floats, Floats]:
    """Parameters and the arc length up to each, refined until the total no longer changes.

    The parameters of least speed are among them: at a cusp the speed has a kink, which quadrature across it
    would not see.
    """
    control = control_polygon(curve, np.frombuffer(ends).reshape(2, 2))
    slowest = _slowest_parameters(control)
    count, previous = 16, -1.0
    while True:
        knots = np.union1d(np.linspace(0.0, 1.0, count + 1), slowest)
        lengths = _interval_lengths(control, knots[:-1], knots[1:])
        total = float(lengths.sum())
        if abs(total - previous) <= _LENGTH_TOLERANCE * max(total, 1e-12) or count >= _MAX_INTERVALS:
            return read_only(knots), read_only(np.concatenate([[0.0], np.cumsum(lengths)]))
        count, previous = count * 2, total


def _slowest_parameters(control: Floats) -> Floats:
    """Parameters in (0, 1) where the speed of a Bezier curve that may have a cusp is stationary."""
    steps = np.diff(control, axis=0)
    size = np.abs(steps).max(initial=0.0)
    if size == 0.0 or np.all(steps @ steps.sum(axis=0) > 0):  # never turns back: no cusp
        return np.zeros(0)
    steps = steps / size
    if len(steps) == 2:
        power = np.array([steps[0], steps[1] - steps[0]])
    else:
        power = np.array([steps[0], 2 * (steps[1] - steps[0]), steps[0] - 2 * steps[1] + steps[2]])
    squared = np.convolve(power[:, 0], power[:, 0]) + np.convolve(power[:, 1], power[:, 1])
    slope = np.polynomial.Polynomial(squared).deriv().trim(1e-12)
    roots = slope.roots() if slope.degree() > 0 else np.zeros(0)
    real = roots.real[np.abs(roots.imag) < 1e-6]
    return real[(real > 0.0) & (real < 1.0)]
