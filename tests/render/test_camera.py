from __future__ import annotations

import numpy as np
import pytest

from swifttailor.errors import InputError
from swifttailor.render import Camera

SIZE = (200, 100)
CAMERAS = [
    Camera((3, 80, -2), 150, 0),
    Camera((3, 80, -2), 150, 35, 20),
    Camera((3, 80, -2), 150, 200, -40, 30),
    Camera((0, 0, 0), 10, 90, 89, 100),
]


@pytest.mark.parametrize("fov", [0.0, 25.0])
def test_front_view_has_the_wearers_left_on_its_right(fov):
    camera = Camera((0, 90, 0), 100, field_of_view=fov)
    left_hand, right_hand, head = camera.project(np.array([[20.0, 90, 0], [-20, 90, 0], [0, 120, 0]]), SIZE)
    assert left_hand[0] > 100 > right_hand[0]
    assert head[1] < 50


def test_back_and_side_views():
    points = np.array([[20.0, 90, 0], [0, 90, 20.0]])  # the wearer's left, and in front of the wearer
    back = Camera((0, 90, 0), 100, 180).project(points, SIZE)
    side = Camera((0, 90, 0), 100, 90).project(points, SIZE)
    assert back[0, 0] < 100 and back[1, 2] > back[0, 2]
    assert side[1, 0] < 100 and side[0, 2] < side[1, 2]


@pytest.mark.parametrize("camera", CAMERAS)
def test_axes_are_a_right_handed_frame(camera):
    np.testing.assert_allclose(camera.axes @ camera.axes.T, np.eye(3), atol=1e-12)
    assert np.linalg.det(camera.axes) == pytest.approx(1.0)


@pytest.mark.parametrize("camera", CAMERAS)
def test_height_is_what_is_seen_at_the_target(camera):
    edges = np.array([camera.target + s * camera.height / 2 * camera.axes[1] for s in (1, -1)])
    np.testing.assert_allclose(camera.project(edges, SIZE)[:, 1], [0, 100], atol=1e-6)
    middle = camera.project(np.array([camera.target], float), SIZE)[0]
    np.testing.assert_allclose(middle, [100, 50, camera.distance], atol=1e-6)


@pytest.mark.parametrize("camera", CAMERAS)
def test_rays_and_projection_undo_each_other(camera):
    rng = np.random.default_rng(0)
    pixels = rng.uniform(0, 1, (40, 2)) * SIZE
    origin, direction = camera.rays(*pixels.T, SIZE)
    along = camera.distance * rng.uniform(0.5, 1.5, (40, 1))
    np.testing.assert_allclose(camera.project(origin + along * direction, SIZE)[:, :2], pixels, atol=1e-6)


@pytest.mark.parametrize(
    "bad",
    [
        {"height": 0.0},
        {"height": float("nan")},
        {"field_of_view": 170.0},
        {"elevation": 90.0},
        {"azimuth": float("inf")},
        {"target": (0.0, 0.0)},
    ],
)
def test_impossible_cameras_are_refused(bad):
    with pytest.raises(InputError):
        Camera(**bad)


@pytest.mark.parametrize("field_of_view", [0.0, 30.0])
def test_floor_points_lie_on_their_sight_lines(field_of_view):
    camera, size = Camera((3, 40, -2), 120, 35, 25, field_of_view), (31, 24)
    x, y = np.arange(31) + 0.5, np.arange(24) + 0.5
    points = camera.floor_points(x, y, size)
    floor = np.stack([points[..., 0], np.zeros((24, 31)), points[..., 1]], axis=-1).reshape(-1, 3)
    seen = camera.project(floor, size)[:, :2].reshape(24, 31, 2)
    down = camera.rays(*(a.ravel() for a in np.meshgrid(x, y)), size)[1][:, 1].reshape(24, 31) < -1e-3
    assert down.mean() > 0.5
    np.testing.assert_allclose(seen[down], np.stack(np.meshgrid(x, y), axis=-1)[down], atol=1e-6)
