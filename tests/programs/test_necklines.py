"""Shapes of the neckline."""

from __future__ import annotations

import math
from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st

from swifttailor.programs.edges import ArcEdge, BezierEdge
from swifttailor.programs.necklines import NECKLINES, Neckline

necks = st.builds(
    Neckline,
    depth=st.floats(1.0, 40.0),
    width=st.floats(5.0, 34.0),
    angle=st.floats(70.0, 110.0),
    flip=st.booleans(),
    x=st.floats(0.05, 0.95),
    y=st.floats(0.05, 0.95),
)


@pytest.mark.parametrize("name", NECKLINES)
@given(neck=necks)
def test_every_shape_leads_from_shoulder_to_middle(name, neck):
    shape = NECKLINES[name](neck)
    assert shape[0].start == [0.0, 0.0]
    # Arcs that are nearly half a circle are drawn as half a circle, as in GarmentCode.
    assert shape[-1].end == pytest.approx([neck.width / 2, -neck.depth], abs=0.05)
    assert len(shape) == 1 or shape.is_chained()


@given(neck=necks)
def test_two_halves_of_a_round_neck_make_one_circle(neck):
    (arc,) = NECKLINES["CircleNeckHalf"](neck)
    assert isinstance(arc, ArcEdge)
    end = arc.as_curve().derivative(1.0)
    assert end.imag == pytest.approx(0, abs=1e-6 * abs(end)), "it crosses the middle level"


@given(neck=necks)
def test_a_square_neck_is_as_long_as_its_sides(neck):
    assert NECKLINES["SquareNeckHalf"](neck).lengths() == pytest.approx([neck.depth, neck.width / 2])


def test_a_trapezoid_with_no_room_at_the_bottom_becomes_a_v():
    neck = Neckline(depth=30.0, width=12.0, angle=110.0)
    assert len(NECKLINES["TrapezoidNeckHalf"](neck)) == 1
    assert len(NECKLINES["TrapezoidNeckHalf"](replace(neck, angle=95.0))) == 2


def test_the_angle_of_a_trapezoid_is_that_between_its_sides():
    side, bottom = NECKLINES["TrapezoidNeckHalf"](Neckline(depth=10.0, width=30.0, angle=105.0))
    assert math.degrees(abs(_turn(side.chord(), bottom.chord()))) == pytest.approx(180 - 105)


@pytest.mark.parametrize("name", ["CurvyNeckHalf", "CircleArcNeckHalf", "Bezier2NeckHalf"])
def test_flipped_curves_bend_to_the_other_side(name):
    neck = Neckline(depth=10.0, width=20.0)
    (one,), (other,) = NECKLINES[name](neck), NECKLINES[name](replace(neck, flip=True))
    assert other.reflect_features().midpoint() == pytest.approx(one.midpoint())
    assert one.length() > one.straight_length() + 0.1


def test_the_control_point_of_a_bezier_neck_is_where_x_and_y_say():
    (edge,) = NECKLINES["Bezier2NeckHalf"](Neckline(depth=10.0, width=20.0, x=0.2, y=0.4))
    assert isinstance(edge, BezierEdge)
    assert edge.control_points == [[0.2, -0.4]]


def _turn(one: complex, other: complex) -> float:
    way = one.conjugate() * other
    return math.atan2(way.imag, way.real)
