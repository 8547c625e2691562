import numpy as np
import pytest
import shapely
from hypothesis import given, settings
from hypothesis import strategies as st

from swifttailor.errors import GeometryError
from swifttailor.panel_mesh.constrained_edges import interior_triangles, recover_edges
from swifttailor.panel_mesh.topology import topology
from swifttailor.panel_mesh.triangulate import triangulate_polygon


def areas(points, faces):
    a, b, c = (points[faces[:, k]] for k in range(3))
    u, w = b - a, c - a
    return (u[:, 0] * w[:, 1] - u[:, 1] * w[:, 0]) / 2


def assert_fills(boundary, points, faces):
    """The triangles tile the polygon, keep its boundary and are wound like it."""
    signed = areas(points, faces)
    polygon = shapely.Polygon(boundary)
    direction = 1 if shapely.LinearRing(boundary).is_ccw else -1
    assert (signed * direction > 0).all()
    assert np.isclose(np.abs(signed).sum(), polygon.area, rtol=1e-9)
    assert np.array_equal(points[: len(boundary)], boundary)
    measured = topology(faces, len(points))
    assert (measured.components, measured.boundary_loops, measured.euler_characteristic) == (1, 1, 1)
    assert measured.nonmanifold_edges == measured.inconsistent_edges == 0
    halves = {(int(f[k]), int(f[(k + 1) % 3])) for f in faces for k in range(3)}
    count = len(boundary)
    assert all((k, (k + 1) % count) in halves for k in range(count))


def resample(corners, step):
    pieces = []
    for a, b in zip(corners, np.roll(corners, -1, axis=0), strict=True):
        count = max(1, int(np.ceil(np.linalg.norm(b - a) / step)))
        pieces.append(a + (b - a) * (np.arange(count) / count)[:, None])
    return np.concatenate(pieces)


@pytest.mark.parametrize("edge_length", [0.7, 2.0, 5.0])
@pytest.mark.parametrize(
    "corners",
    [
        [[0, 0], [20, 0], [20, 30], [0, 30]],
        [[0, 0], [0, 30], [20, 30], [20, 0]],  # clockwise
        [[0, 0], [30, 0], [30, 30], [16, 30], [15, 2], [14, 30], [0, 30]],  # a deep dart
        [[0, 0], [40, 0], [40, 0.01], [0, 0.01]],  # a sliver cuff
        [[0, 0], [10, 0], [10.001, 0.001], [10, 12], [0, 12]],  # a split vertex next to a corner
        [[0, 0], [9, 1], [18, 0], [17, 9], [18, 18], [9, 17], [0, 18], [1, 9]],
    ],
)
def test_fills_the_polygon_exactly(corners, edge_length):
    boundary = resample(np.array(corners, float), edge_length)
    points, faces = triangulate_polygon(boundary, edge_length)
    assert_fills(boundary, points, faces)


@given(
    radii=st.lists(st.floats(3.0, 30.0), min_size=3, max_size=16),
    edge_length=st.floats(0.8, 6.0),
    clockwise=st.booleans(),
)
@settings(max_examples=60, deadline=None)
def test_fills_any_star_shaped_polygon(radii, edge_length, clockwise):
    angles = np.linspace(0, 2 * np.pi, len(radii), endpoint=False)
    corners = np.array(radii)[:, None] * np.stack([np.cos(angles), np.sin(angles)], axis=1)
    boundary = resample(corners[::-1] if clockwise else corners, edge_length)
    points, faces = triangulate_polygon(boundary, edge_length)
    assert_fills(boundary, points, faces)


def test_inner_triangles_are_well_shaped():
    boundary = resample(np.array([[0.0, 0], [40, 0], [40, 40], [0, 40]]), 2.0)
    points, faces = triangulate_polygon(boundary, 2.0)
    corners = points[faces]
    sides = np.linalg.norm(np.roll(corners, -1, axis=1) - corners, axis=2)
    quality = 4 * np.sqrt(3) * areas(points, faces) / (sides**2).sum(axis=1)
    assert np.percentile(quality, 5) > 0.8 and quality.min() > 0.5
    assert 1.6 < np.median(sides) < 2.4


def test_refuses_a_boundary_that_crosses_itself():
    with pytest.raises(GeometryError, match="crosses or touches itself"):
        triangulate_polygon(np.array([[0.0, 0], [10, 10], [10, 0], [0, 10], [-5, 5]]), 2.0)


def test_recovers_an_edge_that_delaunay_leaves_out():
    points = np.array([[0.0, 0], [10, 0], [5, 1], [5, -1], [2.5, 0.8], [7.5, -0.8]])
    from scipy.spatial import Delaunay

    faces = Delaunay(points).simplices.astype(np.int64)
    faces = np.where((areas(points, faces) < 0)[:, None], faces[:, ::-1], faces)
    wanted = np.array([[0, 1]])
    before = {tuple(sorted((f[k], f[(k + 1) % 3]))) for f in faces for k in range(3)}
    assert (0, 1) not in before
    recovered = recover_edges(points, faces, wanted)
    after = {tuple(sorted((int(f[k]), int(f[(k + 1) % 3])))) for f in recovered for k in range(3)}
    assert (0, 1) in after
    assert np.isclose(areas(points, recovered).sum(), areas(points, faces).sum())
    assert (areas(points, recovered) > 0).all()


def test_interior_is_what_lies_left_of_the_boundary():
    faces = np.array([[0, 1, 2], [0, 2, 3], [1, 4, 2]])
    boundary = np.array([[0, 1], [1, 2], [2, 3], [3, 0]])
    assert interior_triangles(faces, boundary).tolist() == [[0, 1, 2], [0, 2, 3]]
