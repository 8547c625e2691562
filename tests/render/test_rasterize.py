from __future__ import annotations

import numpy as np
import pytest
from scenes import brute_force, random_triangles

from swifttailor.render.rasterize import depth_picture, rasterize


@pytest.mark.parametrize("seed", range(4))
def test_same_as_pixel_by_pixel(seed):
    size = (37, 29)
    corners = random_triangles(60, size, seed)
    expected, sure = brute_force(corners, size)
    assert sure.mean() > 0.95 and (expected >= 0).mean() > 0.5
    np.testing.assert_array_equal(rasterize(corners, size)[sure], expected[sure])


@pytest.mark.parametrize("shift", [0.0, 0.5, 0.25, 1 / 3])
def test_neighbours_share_every_pixel_exactly_once(shift):
    """A fan and a grid whose borders run through pixel centres too."""
    rng = np.random.default_rng(1)
    n = 7
    x, y = np.meshgrid(np.linspace(2, 30, n), np.linspace(3, 25, n))
    inner = (slice(1, -1), slice(1, -1))
    x[inner] += rng.choice([-1.0, -0.5, 0.0, 0.5, 1.0], x[inner].shape)
    y[inner] += rng.choice([-1.0, -0.5, 0.0, 0.5, 1.0], y[inner].shape)
    points = np.stack([x.ravel() + shift, y.ravel() + shift, np.ones(n * n)], axis=1)
    cell = np.arange(n * n).reshape(n, n)
    a, b, c, d = (q.ravel() for q in (cell[:-1, :-1], cell[:-1, 1:], cell[1:, 1:], cell[1:, :-1]))
    faces = np.concatenate([np.stack([a, b, c], 1), np.stack([c, a, d], 1)])
    covered = sum((rasterize(points[None, f], (34, 30)) >= 0).astype(int) for f in faces)
    assert covered.max() == 1
    low, high = 2 + shift, 30 + shift
    columns = ((np.arange(34) + 0.5 >= low) & (np.arange(34) + 0.5 < high)).sum()
    rows = ((np.arange(30) + 0.5 >= 3 + shift) & (np.arange(30) + 0.5 < 25 + shift)).sum()
    assert covered.sum() == columns * rows


def test_first_of_two_at_one_depth_wins():
    triangle = np.array([[[0.0, 0, 2], [20, 0, 2], [0, 20, 2]]])
    both = np.concatenate([triangle, triangle[:, ::-1]])
    assert set(np.unique(rasterize(both, (10, 10)))) <= {0, -1}
    assert set(np.unique(rasterize(both[::-1], (10, 10)))) <= {0, -1}


def test_degenerate_and_far_away_triangles_draw_nothing():
    line = np.array([[0.0, 0, 1], [5, 5, 1], [9, 9, 1]])
    point = np.full((3, 3), 3.0)
    outside = np.array([[-50.0, 2, 1], [-10, 2, 1], [-10, 9, 1]])
    above = np.array([[2.0, -50, 1], [9, -50, 1], [5, -1, 1]])
    assert (rasterize(np.array([line, point, outside, above]), (10, 10)) == -1).all()
    assert (rasterize(np.zeros((0, 3, 3)), (4, 3)) == -1).all()
    assert rasterize(np.zeros((0, 3, 3)), (4, 3)).shape == (3, 4)


def test_a_triangle_much_larger_than_the_picture_fills_it():
    huge = np.array([[[-1e6, -1e6, 1.0], [3e6, -1e6, 5.0], [-1e6, 3e6, 9.0]]])
    assert (rasterize(huge, (31, 17)) == 0).all()


def test_depth_is_that_of_the_plane():
    corners = np.array([[[-40.0, -40, 3], [90, -40, 12], [-40, 90, 5]]])
    depth = depth_picture(corners, (20, 16), fill=0.0)
    (x0, y0, z0), (x1, y1, z1), (x2, y2, z2) = corners[0]
    plane = np.linalg.solve([[x0, y0, 1], [x1, y1, 1], [x2, y2, 1]], [z0, z1, z2])
    x, y = np.meshgrid(np.arange(20) + 0.5, np.arange(16) + 0.5)
    np.testing.assert_allclose(depth, plane[0] * x + plane[1] * y + plane[2], atol=1e-8)


def test_depth_is_filled_where_nothing_is():
    corners = np.array([[[2.0, 2, 3], [9, 2, 4], [2, 9, 5]]])
    depth = depth_picture(corners, (12, 12), fill=77.0)
    np.testing.assert_array_equal(depth == 77.0, rasterize(corners, (12, 12)) < 0)
    assert (depth_picture(corners[:0], (4, 3), fill=7.0) == np.full((3, 4), 7.0)).all()
