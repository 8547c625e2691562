"""Armholes, and the ends of sleeves that are sewn into them."""

from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from swifttailor.programs.armhole_openings import even_armhole_openings
from swifttailor.programs.armholes import ARMHOLES, Armhole, armhole_curve, sleeve_opening

holes = st.builds(
    Armhole, incl=st.floats(1.0, 12.0), width=st.floats(15.0, 28.0), smoothing=st.floats(0.1, 0.4)
)
angles = st.floats(math.radians(22), math.radians(50))


@pytest.mark.parametrize("name", ARMHOLES)
@given(hole=holes)
def test_every_shape_spans_the_armhole(name, hole):
    shape = ARMHOLES[name](hole)
    assert shape[0].start == [0.0, 0.0]
    assert shape[-1].end == pytest.approx([hole.incl, hole.width])


@given(hole=holes)
def test_smoothing_cuts_the_corner_of_an_angular_armhole(hole):
    square, angle = ARMHOLES["ArmholeSquare"](hole), ARMHOLES["ArmholeAngle"](hole)
    assert angle.length() < square.length()


@given(holes, angles, st.floats(-0.9, 0.8))
def test_a_sleeve_ends_as_long_as_its_armhole_and_leaves_the_shoulder_upright(hole, angle, mix):
    (opening,) = sleeve_opening(hole, angle, mix)
    (armhole,) = armhole_curve(hole)
    assert opening.length() == pytest.approx(armhole.length(), rel=0.01)
    arrival = opening.as_curve().unit_tangent(1.0)
    assert math.degrees(math.acos(min(1.0, abs(arrival.imag)))) < 15


@given(holes, angles, st.floats(0.5, 3.0))
def test_even_openings_are_equally_wide_and_together_as_long_as_before(hole, angle, more):
    front = sleeve_opening(Armhole(hole.incl + more, hole.width), angle)
    back = sleeve_opening(hole, angle)
    length = front.length() + back.length()
    even_armhole_openings(front, back, tol=0.2 / front.length())
    assert front.length() + back.length() == pytest.approx(length)
    widths = [abs(shape[0].start[1] - shape[-1].end[1]) for shape in (front, back)]
    # Where the ends were near enough already, nothing was moved.
    assert widths[0] == pytest.approx(widths[1], abs=0.01 if len(back) == 2 else 0.8)
