from __future__ import annotations

import math

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from swifttailor.programs.curved_edges import (
    arc_from_points_angle,
    arc_from_points_radius,
    arc_from_rad_length,
    arc_from_three_points,
    curve_3_points,
    curve_from_tangents,
    vector_angle,
)
from swifttailor.programs.design_error import DesignError
from swifttailor.programs.edge_sequence import EdgeSequence
from swifttailor.programs.edge_shapes import dart_shape, from_fractions, from_verts, side_with_cut
from swifttailor.programs.edges import ArcEdge, BezierEdge, Edge

numbers = st.floats(-40, 40, allow_nan=False)


@st.composite
def edges(draw):
    start, end = [draw(numbers), draw(numbers)], [draw(numbers), draw(numbers)]
    assume(math.dist(start, end) > 2)
    kind = draw(st.sampled_from(["line", "arc", "quadratic", "cubic"]))
    bend = st.floats(-0.8, 0.8).filter(lambda x: abs(x) > 0.01)
    if kind == "line":
        return Edge(start, end)
    if kind == "arc":
        return ArcEdge(start, end, draw(bend))
    count = 1 if kind == "quadratic" else 2
    return BezierEdge(start, end, [[draw(st.floats(0.1, 0.9)), draw(bend)] for _ in range(count)])


def outline(edge):
    return [edge.start, *edge.points_inside(9), edge.end]


def near(one, two, tolerance=1e-5):  # points found by length are within some 1e-6 cm
    return all(math.dist(a, b) < tolerance for a, b in zip(one, two, strict=True))


@given(edges())
def test_a_reversed_edge_is_the_same_line_from_the_other_end(edge):
    before, length = outline(edge), edge.length()
    assert near(outline(edge.reverse()), before[::-1])
    assert edge.length() == pytest.approx(length)
    assert near(outline(edge.reverse()), before)


@given(edges(), st.lists(st.floats(0.1, 1), min_size=2, max_size=4))
def test_parts_of_an_edge_have_the_asked_lengths_and_share_vertices(edge, weights):
    fractions = [w / sum(weights) for w in weights]
    total = edge.length()
    parts = edge.subdivide_len(fractions)
    assert parts[0].start is edge.start and parts[-1].end is edge.end
    assert EdgeSequence(parts).is_chained()
    for part, fraction in zip(parts, fractions, strict=True):
        assert part.length() == pytest.approx(total * fraction, rel=1e-3, abs=1e-3)


@given(edges())
def test_the_middle_is_on_the_edge(edge):
    half, _ = edge.subdivide_len([0.5, 0.5])
    assert math.dist(half.end, edge.midpoint()) < 1e-2


@given(edges(), numbers, numbers, st.floats(-3, 3))
def test_moving_keeps_the_shape(edge, x, y, angle):
    length = edge.length()
    edge.snap_to([x, y]).rotate(angle)
    assert edge.start == pytest.approx([x, y]) and edge.length() == pytest.approx(length)


def test_fractions_that_make_no_whole_are_refused():
    with pytest.raises(DesignError, match="sum is 1"):
        Edge([0.0, 0.0], [10.0, 0.0]).subdivide_len([0.5, 0.6])


def test_an_edge_needs_two_ends():
    with pytest.raises(DesignError, match="its ends must differ"):
        Edge([1.0, 2.0], [1.0, 2.00001])


def test_moving_a_shared_vertex_moves_both_edges():
    chain = from_verts([0.0, 0.0], [10.0, 0.0], [10.0, 10.0])
    chain[0].end[0] = 12.0
    assert chain[1].start == [12.0, 0.0]


def test_a_copy_shares_among_itself_and_not_with_the_original():
    loop = from_verts([0.0, 0.0], [10.0, 0.0], [10.0, 10.0], loop=True)
    copy = loop.copy()
    assert copy.is_loop() and copy.is_chained()
    copy.translate_by([5.0, 0.0])
    assert loop[0].start == [0.0, 0.0] and copy[0].start == [5.0, 0.0]


def test_each_shared_vertex_is_moved_once():
    loop = from_verts([0.0, 0.0], [10.0, 0.0], [10.0, 10.0], loop=True)
    loop.translate_by([1.0, 2.0])
    assert loop.verts() == [[1.0, 2.0], [11.0, 2.0], [11.0, 12.0]]


@given(st.lists(edges(), min_size=1, max_size=1), st.floats(0.2, 3))
def test_extending_stretches_along_the_shortcut_only(given_edges, factor):
    seq = EdgeSequence(given_edges)
    before = math.dist(*seq.shortcut())
    start = list(seq[0].start)
    seq.extend(factor)
    assert math.dist(*seq.shortcut()) == pytest.approx(before * factor) and seq[0].start == start


@given(edges())
def test_a_mirror_image_of_a_mirror_image_is_the_original(edge):
    seq = EdgeSequence(edge)
    before = outline(edge)
    seq.reflect([1.0, 2.0], [3.0, -4.0]).reflect([1.0, 2.0], [3.0, -4.0])
    assert near(outline(edge), before)


def test_reversed_edges_are_chained_again():
    seq = from_verts([0.0, 0.0], [10.0, 0.0], [10.0, 10.0])
    seq[1].reverse()
    assert not seq.is_chained() and seq.chained_order().is_chained()


@given(st.floats(0.1, 6), st.booleans())
def test_arcs_by_angle_radius_and_length_agree(angle, right):
    edge = arc_from_points_angle([0.0, 0.0], [10.0, 0.0], angle, right)
    radius = 5 / math.sin(min(angle, 2 * math.pi - angle) / 2)
    assert edge.radius() == pytest.approx(radius, rel=1e-6)
    assert edge.length() == pytest.approx(radius * angle, rel=1e-6)
    assert edge.is_large() == (angle > math.pi)
    again = arc_from_points_radius([0.0, 0.0], [10.0, 0.0], radius, angle > math.pi, right)
    assert again.control_y == pytest.approx(edge.control_y, abs=2e-2)
    other = arc_from_rad_length(radius, radius * angle, right)
    assert other.length() == pytest.approx(radius * angle, rel=2e-2)
    assert (edge.midpoint()[1] < 0) == right  # to the right of travel is below


@given(st.floats(-30, 30).filter(lambda y: abs(y) > 0.5), st.floats(3, 7))
def test_an_arc_passes_through_its_three_points(y, x):
    edge = arc_from_three_points([0.0, 0.0], [10.0, 0.0], [x, y])
    center, radius, _, _ = edge.as_curve().circle()
    assert abs(complex(x, y) - center) == pytest.approx(radius, rel=1e-2)


def test_impossible_arcs_are_refused():
    with pytest.raises(DesignError, match="cannot span"):
        arc_from_points_radius([0.0, 0.0], [10.0, 0.0], 4.0)
    with pytest.raises(DesignError, match="longer than its circle"):
        arc_from_rad_length(1.0, 7.0)
    with pytest.raises(DesignError, match="in one line"):
        arc_from_three_points([0.0, 0.0], [10.0, 0.0], [5.0, 0.0])


@given(st.floats(0.2, 1.3), st.floats(0.2, 1.3))
def test_a_curve_leaves_and_arrives_as_asked(first, last):
    tangents = [[math.cos(first), math.sin(first)], [math.cos(last), -math.sin(last)]]
    curve = curve_from_tangents([0.0, 0.0], [10.0, 0.0], *tangents).as_curve()
    for t, tangent in zip((0.0, 1.0), tangents, strict=True):
        found = curve.unit_tangent(t)
        assert math.dist([found.real, found.imag], tangent) < 1e-3


def test_a_curve_of_one_tangent_is_garmentcode_s():
    """Many curves fit; these control points are those that pygarment 2.0.2 finds."""
    up = curve_from_tangents([0.0, 0.0], [3.0, 10.0], target_tan1=[0.0, 1.0], initial_guess=[0.75, 0.0])
    assert up.control_points[0] == pytest.approx([0.7508384760687049, -0.07474847418625127], abs=1e-5)
    down = curve_from_tangents([0.0, 0.0], [3.0, 10.0], target_tan0=[0.0, 1.0])
    assert down.control_points[0] == pytest.approx([0.5885051436061622, 0.17655153567386989], abs=1e-5)


def test_a_curve_through_a_point_is_garmentcode_s():
    edge = curve_3_points([0.0, 0.0], [3.0, 10.0], [2.0, 4.0])
    assert edge.control_points[0] == pytest.approx([0.42093644354130727, -0.14769215700048463], abs=1e-5)
    assert min(math.dist([p.real, p.imag], [2, 4]) for p in map(edge.as_curve().point, _many())) < 0.05
    with pytest.raises(DesignError, match="does not lie over"):
        curve_3_points([0.0, 0.0], [3.0, 10.0], [0.0, -4.0])


def _many():
    return [k / 500 for k in range(501)]


def test_angles_are_positive_to_the_left():
    assert vector_angle([1, 0], [0, 2]) == pytest.approx(math.pi / 2)
    assert vector_angle([1, 0], [0, -2]) == pytest.approx(-math.pi / 2)
    assert vector_angle([1, 0], [3, 0]) == 0.0


def test_common_shapes():
    cut = side_with_cut([0.0, 0.0], [0.0, 10.0], start_cut=0.2, end_cut=0.3)
    assert cut.lengths() == pytest.approx([2, 5, 3])
    assert from_fractions([0.0, 0.0], [10.0, 0.0], [0.25, 0.75]).lengths() == pytest.approx([2.5, 7.5])
    assert dart_shape(6.0, side_len=5.0).lengths() == pytest.approx([5, 5])
    assert dart_shape(6.0, depth=4.0)[0].end == [3.0, -4.0]
    with pytest.raises(DesignError, match="cannot have sides"):
        dart_shape(6.0, side_len=2.0)
