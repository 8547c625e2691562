from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from swifttailor.programs.planar_curves import ArcCurve, CubicCurve, LineCurve, QuadraticCurve

coordinates = st.floats(-50, 50, allow_nan=False)
points = st.builds(complex, coordinates, coordinates)


@st.composite
def curves(draw):
    start, end = draw(points), draw(points)
    assume(abs(end - start) > 1)
    kind = draw(st.sampled_from(["line", "quadratic", "cubic", "arc"]))
    if kind == "line":
        return LineCurve(start, end)
    if kind == "quadratic":
        return QuadraticCurve(start, draw(points), end)
    if kind == "cubic":
        return CubicCurve(start, draw(points), draw(points), end)
    radius = abs(end - start) / 2 * draw(st.floats(1.01, 4))
    return ArcCurve(start, end, radius, draw(st.booleans()), draw(st.booleans()))


def travelled(curve, low=0.0, high=1.0):
    at = np.linspace(low, high, 20001)
    way = np.array([curve.point(t) for t in at[::10]])
    return float(np.abs(np.diff(way)).sum())


@given(curves())
def test_it_runs_from_start_to_end(curve):
    assert abs(curve.point(0.0) - curve.start) < 1e-9
    assert abs(curve.point(1.0) - curve.end) < 1e-9


@given(curves(), st.floats(0, 1), st.floats(0, 1))
def test_length_is_that_of_the_way(curve, one, two):
    low, high = sorted((one, two))
    # Near a cusp the nodes of the rule lie apart on either side of the slowest point.
    assert curve.length(low, high) == pytest.approx(travelled(curve, low, high), rel=1e-3, abs=1e-4)


def test_a_quadratic_that_turns_back_on_its_own_line_has_both_ways():
    assert QuadraticCurve(0j, 10 + 0j, 0j).length() == pytest.approx(10.0)
    assert QuadraticCurve(0j, 5 + 0j, 10 + 0j).length() == pytest.approx(10.0)


@given(curves(), st.floats(0, 1))
def test_at_length_is_the_inverse_of_length(curve, fraction):
    total = curve.length()
    t = curve.at_length(fraction * total)
    assert 0 <= t <= 1
    assert curve.length(0.0, t) == pytest.approx(fraction * total, abs=1e-6)


@given(curves(), st.floats(0, 0.45), st.floats(0.55, 1))
def test_a_part_lies_on_the_whole(curve, low, high):
    part = curve.cropped(low, high)
    assert part.length() == pytest.approx(curve.length(low, high), rel=1e-6, abs=1e-6)
    for t in (0.0, 0.3, 1.0):
        assert abs(part.point(t) - curve.point(low + t * (high - low))) < 1e-6


@given(curves(), st.floats(0.1, 0.9), st.floats(0, math.pi))
def test_crossings_are_where_a_line_through_a_point_meets_the_curve(curve, t, angle):
    at, way = curve.point(t), 100 * complex(math.cos(angle), math.sin(angle))
    tangent = curve.derivative(t)
    assume(abs(tangent) > 1e-2 and abs((tangent.conjugate() * way).imag) > 0.1 * abs(tangent) * abs(way))
    found = curve.crossings(at - way, at + way)
    assert min(abs(curve.point(f) - at) for f in found) < 1e-4
    for f in found:
        assert abs(((curve.point(f) - at) * way.conjugate()).imag) / abs(way) < 1e-4


def test_a_line_beside_the_curve_meets_it_nowhere():
    assert ArcCurve(0j, 10 + 0j, 8.0, False, True).crossings(-5j + 20, 5j + 20) == []
    assert LineCurve(0j, 10 + 0j).crossings(11 - 1j, 11 + 1j) == []


@given(curves(), st.floats(0.05, 0.95))
def test_the_tangent_is_a_unit_vector_along_the_way(curve, t):
    assume(abs(curve.derivative(t)) > 1e-3)
    step = 1e-6
    moved = (curve.point(t + step) - curve.point(t - step)) / (2 * step)
    assert abs(curve.derivative(t) - moved) < 1e-3 * max(1.0, abs(moved))
    assert abs(curve.unit_tangent(t)) == pytest.approx(1.0)
