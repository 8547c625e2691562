from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from shapes import brute_force, icosphere

from swifttailor.body import SurfaceTree, signed_distance
from swifttailor.errors import GeometryError

SPHERE = icosphere(radius=10.0, subdivisions=4)
coordinate = st.floats(-30, 30, allow_nan=False)


@given(st.lists(st.tuples(coordinate, coordinate, coordinate), min_size=1, max_size=20))
@settings(max_examples=60, deadline=None)
def test_sphere_has_the_analytic_distance(points):
    points = np.array(points)
    distance, nearest = signed_distance(*SPHERE, points)
    exact = np.linalg.norm(points, axis=1) - 10.0
    assert np.abs(distance - exact).max() < 0.06  # the sagitta of the facets
    centres = SPHERE[0][SPHERE[1][nearest]].mean(axis=1)
    reach = np.linalg.norm(points - centres, axis=1)
    assert (reach <= np.abs(distance) + 1.2).all()


@given(st.integers(0, 10_000))
@settings(max_examples=25, deadline=None)
def test_random_blobs_agree_with_brute_force(seed):
    random = np.random.default_rng(seed)
    vertices, faces = icosphere(radius=5.0, subdivisions=2)
    vertices = vertices * random.uniform(0.6, 1.6, (len(vertices), 1))
    points = random.uniform(-9, 9, (40, 3))
    distance, _ = signed_distance(vertices, faces, points)
    np.testing.assert_allclose(distance, brute_force(vertices, faces, points), atol=1e-9)


def test_default_body_agrees_with_brute_force(body):
    random = np.random.default_rng(3)
    anywhere = random.uniform(body.vertices.min(0) - 10, body.vertices.max(0) + 10, (40, 3))
    near = body.vertices[random.integers(0, len(body.vertices), 60)] + random.normal(0, 1, (60, 3))
    points = np.concatenate([anywhere, near])
    distance, nearest = body.signed_distance(points)
    np.testing.assert_allclose(distance, brute_force(body.vertices, body.faces, points), atol=1e-9)
    assert (distance < 0).sum() > 10
    corners = body.vertices[body.faces[nearest]]
    assert (np.linalg.norm(corners - points[:, None], axis=2).min(axis=1) >= np.abs(distance) - 1e-9).all()


def test_points_on_the_surface_have_distance_zero(body):
    distance, _ = body.signed_distance(body.vertices[::37])
    assert np.abs(distance).max() < 1e-6


def test_closed_shells_inside_do_not_turn_the_inside_out():
    outer, inner = icosphere(10.0, 3), icosphere(2.0, 2, centre=(3, 0, 0))
    vertices = np.concatenate([outer[0], inner[0]])
    faces = np.concatenate([outer[1], inner[1] + len(outer[0])])
    points = np.array([[0.0, 0, 0], [3.0, 0, 0], [9.0, 0, 0], [11.0, 0, 0]])
    distance, _ = signed_distance(vertices, faces, points)
    assert (np.sign(distance) == [-1, -1, -1, 1]).all()


def test_overlapping_shells_are_inside_once():
    one, two = icosphere(10.0, 3), icosphere(10.0, 3, centre=(12, 0, 0))
    vertices = np.concatenate([one[0], two[0]])
    faces = np.concatenate([one[1], two[1] + len(one[0])])
    distance, _ = signed_distance(vertices, faces, np.array([[6.0, 0, 0], [-9.0, 0, 0], [6.0, 11, 0]]))
    assert (np.sign(distance) == [-1, -1, 1]).all()


def test_small_holes_do_no_harm():
    vertices, faces = icosphere(10.0, 3)
    random = np.random.default_rng(0)
    points = random.uniform(-14, 14, (3000, 3))
    points = points[np.abs(np.linalg.norm(points, axis=1) - 10) > 0.5]
    distance, _ = signed_distance(vertices, np.delete(faces, [5, 200, 777], axis=0), points)
    assert ((distance < 0) == (np.linalg.norm(points, axis=1) < 10)).all()


def test_an_inside_out_surface_is_turned():
    vertices, faces = icosphere(10.0, 2)
    points = np.array([[1.0, 2, 3], [20.0, 0, 0]])
    turned, _ = signed_distance(vertices, faces[:, ::-1], points)
    np.testing.assert_allclose(turned, signed_distance(vertices, faces, points)[0], atol=1e-12)


def test_degenerate_faces_and_one_face_are_survived():
    vertices = np.array([[0.0, 0, 0], [1, 0, 0], [0, 1, 0], [2, 0, 0]])
    distance, nearest = signed_distance(vertices, np.array([[0, 1, 2]]), np.array([[0.2, 0.2, 3.0]]))
    assert distance[0] == pytest.approx(3.0)
    assert nearest[0] == 0
    faces = np.array([[0, 1, 3], [1, 1, 1], [0, 1, 2]])
    distance, _ = signed_distance(vertices, faces, np.array([[1.5, 0, -2.0], [0.25, 0.25, 1.0]]))
    np.testing.assert_allclose(np.abs(distance), [2.0, 1.0])


def test_lattice_is_the_distance_at_its_nodes(body):
    tree = SurfaceTree.build(body.vertices, body.faces)
    origin, shape, spacing = np.array([-40.0, 60.0, -20.0]), (41, 40, 21), 2.0
    values = tree.lattice(origin, spacing, shape, band=5.0)
    nodes = origin + spacing * np.stack(np.meshgrid(*map(np.arange, shape), indexing="ij"), -1).reshape(-1, 3)
    exact = tree.signed_distance(nodes)[0].reshape(shape)
    near = np.abs(exact) < 5
    assert np.abs(values - exact)[near].max() < 1e-5
    assert np.abs(values - exact).max() < 2.0
    assert ((values < 0) == (exact < 0)).all()


@pytest.mark.parametrize(
    ("vertices", "faces", "points", "message"),
    [
        (np.zeros((3, 2)), [[0, 1, 2]], np.zeros((1, 3)), "vertices must have the shape"),
        (np.eye(3), np.zeros((0, 3), int), np.zeros((1, 3)), "M > 0"),
        (np.eye(3), [[0, 1, 7]], np.zeros((1, 3)), "refer to vertices"),
        (np.eye(3) * np.nan, [[0, 1, 2]], np.zeros((1, 3)), "vertices hold a NaN"),
        (np.eye(3), [[0, 1, 2]], np.zeros((1, 2)), "points must have the shape"),
        (np.eye(3), [[0, 1, 2]], np.full((1, 3), np.inf), "points hold"),
    ],
)
def test_bad_arrays_are_refused(vertices, faces, points, message):
    with pytest.raises(GeometryError, match=message):
        signed_distance(vertices, np.array(faces), points)
