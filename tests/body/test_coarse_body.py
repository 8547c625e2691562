from __future__ import annotations

import numpy as np
import pytest

from swifttailor.body import Body
from swifttailor.body.surface_distance import SurfaceTree


def test_a_quarter_of_the_faces_is_the_same_body():
    body = Body.default()
    vertices, faces = body.coarse
    assert len(faces) < 0.3 * len(body.faces)
    distances, _ = SurfaceTree.build(vertices, faces).signed_distance(body.vertices)
    assert np.abs(distances).max() < 0.7 and np.quantile(np.abs(distances), 0.99) < 0.35


def test_it_is_closed_and_in_one_piece():
    vertices, faces = Body.default().coarse
    sides = np.concatenate([faces[:, [k, (k + 1) % 3]] for k in range(3)])
    there, back = ({tuple(s) for s in order.tolist()} for order in (sides, sides[:, ::-1]))
    assert len(there) == len(sides) and there == back, (
        "each edge belongs to two faces, once in each direction"
    )
    assert len(vertices) - len(sides) // 2 + len(faces) == 2


@pytest.mark.parametrize("factor", [0.8, 1.2])
def test_bodies_of_the_same_mesh_have_theirs(factor):
    body = Body.default()
    large = Body("large", body.vertices * factor, body.faces, body.vertex_part, body.measurements)
    np.testing.assert_allclose(large.coarse[0], body.coarse[0] * factor)
    np.testing.assert_array_equal(large.coarse[1], body.coarse[1])


def test_a_mesh_of_ones_own_stays_as_it_is():
    body = Body.default()
    other = Body("other", body.vertices, body.faces[::-1], body.vertex_part, body.measurements)
    np.testing.assert_array_equal(other.coarse[0], body.vertices)
    np.testing.assert_array_equal(other.coarse[1], other.faces)


def test_the_extent_is_that_of_the_vertices():
    body = Body.default()
    np.testing.assert_array_equal(body.extent, [body.vertices.min(axis=0), body.vertices.max(axis=0)])
