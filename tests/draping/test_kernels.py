"""The compiled loops against plain numpy references."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from swifttailor.body import Body
from swifttailor.draping import FABRICS
from swifttailor.draping.cloth import build_cloth
from swifttailor.draping.contact_kernels import edge_hits_face, find_contacts, find_crossings
from swifttailor.draping.field_kernels import sample_distance, sample_field
from swifttailor.draping.intersections import crossing_pairs, mesh_intersections, self_intersections
from swifttailor.draping.neighbor_lists import MARGIN, list_neighbors, no_neighbors
from swifttailor.draping.simulation import _contact_buffers
from swifttailor.draping.xpbd_kernels import hinge_pulls, solve_hinges, solve_springs, spring_shares
from swifttailor.panel_mesh import mesh_pattern
from swifttailor.panel_mesh.topology import edge_faces


def segment_hits_triangle(p, q, a, b, c):
    """Reference: solve p + t (q - p) = a + u (b - a) + v (c - a)."""
    matrix = np.stack([b - a, c - a, p - q], axis=1)
    if abs(np.linalg.det(matrix)) < 1e-10:
        return False
    u, v, t = np.linalg.solve(matrix, p - a)
    return bool(u >= 0 and v >= 0 and u + v <= 1 and 0 <= t <= 1)


def reference_crossings(vertices, edges, faces):
    return {
        (e, f)
        for e, (p, q) in enumerate(edges)
        for f, (a, b, c) in enumerate(faces)
        if len({p, q, a, b, c}) == 5 and segment_hits_triangle(*(vertices[i] for i in (p, q, a, b, c)))
    }


@given(st.integers(0, 10_000))
@settings(max_examples=100, deadline=None)
def test_edge_hits_face_like_the_reference(seed):
    points = np.random.default_rng(seed).uniform(-2, 2, (5, 3))
    hit, _ = edge_hits_face(points, 0, 1, 2, 3, 4)
    assert hit == segment_hits_triangle(*points)


@given(st.integers(0, 1000))
@settings(max_examples=15, deadline=None)
def test_crossings_like_brute_force(seed):
    """A crumpled sheet: every edge-face crossing is found, and only those."""
    rng = np.random.default_rng(seed)
    x, y = np.meshgrid(np.arange(7.0), np.arange(7.0))
    vertices = np.stack([x.ravel(), y.ravel(), np.zeros(49)], axis=1) * 1.5 + rng.normal(0, 0.9, (49, 3))
    corner = (np.arange(6)[:, None] * 7 + np.arange(6)).ravel()
    faces = np.concatenate(
        [np.stack([corner, corner + 1, corner + 7], 1), np.stack([corner + 1, corner + 8, corner + 7], 1)]
    )
    edges, _ = edge_faces(faces)
    found = {(int(e), int(f)) for e, f in crossing_pairs(vertices, edges, faces)}
    assert found == reference_crossings(vertices, edges, faces)
    assert self_intersections(vertices, edges, faces) == len(found)


def test_two_meshes():
    triangle = np.array([[0.0, 0, 0], [4, 0, 0], [0, 4, 0]])
    needle = np.array([[1.0, 1, -1], [1, 1, 1], [9, 9, 9]])
    edges = np.array([[0, 1], [1, 2]])
    assert mesh_intersections(needle, edges, triangle, np.array([[0, 1, 2]])) == 1
    assert mesh_intersections(needle + 10, edges, triangle, np.array([[0, 1, 2]])) == 0


@pytest.fixture(scope="module")
def cloth(request):
    from swifttailor.pattern import Edge, Panel, Pattern

    panel = Panel("cloth", np.array([[0.0, 0], [24, 0], [24, 24], [0, 24]]), (Edge(),) * 4)
    mesh = mesh_pattern(Pattern((panel,)), 2.0)
    return mesh, build_cloth(mesh, FABRICS["cotton"]).arrays


def test_springs_like_the_reference(cloth):
    mesh, arrays = cloth
    rng = np.random.default_rng(1)
    x = np.column_stack([mesh.flat_vertices, np.zeros(len(mesh.flat_vertices))])
    x += rng.normal(0, 0.2, x.shape)
    expected, inverse_dt2 = x.copy(), 1200.0**2
    for (a, b), rest, compliance in zip(arrays.edges, arrays.rest, arrays.compliance, strict=True):
        d = expected[b] - expected[a]
        length = np.linalg.norm(d)
        wa, wb = arrays.inverse_mass[a], arrays.inverse_mass[b]
        push = (length - rest) / (wa + wb + compliance * inverse_dt2) * d / length
        expected[a] += wa * push
        expected[b] -= wb * push
    solve_springs(x, arrays, spring_shares(arrays, inverse_dt2))
    assert np.allclose(x, expected, atol=1e-9)


def test_hinges_keep_the_centre_of_mass_and_flatten(cloth):
    mesh, arrays = cloth
    x = np.column_stack(
        [mesh.flat_vertices, np.random.default_rng(2).normal(0, 0.3, len(mesh.flat_vertices))]
    )
    mass = 1 / arrays.inverse_mass
    center, spread = mass @ x, x[:, 2].std()
    for _ in range(50):
        solve_hinges(x, arrays, hinge_pulls(arrays, 1200.0**2, 1e4))
    assert np.allclose(mass @ x, center, atol=1e-9 * mass.sum() * 100)
    assert x[:, 2].std() < 0.7 * spread


def test_field_lookup_agrees_with_the_body_room():
    field = Body.default().distance_field(spacing=2.0)
    rng = np.random.default_rng(3)
    low, high = field.origin, field.origin + field.spacing * (np.array(field.values.shape) - 1)
    for point in rng.uniform(low, high, (200, 3)):
        d, nx, ny, nz = sample_field(field.values, field.origin, float(field.spacing), *point)
        expected, gradient = field.sample(point[None])
        assert d == pytest.approx(expected[0], abs=1e-3)
        alone = sample_distance(field.values, field.origin, float(field.spacing), *point)
        assert alone == pytest.approx(d, abs=1e-9)
        if np.linalg.norm(gradient[0]) > 0.5:
            assert np.allclose([nx, ny, nz], gradient[0], atol=1e-2)


def test_listed_neighbours_hold_every_crossing(cloth):
    """Two sheets through each other: the solver's short list misses no crossing of far-apart cloth."""
    mesh, arrays = cloth
    x = np.column_stack([mesh.flat_vertices, np.zeros(len(mesh.flat_vertices))])
    # Fold the sheet over so that one half pierces the other at a slant.
    half = x[:, 0] > 12.0
    x[half] = np.column_stack(
        [24.5 - x[half, 0] + 0.3, x[half, 1] + 0.2, 0.25 * (x[half, 0] - 12.0) - 1.0 + 0.05 * x[half, 1]]
    )
    buffers = _contact_buffers(len(x))
    count = find_crossings(x, arrays, buffers, list_neighbors(x, np.zeros_like(x), arrays, no_neighbors()))
    found = set(
        zip(buffers.crossing_edge[:count].tolist(), buffers.crossing_face[:count].tolist(), strict=True)
    )
    all_pairs = {(int(e), int(f)) for e, f in crossing_pairs(x, arrays.edges, arrays.faces)}
    assert len(all_pairs) > 10
    assert found <= all_pairs
    assert len(found) >= 0.9 * len(all_pairs)


def picked_pairs(x, cloth, tangled, lists):
    """Reference: listed pairs that may come to touch, but for those of tangled cloth."""
    found = []
    for p, f in zip(lists.vertex[: lists.count], lists.face[: lists.count], strict=True):
        corners = cloth.faces[f]
        a, b, c = x[corners]
        normal = np.cross(b - a, c - a)
        height = (x[p] - a) @ normal / np.linalg.norm(normal)
        s, t = np.linalg.pinv(np.stack([b - a, c - a], axis=1)) @ (x[p] - a)
        near = abs(height) <= min(cloth.radius[p], cloth.radius[corners].max()) + MARGIN * cloth.spacing
        if near and min(s, t, 1 - s - t) >= -0.3 and not (tangled[p] and tangled[corners].any()):
            found.append((int(p), int(f), float(np.sign(height))))
    return found


def test_contacts_are_the_listed_pairs_that_are_near(cloth):
    """A sheet folded over and pressed through itself, so that some of it is tangled."""
    mesh, arrays = cloth
    x = np.column_stack([mesh.flat_vertices, np.zeros(len(mesh.flat_vertices))])
    half = x[:, 0] > 12.0
    x[half] = np.column_stack(
        [24.5 - x[half, 0] + 0.3, x[half, 1] + 0.2, 0.25 * (x[half, 0] - 12.0) - 1.0 + 0.05 * x[half, 1]]
    )
    buffers = _contact_buffers(len(x))
    lists = list_neighbors(x, np.zeros_like(x), arrays, no_neighbors())
    find_crossings(x, arrays, buffers, lists)
    count = find_contacts(x, arrays, buffers, lists)
    assert buffers.tangled.any()
    found = zip(buffers.vertex[:count], buffers.face[:count], buffers.side[:count], strict=True)
    expected = picked_pairs(x, arrays, buffers.tangled, lists)
    assert 50 < len(expected) < lists.count
    assert [(int(p), int(f), float(side)) for p, f, side in found] == expected
