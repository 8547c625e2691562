from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from pattern_strategies import numbers, shaped_edges

from swifttailor.pattern import Arc, Cubic, Line, Quadratic
from swifttailor.pattern import curve as curves

CHECKED = settings(max_examples=150, deadline=None)
T = np.linspace(0.0, 1.0, 401)


def _size(chord):
    return float(np.hypot(*(chord[1] - chord[0])))


def _scale(curve, chord):
    """How large the shape is: arcs may be far larger than their chord."""
    return max(_size(chord), curve.radius if isinstance(curve, Arc) else 0.0)


def _farthest(points, others):
    return float(np.hypot(*(np.asarray(points) - np.asarray(others)).T).max())


@CHECKED
@given(shaped_edges())
def test_curve_passes_through_the_ends_of_its_chord(edge):
    curve, chord = edge
    points = curves.evaluate(curve, chord, [0.0, 1.0])
    assert np.array_equal(points, chord)
    near = curves.evaluate(curve, chord, [1e-9, 1 - 1e-9])
    assert _farthest(near, chord) < 1e-6 * _scale(curve, chord) + 1e-9


@CHECKED
@given(shaped_edges(), numbers(0.05, 0.95))
def test_pieces_of_a_split_trace_the_same_points(edge, parameter):
    curve, chord = edge
    first, second, point = curves.split(curve, chord, parameter)
    head, tail = np.array([chord[0], point]), np.array([point, chord[1]])
    tolerance = 1e-6 if isinstance(curve, Arc) else 1e-9
    assert np.array_equal(point, curves.evaluate(curve, chord, [parameter])[0])
    for piece, part, parameters in (
        (first, head, parameter * T),
        (second, tail, parameter + (1 - parameter) * T),
    ):
        whole = curves.evaluate(curve, chord, parameters)
        assert _farthest(curves.evaluate(piece, part, T), whole) < tolerance * _scale(curve, chord) + 1e-9
    total = curves.length(first, head) + curves.length(second, tail)
    assert total == pytest.approx(curves.length(curve, chord), rel=1e-7)


@pytest.mark.parametrize("large", [False, True])
@pytest.mark.parametrize("right", [False, True])
def test_splitting_an_arc_too_small_for_its_chord_follows_the_semicircle_it_is_drawn_as(large, right):
    curve, chord = Arc(3.0, large, right), np.array([[0.0, 0.0], [10.0, 0.0]])
    first, second, point = curves.split(curve, chord, 0.3)
    whole = curves.evaluate(curve, chord, T)
    assert np.hypot(*(whole - [5.0, 0.0]).T) == pytest.approx(5.0, abs=1e-9)
    for piece, part, parameters in (
        (first, [chord[0], point], 0.3 * T),
        (second, [point, chord[1]], 0.3 + 0.7 * T),
    ):
        assert _farthest(curves.evaluate(piece, part, T), curves.evaluate(curve, chord, parameters)) < 1e-6


@CHECKED
@given(shaped_edges())
def test_reversing_twice_changes_nothing_and_once_only_the_direction(edge):
    curve, chord = edge
    back = curves.reverse(curve)
    again = curves.reverse(back)
    tolerance = 1e-9 * _scale(curve, chord)
    backwards = curves.evaluate(back, chord[::-1], T)[::-1]
    assert _farthest(backwards, curves.evaluate(curve, chord, T)) < tolerance + 1e-9
    assert _farthest(curves.evaluate(again, chord, T), curves.evaluate(curve, chord, T)) < tolerance
    if isinstance(curve, Arc | Line):
        assert again == curve


@CHECKED
@given(shaped_edges())
def test_mirroring_reflects_every_point(edge):
    curve, chord = edge
    flip = np.array([-1.0, 1.0])
    reflected = curves.evaluate(curves.mirror(curve), chord * flip, T)
    assert _farthest(reflected, curves.evaluate(curve, chord, T) * flip) < 1e-9 * _scale(curve, chord) + 1e-9
    assert curves.mirror(curves.mirror(curve)) == curve


@CHECKED
@given(shaped_edges(), st.sampled_from([0.01, 0.1, 2.54, 100.0]))
def test_scaling_multiplies_points_and_length(edge, factor):
    curve, chord = edge
    scaled = curves.scale(curve, factor)
    expected = curves.evaluate(curve, chord, T) * factor
    assert _farthest(curves.evaluate(scaled, chord * factor, T), expected) < 1e-9 * (
        1 + factor * (_scale(curve, chord) + 200)
    )
    assert curves.length(scaled, chord * factor) == pytest.approx(
        factor * curves.length(curve, chord), rel=1e-9
    )


@CHECKED
@given(shaped_edges())
def test_length_is_the_limit_of_polylines(edge):
    curve, chord = edge
    fine = curves.evaluate(curve, chord, np.linspace(0.0, 1.0, 20001))
    polyline = float(np.hypot(*np.diff(fine, axis=0).T).sum())
    length = curves.length(curve, chord)
    assert length >= polyline * (1 - 1e-9)
    assert length == pytest.approx(polyline, rel=1e-6)
    assert length >= _size(chord) * (1 - 1e-12)


@CHECKED
@given(shaped_edges(), st.integers(2, 40))
def test_samples_by_length_are_equally_spaced(edge, count):
    curve, chord = edge
    parameters = curves.parameters_by_length(curve, chord, np.linspace(0.0, 1.0, count))
    assert parameters[0] == 0.0 and parameters[-1] == 1.0 and np.all(np.diff(parameters) >= 0)
    total = curves.length(curve, chord)
    pieces, done, rest, rest_chord = [], 0.0, curve, chord
    for t in parameters[1:-1]:
        first, rest, point = curves.split(rest, rest_chord, (t - done) / (1 - done))
        pieces.append(curves.length(first, [rest_chord[0], point]))
        rest_chord, done = np.array([point, chord[1]]), t
    pieces.append(curves.length(rest, rest_chord))
    # Splitting an arc again and again costs digits: its pieces keep the radius, not the angle.
    tolerance = 1e-6 if isinstance(curve, Arc) else 1e-9
    assert np.array(pieces) == pytest.approx(total / (count - 1), rel=tolerance, abs=tolerance * total)
    points = curves.sample_by_length(curve, chord, count)
    assert np.array_equal(points[[0, -1]], chord)


@CHECKED
@given(shaped_edges())
def test_bounding_box_contains_the_curve_and_touches_it(edge):
    curve, chord = edge
    low, high = curves.bounding_box(curve, chord)
    points = curves.evaluate(curve, chord, np.linspace(0.0, 1.0, 5001))
    slack = 1e-9 * _scale(curve, chord) + 1e-9
    assert np.all(points >= low - slack) and np.all(points <= high + slack)
    reach = 1e-5 * _scale(curve, chord) + 1e-9
    assert np.abs(points.min(axis=0) - low).max() < reach
    assert np.abs(points.max(axis=0) - high).max() < reach


@pytest.mark.parametrize("nudge", [0.0, 1e-17, 1e-15, 1e-12, -1e-16])
def test_bounding_box_of_a_cubic_that_is_almost_a_quadratic(nudge):
    """Its derivative is almost linear, where the plain quadratic formula divides by almost nothing."""
    q = np.array([0.5, 0.4])
    c1, c2 = 2 / 3 * q, np.array([1.0, 0.0]) / 3 + 2 / 3 * q
    curve = Cubic(tuple(c1 + nudge), tuple(c2))
    box = curves.bounding_box(curve, [[0.0, 0.0], [10.0, 0.0]])
    assert box[1, 1] == pytest.approx(2.0, abs=1e-9)


@CHECKED
@given(shaped_edges(), st.sampled_from([0.001, 0.01, 0.1]))
def test_flattening_stays_within_its_tolerance(edge, tolerance):
    curve, chord = edge
    line = curves.flatten(curve, chord, tolerance)
    assert np.array_equal(line[[0, -1]], chord)
    if len(line) >= 2001:  # capped: only shapes of many metres
        assert _scale(curve, chord) > 500
        return
    t = np.linspace(0.0, 1.0, len(line))
    middles = curves.evaluate(curve, chord, (t[1:] + t[:-1]) / 2)
    gaps = np.hypot(*(middles - (line[1:] + line[:-1]) / 2).T)
    assert gaps.max() <= 1.5 * tolerance


def test_quarter_semi_and_large_arcs_have_the_exact_geometry():
    chord = np.array([[0.0, 0.0], [2.0, 0.0]])
    semi = Arc(1.0, False, True)
    assert curves.length(semi, chord) == pytest.approx(np.pi, rel=1e-12)
    assert curves.evaluate(semi, chord, [0.5])[0] == pytest.approx([1.0, -1.0])  # bulges right of travel
    assert curves.evaluate(Arc(1.0, False, False), chord, [0.5])[0] == pytest.approx([1.0, 1.0])
    quarter = Arc(np.sqrt(2.0), False, False)
    large = Arc(np.sqrt(2.0), True, False)
    assert curves.length(quarter, chord) == pytest.approx(np.sqrt(2) * np.pi / 2)
    assert curves.length(large, chord) == pytest.approx(np.sqrt(2) * 3 * np.pi / 2)
    assert curves.evaluate(large, chord, [0.5])[0] == pytest.approx([1.0, 1.0 + np.sqrt(2)])
    assert curves.bounding_box(large, chord) == pytest.approx(
        np.array([[1 - np.sqrt(2), 0.0], [1 + np.sqrt(2), 1 + np.sqrt(2)]])
    )


@pytest.mark.parametrize("large", [False, True])
@pytest.mark.parametrize("right", [False, True])
def test_arcs_agree_with_the_svg_definition(large, right):
    """Right arcs run counter-clockwise; large ones sweep more than half a turn."""
    chord = np.array([[3.0, -1.0], [7.0, 4.0]])
    g = curves.arc_geometry(Arc(5.0, large, right), chord)
    assert np.hypot(*(chord - g.center).T) == pytest.approx([5.0, 5.0])
    assert (g.sweep > 0) == right
    assert (abs(g.sweep) > np.pi) == large


@pytest.mark.parametrize(
    "curve", [Line(), Quadratic((0.5, 0.3)), Cubic((0.2, 0.1), (0.8, -0.1)), Arc(4.0, True, False)]
)
def test_a_chord_without_length_gives_one_point_and_length_zero(curve):
    chord = np.array([[3.0, 4.0], [3.0, 4.0]])
    assert curves.length(curve, chord) == 0.0
    assert np.allclose(curves.evaluate(curve, chord, T), [3.0, 4.0]) or isinstance(curve, Arc)
    points = curves.sample_by_length(curve, chord, 5)
    assert np.isfinite(points).all()
    assert np.array_equal(curves.flatten(curve, chord, 0.01)[[0, -1]], chord)


@CHECKED
@given(shaped_edges(kinds=("line",)), st.tuples(numbers(-50, 50), numbers(-50, 50)))
def test_relative_coordinates_undo_absolute_ones(edge, point):
    _, chord = edge
    relative = curves.to_relative(point, chord)
    assert curves.to_absolute(relative, chord) == pytest.approx(point, abs=1e-8)
    assert curves.to_absolute((0.0, 0.0), chord) == pytest.approx(chord[0])
    assert curves.to_absolute((1.0, 0.0), chord) == pytest.approx(chord[1])
    d = chord[1] - chord[0]
    left = curves.to_absolute((0.0, 1.0), chord) - chord[0]
    assert d[0] * left[1] - d[1] * left[0] > 0


@CHECKED
@given(shaped_edges())
def test_derivative_is_the_slope(edge):
    curve, chord = edge
    t = np.array([0.13, 0.5, 0.81])
    h = 1e-6
    slope = (curves.evaluate(curve, chord, t + h) - curves.evaluate(curve, chord, t - h)) / (2 * h)
    assert curves.derivative(curve, chord, t) == pytest.approx(slope, abs=1e-3 * (1 + _scale(curve, chord)))
