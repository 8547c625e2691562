"""Curves of the drafting plane, its points as complex numbers: what edges ask about their own shape.

Drafting moves single points; on so few numbers Python's complex arithmetic is ten times as fast as arrays.
"""

from __future__ import annotations

import cmath
import math
from dataclasses import dataclass
from functools import lru_cache

import numpy as np

_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(16)
_CELLS = np.linspace(0.0, 1.0, 5)
_AT = (_CELLS[:-1, None] + (_NODES + 1) / 8).ravel()
_WEIGHT = np.tile(_WEIGHTS / 8, 4)
_LENGTH_TOLERANCE = 1e-11


class _Curve:
    """A curve from t = 0 to t = 1."""

    def point(self, t: float) -> complex:
        """The point at a parameter."""
        raise NotImplementedError

    def derivative(self, t: float) -> complex:
        """Speed and direction at a parameter."""
        raise NotImplementedError

    def length(self, t0: float = 0.0, t1: float = 1.0) -> float:
        """Arc length between two parameters, cm."""
        raise NotImplementedError

    def cropped(self, t0: float, t1: float) -> PlanarCurve:
        """The part between two parameters."""
        raise NotImplementedError

    def crossings(self, first: complex, second: complex) -> list[float]:
        """Parameters at which the curve meets the straight line between two points, in order."""
        raise NotImplementedError

    def unit_tangent(self, t: float) -> complex:
        """Direction at a parameter."""
        speed = self.derivative(t)
        return speed / abs(speed)

    def at_length(self, length: float) -> float:
        """The parameter at which that much of the arc length lies behind."""
        total = self.length()
        if length <= 0:
            return 0.0
        if length >= total:
            return 1.0
        low, high, t = 0.0, 1.0, length / total
        for _ in range(60):
            excess = self.length(0.0, t) - length
            if abs(excess) < _LENGTH_TOLERANCE * max(total, 1.0):
                break
            low, high = (low, t) if excess > 0 else (t, high)
            speed = abs(self.derivative(t))
            step = t - excess / speed if speed > 0 else -1.0
            t = step if low < step < high else (low + high) / 2
        return t


@dataclass(frozen=True, slots=True)
class LineCurve(_Curve):
    """A straight line."""

    start: complex
    end: complex

    def point(self, t: float) -> complex:
        """The point at a parameter."""
        return self.start + t * (self.end - self.start)

    def derivative(self, t: float) -> complex:
        """The chord."""
        return self.end - self.start

    def length(self, t0: float = 0.0, t1: float = 1.0) -> float:
        """Distance between two parameters, cm."""
        return abs(self.end - self.start) * (t1 - t0)

    def at_length(self, length: float) -> float:
        """The parameter at which that much of the length lies behind."""
        return min(max(length / self.length(), 0.0), 1.0)

    def cropped(self, t0: float, t1: float) -> LineCurve:
        """The part between two parameters."""
        return LineCurve(self.point(t0), self.point(t1))

    def crossings(self, first: complex, second: complex) -> list[float]:
        """Parameter at which it meets the straight line between two points, if it does."""
        return _on_segment(self, [self.start, self.end - self.start], first, second)


@dataclass(frozen=True, slots=True)
class QuadraticCurve(_Curve):
    """A Bezier curve with one control point."""

    start: complex
    control: complex
    end: complex

    def point(self, t: float) -> complex:
        """The point at a parameter."""
        u = 1 - t
        return u * u * self.start + 2 * u * t * self.control + t * t * self.end

    def derivative(self, t: float) -> complex:
        """Speed and direction at a parameter."""
        return 2 * ((1 - t) * (self.control - self.start) + t * (self.end - self.control))

    def length(self, t0: float = 0.0, t1: float = 1.0) -> float:
        """Arc length between two parameters, cm, in closed form."""
        a = 2 * (self.start - 2 * self.control + self.end)  # the derivative is a t + b
        b = 2 * (self.control - self.start)
        size = abs(a)
        if size < 1e-12 * max(abs(b), 1e-12):
            return abs(b) * (t1 - t0)
        along = (a.real * b.real + a.imag * b.imag) / (size * size)
        across = ((a.real * b.imag - a.imag * b.real) / (size * size)) ** 2

        def primitive(t: float) -> float:  # of sqrt(u^2 + across) with u = t + along
            u = t + along
            bent = across * math.asinh(u / math.sqrt(across)) if across > 1e-300 else 0.0
            return u * math.sqrt(u * u + across) + bent

        return size * (primitive(t1) - primitive(t0)) / 2

    def cropped(self, t0: float, t1: float) -> QuadraticCurve:
        """The part between two parameters."""
        start, end = self.point(t0), self.point(t1)
        return QuadraticCurve(start, start + self.derivative(t0) * (t1 - t0) / 2, end)

    def crossings(self, first: complex, second: complex) -> list[float]:
        """Parameters at which it meets the straight line between two points, in order."""
        terms = [self.start, 2 * (self.control - self.start), self.start - 2 * self.control + self.end]
        return _on_segment(self, terms, first, second)


@dataclass(frozen=True, slots=True)
class CubicCurve(_Curve):
    """A Bezier curve with two control points."""

    start: complex
    control_1: complex
    control_2: complex
    end: complex

    def point(self, t: float) -> complex:
        """The point at a parameter."""
        u = 1 - t
        inner = 3 * u * t * (u * self.control_1 + t * self.control_2)
        return u * u * u * self.start + inner + t * t * t * self.end

    def derivative(self, t: float) -> complex:
        """Speed and direction at a parameter."""
        u = 1 - t
        first, second, third = self._steps()
        return 3 * (u * u * first + 2 * u * t * second + t * t * third)

    def length(self, t0: float = 0.0, t1: float = 1.0) -> float:
        """Arc length between two parameters, cm, by Gauss and Legendre's rule."""
        t = t0 + (t1 - t0) * _AT
        u = 1 - t
        first, second, third = self._steps()
        speed = np.abs(first * (u * u) + (2 * second) * (u * t) + third * (t * t))
        return 3 * float(speed @ _WEIGHT) * (t1 - t0)

    def cropped(self, t0: float, t1: float) -> CubicCurve:
        """The part between two parameters."""
        start, end, third = self.point(t0), self.point(t1), (t1 - t0) / 3
        return CubicCurve(start, start + self.derivative(t0) * third, end - self.derivative(t1) * third, end)

    def crossings(self, first: complex, second: complex) -> list[float]:
        """Parameters at which it meets the straight line between two points, in order."""
        one, two, three = self._steps()
        terms = [self.start, 3 * one, 3 * (two - one), three - 2 * two + one]
        return _on_segment(self, terms, first, second)

    def _steps(self) -> tuple[complex, complex, complex]:
        return self.control_1 - self.start, self.control_2 - self.control_1, self.end - self.control_2


@dataclass(frozen=True, slots=True)
class ArcCurve(_Curve):
    """A circular arc; ``right`` arcs bulge to the right of travel and run counter-clockwise."""

    start: complex
    end: complex
    radius: float
    large: bool
    right: bool

    def circle(self) -> tuple[complex, float, complex, float]:
        """Centre, radius, the way from the centre to the start, and the signed sweep in radians."""
        chord = self.end - self.start
        half = abs(chord) / 2
        radius = max(self.radius, half)
        height = math.sqrt(max(radius * radius - half * half, 0.0))
        side = 1.0 if self.right != self.large else -1.0
        center = (self.start + self.end) / 2 + side * height * 1j * chord / (2 * half)
        sweep = 2 * math.asin(min(half / radius, 1.0))
        sweep = 2 * math.pi - sweep if self.large else sweep
        return center, radius, self.start - center, sweep if self.right else -sweep

    def point(self, t: float) -> complex:
        """The point at a parameter."""
        center, _, spoke, sweep = self.circle()
        return center + spoke * cmath.exp(1j * sweep * t)

    def derivative(self, t: float) -> complex:
        """Speed and direction at a parameter."""
        _, _, spoke, sweep = self.circle()
        return spoke * 1j * sweep * cmath.exp(1j * sweep * t)

    def length(self, t0: float = 0.0, t1: float = 1.0) -> float:
        """Arc length between two parameters, cm."""
        _, radius, _, sweep = self.circle()
        return radius * abs(sweep) * (t1 - t0)

    def at_length(self, length: float) -> float:
        """The parameter at which that much of the arc length lies behind."""
        return min(max(length / self.length(), 0.0), 1.0)

    def cropped(self, t0: float, t1: float) -> ArcCurve:
        """The part between two parameters."""
        _, radius, _, sweep = self.circle()
        return ArcCurve(self.point(t0), self.point(t1), radius, abs(sweep) * (t1 - t0) > math.pi, self.right)

    def crossings(self, first: complex, second: complex) -> list[float]:
        """Parameters at which it meets the straight line between two points, in order."""
        center, radius, spoke, sweep = self.circle()
        line = second - first
        a = abs(line) ** 2
        b = 2 * ((first - center) * line.conjugate()).real
        c = abs(first - center) ** 2 - radius * radius
        under = b * b - 4 * a * c
        if under < 0:
            return []
        found = []
        for sign in (-1.0, 1.0):
            along = (-b + sign * math.sqrt(under)) / (2 * a)
            if not 0 <= along <= 1:
                continue
            turn = cmath.phase((first + along * line - center) / spoke)
            for whole in (-2 * math.pi, 0.0, 2 * math.pi):
                t = (turn + whole) / sweep
                if -1e-9 <= t <= 1 + 1e-9:
                    found.append(min(max(t, 0.0), 1.0))
        return sorted(set(found))


PlanarCurve = LineCurve | QuadraticCurve | CubicCurve | ArcCurve


def _on_segment(curve: _Curve, terms: list[complex], first: complex, second: complex) -> list[float]:
    """Parameters in [0, 1] at which sum(terms[k] t^k) lies on the straight line between two points."""
    line = second - first
    turned = [(term * line.conjugate()).imag for term in terms]
    turned[0] -= (first * line.conjugate()).imag
    found = []
    for root in np.roots(turned[::-1]):
        if abs(root.imag) > 1e-7:
            continue
        t = float(root.real)
        along = ((curve.point(t) - first) * line.conjugate()).real / abs(line) ** 2
        if -1e-9 <= t <= 1 + 1e-9 and -1e-9 <= along <= 1 + 1e-9:
            found.append(min(max(t, 0.0), 1.0))
    return sorted(found)


@lru_cache(maxsize=4096)
def evenly_by_length(controls: tuple[complex, ...], inside: int) -> tuple[complex, ...]:
    """Points inside the Bezier curve from 0 to 1 with these control points, equally far along it."""
    curve = bezier(0j, controls, 1 + 0j)
    total = curve.length()
    return tuple(curve.point(curve.at_length(total * k / (inside + 1))) for k in range(1, inside + 1))


def bezier(start: complex, controls: tuple[complex, ...], end: complex) -> QuadraticCurve | CubicCurve:
    """The Bezier curve with one or two control points."""
    if len(controls) == 1:
        return QuadraticCurve(start, controls[0], end)
    return CubicCurve(start, *controls, end)
