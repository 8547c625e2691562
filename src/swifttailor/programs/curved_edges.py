"""Arcs and Bezier edges from what they should pass through or how they should leave."""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import lru_cache

import numpy as np
from scipy.optimize import minimize

from swifttailor.arrays import Floats
from swifttailor.programs.design_error import DesignError
from swifttailor.programs.edges import (
    ArcEdge,
    BezierEdge,
    Vertex,
    arc_from_points_radius,
    to_complex,
    to_relative,
)

__all__ = [
    "arc_from_points_angle",
    "arc_from_points_radius",
    "arc_from_rad_length",
    "arc_from_three_points",
    "curve_3_points",
    "curve_from_tangents",
    "vector_angle",
]


def arc_from_points_angle(start: Vertex, end: Vertex, arc_angle: float, right: bool = True) -> ArcEdge:
    """The arc between two vertices that covers an angle in radians; `right` bulges to the right of travel."""
    control_y = math.tan(arc_angle / 4) / 2
    return ArcEdge(start, end, -control_y if right else control_y)


def arc_from_rad_length(
    rad: float, length: float, right: bool = True, start: Vertex | None = None
) -> ArcEdge:
    """The arc of a radius and a length in cm, over new vertices beside the origin or from `start` on."""
    whole = 2 * math.pi * rad
    if length > whole:
        raise DesignError(
            f"An arc of {length:.4g} cm is longer than its circle, {whole:.4g} cm. "
            "Change the parameters that give the length."
        )
    large = length > whole / 2
    half = rad * math.sin((whole - length if large else length) / rad / 2)
    edge = arc_from_points_radius([-half, 0.0], [half, 0.0], rad, large, right)
    if start:
        edge.snap_to(start)
        edge.start = start
    return edge


def arc_from_three_points(
    start: Vertex, end: Vertex, point_on_arc: Sequence[float], relative: bool = False
) -> ArcEdge:
    """The arc between two vertices through a third point, which may be given in the frame of the chord."""
    x, z = to_complex(start), to_complex(end)
    y = to_complex(point_on_arc)
    if relative:
        y = x + y * (z - x)
    w = (z - x) / (y - x)
    if w.imag == 0.0:
        raise DesignError(
            "An arc is drawn through three points in one line; change the parameters of its bend."
        )
    radius = abs((x - y) * (w - abs(w) ** 2) / 2j / w.imag)
    large = abs(y - (x + z) / 2) > radius
    right = ((y - x).conjugate() * (z - x)).imag > 0
    return arc_from_points_radius(start, end, radius, large, right)


def curve_from_tangents(
    start: Vertex,
    end: Vertex,
    target_tan0: Sequence[float] | None = None,
    target_tan1: Sequence[float] | None = None,
    initial_guess: Sequence[float] | None = None,
) -> BezierEdge:
    """The quadratic Bezier edge that leaves and arrives in given directions, either or both.

    With one direction many curves fit, and which is found depends on the guess and on the way of the search:
    it is that of GarmentCode.
    """
    chord = to_complex(end) - to_complex(start)
    tangents = [None if t is None else to_complex(t) / chord for t in (target_tan0, target_tan1)]
    first, last = (None if t is None else _rounded(t / abs(t)) for t in tangents)
    guess = (0.5, 0.0) if initial_guess is None else (float(initial_guess[0]), float(initial_guess[1]))
    return BezierEdge(start, end, [_fit_tangents(first, last, guess)])


def curve_3_points(start: Vertex, end: Vertex, target: Sequence[float]) -> BezierEdge:
    """A quadratic Bezier edge through a point in cm that lies over the chord."""
    aim = to_relative(start, end, to_complex(target))
    if not 0 <= aim.real <= 1:
        raise DesignError(
            f"A curve should pass through ({target[0]:.4g}, {target[1]:.4g}) cm, which does not lie over "
            "the line between its ends. Change the parameters of the curve."
        )
    return BezierEdge(start, end, [_fit_point(_rounded(aim))])


def _rounded(number: complex) -> complex:
    """Without the last digits, so that equal shapes are found once only."""
    return complex(round(number.real, 13), round(number.imag, 13))


@lru_cache(maxsize=4096)
def _fit_tangents(
    first: complex | None, last: complex | None, guess: tuple[float, float]
) -> tuple[float, float]:
    """Control point, in the frame of the chord, whose curve has these unit tangents at its ends."""

    def misfit(control: Floats) -> tuple[float, Floats]:
        p = complex(control[0], control[1])
        value, slope = 0.0, 0j
        for target, way in ((first, p), (last, 1 - p)):
            if target is None:
                continue
            size = abs(way)
            off = way / size - target
            value += abs(off) ** 2
            across = 1j * way / size  # a step across the way turns the tangent, one along it does not
            change = 2 * (off.conjugate() * across).real / size * across
            slope += change if way is p else -change
        return value, np.array([slope.real, slope.imag])

    x, y = minimize(misfit, guess, jac=True, method="BFGS").x.tolist()
    return x, y


@lru_cache(maxsize=4096)
def _fit_point(aim: complex) -> tuple[float, float]:
    """Control point, in the frame of the chord, whose curve passes through a point."""

    def misfit(control: Floats) -> float:
        # The curve at the x of the aim: x(t) = 2 t (1 - t) cx + t^2, y(t) = 2 t (1 - t) cy.
        cx, cy = control.tolist()
        a, b = 1 - 2 * cx, 2 * cx
        if abs(a) < 1e-12:
            t = aim.real / b
        else:
            root = math.sqrt(max(b * b + 4 * a * aim.real, 0.0))
            t = next((r for r in ((-b + root) / (2 * a), (-b - root) / (2 * a)) if 0 <= r <= 1), 0.5)
        return (2 * t * (1 - t) * cy - aim.imag) ** 2

    x, y = minimize(misfit, [aim.real, aim.imag], method="BFGS").x.tolist()
    return x, y


def vector_angle(v1: Sequence[float], v2: Sequence[float]) -> float:
    """Angle in radians from one direction to another, positive to the left."""
    a, b = to_complex(v1), to_complex(v2)
    turned = a.conjugate() * b
    angle = math.acos(max(-1.0, min(1.0, turned.real / (abs(a) * abs(b)))))
    return math.copysign(angle, turned.imag) if abs(turned.imag) > 1e-5 else angle
