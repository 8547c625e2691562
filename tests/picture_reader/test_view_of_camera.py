"""Six numbers that say how a camera looks at the wearer."""

from __future__ import annotations

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from swifttailor.picture_reader.view import HIGH, LOW, camera_of, view_in, view_of
from swifttailor.render import Camera


@given(
    azimuth=st.floats(-180, 180),
    elevation=st.floats(-15, 25),
    height=st.floats(120, 400),
    x=st.floats(-20, 20),
    y=st.floats(60, 130),
    field=st.one_of(st.just(0.0), st.floats(1, 25)),
)
def test_the_camera_of_a_view_shows_the_wearer_in_the_same_place(azimuth, elevation, height, x, y, field):
    turned = np.deg2rad(azimuth)
    target = (x * float(np.cos(turned)), y, -x * float(np.sin(turned)))
    camera = Camera(target, height, azimuth, elevation, field)
    found = camera_of(view_of(camera, 100))
    axis = np.stack([LOW, HIGH])
    before, after = (c.project(axis, (100, 100))[:, :2] for c in (camera, found))
    size = np.ptp(before[:, 1])
    # Another distance of the camera bends the axis a little.
    assert np.abs(before.mean(axis=0) - after.mean(axis=0)).max() < 0.04 * size
    assert abs(size - np.ptp(after[:, 1])) < 0.06 * size
    assert abs((found.azimuth - azimuth + 180) % 360 - 180) < 0.01
    assert abs(found.elevation - elevation) < 0.01


def test_the_view_says_what_is_seen():
    view = view_of(Camera((0.0, 100.0, 0.0), 160.0, 90.0, 0.0, 0.0), 64)
    np.testing.assert_allclose(view, [1, 0, 0, np.log(0.5), 0, 0], atol=1e-6)
    aside = view_of(Camera((16.0, 116.0, 0.0), 160.0, 0.0, 0.0, 0.0), 64)
    np.testing.assert_allclose(aside[4:], [-0.1, 0.1], atol=1e-6)


@given(
    height=st.floats(120, 300),
    x=st.floats(-20, 20),
    y=st.floats(60, 130),
    left=st.integers(-30, 60),
    top=st.integers(-30, 60),
    side=st.integers(40, 180),
)
def test_a_view_is_told_for_another_frame_of_the_picture(height, x, y, left, top, side):
    view = view_of(Camera((x, y, 0.0), height, 0.0, 0.0, 0.0), 100)
    found = view_in(view, (0, 0, 100), (left, top, side))
    per_pixel = height / 100
    middle = Camera(
        (x + (left + side / 2 - 50) * per_pixel, y - (top + side / 2 - 50) * per_pixel, 0.0),
        side * per_pixel,
        0.0,
        0.0,
        0.0,
    )
    np.testing.assert_allclose(found, view_of(middle, 200), atol=1e-4)
    np.testing.assert_allclose(view_in(found, (left, top, side), (0, 0, 100)), view, atol=1e-4)
