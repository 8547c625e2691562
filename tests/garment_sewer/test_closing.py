"""Seams of predicted panels are closed without creases, and cloth is taken out of the body."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from swifttailor.errors import GeometryError
from swifttailor.garment_sewer.closing import ClosingSettings, close_seams, seam_gaps
from swifttailor.garment_sewer.covering import cover_body
from swifttailor.garment_sewer.pixels.rest_shape import flat_gradients, limit_stretch, rest_shape
from swifttailor.garment_sewer.pixels.sewn_prior import sew_around_body, vertices_ignoring_arms
from swifttailor.panel_mesh import mesh_pattern
from swifttailor.pattern.drafts import draft


@pytest.fixture(scope="module")
def mesh():
    return mesh_pattern(draft("t-shirt").canonical(), 3.0)


@pytest.fixture(scope="module")
def garment(mesh, body_distance):
    """(v, 3) a garment around the body, clear of it."""
    vertices = sew_around_body(mesh, body_distance)
    return body_distance.push_out(vertices, vertices_ignoring_arms(mesh), 1.0, rounds=3)


def edge_lengths(mesh, vertices):
    faces = mesh.faces
    edges = np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]])
    return np.linalg.norm(vertices[edges[:, 0]] - vertices[edges[:, 1]], axis=1)


def test_what_fits_already_stays(mesh, garment, body_distance):
    closed = close_seams(mesh, garment[mesh.weld], body_distance, ClosingSettings(longest=np.inf))
    moved = np.abs(closed - garment).max(axis=1) > 1e-6
    assert moved.mean() < 0.03  # in the hollow of the armpit, where edges pass through the body
    assert not depths(mesh, closed, body_distance)[0].any() and depths(mesh, garment, body_distance)[0].any()


def depths(mesh, vertices, body_distance):
    """(e,) how far the middle of each edge lies in the body, cm, and (v,) each vertex."""
    edges = np.unique(np.sort(mesh.faces[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1), axis=0)
    ignores = vertices_ignoring_arms(mesh)
    middles = body_distance.sample(vertices[edges].mean(axis=1), ignores[edges].any(axis=1))[0]
    return np.maximum(-middles, 0), np.maximum(-body_distance.sample(vertices, ignores)[0], 0)


def test_gaps_are_spread_into_the_panels(mesh, garment):
    """A panel is predicted 2 cm off: averaging stretches one row of faces, closing does not."""
    flat = garment[mesh.weld] + np.where(mesh.flat_panel == 0, 2.0, 0.0)[:, None] * [0.0, 0.0, 1.0]
    assert np.percentile(seam_gaps(mesh, flat), 90) == pytest.approx(2.0)
    settings = ClosingSettings(longest=np.inf)
    before = edge_lengths(mesh, garment)
    averaged, closed = (
        np.abs(edge_lengths(mesh, x) - before).max()
        for x in (mesh.welded_mean(flat), close_seams(mesh, flat, None, settings))
    )
    assert closed < 0.45 * averaged


def test_nothing_stays_inside_the_body(mesh, garment, body_distance):
    ignores = vertices_ignoring_arms(mesh)
    sunk = garment - body_distance.sample(garment, ignores)[1] * 2.5
    assert (body_distance.sample(sunk, ignores)[0] < 0).mean() > 0.2
    closed = close_seams(mesh, sunk[mesh.weld], body_distance)
    distance, _ = body_distance.sample(closed, ignores)
    assert (distance < 0).mean() < 0.002
    assert np.linalg.norm(closed - sunk, axis=1).mean() < 2.5


def test_cloth_that_is_predicted_too_long_is_shortened(mesh, garment):
    stretched = garment * 1.2
    shape = rest_shape(mesh)

    def longest(vertices):
        return np.percentile(np.linalg.svd(shape.gradients(vertices), compute_uv=False)[:, 0], 75)

    settings = ClosingSettings(stay=0.0005)
    closed = close_seams(mesh, stretched[mesh.weld], None, settings)
    assert longest(closed) < longest(stretched) - 0.08


def test_is_the_solution_of_the_least_squares_problem(mesh, garment):
    """Against a dense solve of the stated sum of squares."""
    small = mesh_pattern(draft("fitted-skirt").canonical(), 12.0)
    flat = np.random.default_rng(0).normal(0, 20, (len(small.weld), 3))
    settings = ClosingSettings(stay=0.1, longest=np.inf)
    shape = rest_shape(small)
    weight = np.sqrt(np.repeat(shape.area, 2))
    stay = np.sqrt(0.1 * np.maximum(shape.vertex_area, 1e-2))
    matrix = np.concatenate([weight[:, None] * shape.gradient.toarray(), np.diag(stay)])
    wanted = flat_gradients(small, shape, flat).reshape(-1, 3)
    right = np.concatenate([weight[:, None] * wanted, stay[:, None] * small.welded_mean(flat)])
    expected = np.linalg.lstsq(matrix, right, rcond=None)[0]
    assert np.allclose(close_seams(small, flat, None, settings), expected, atol=1e-6)


@given(arrays(np.float64, (2, 3), elements=st.floats(-3, 3)), st.floats(0.5, 1.5))
def test_stretch_is_limited_in_both_directions(gradient, longest):
    limited = limit_stretch(gradient[None], longest)[0]
    left, size, right = np.linalg.svd(gradient, full_matrices=False)
    assert np.allclose(limited, left * np.minimum(size, longest) @ right, atol=1e-6)


def test_gradients_of_joined_panels_are_those_of_the_garment(mesh, garment):
    shape = rest_shape(mesh)
    assert np.allclose(flat_gradients(mesh, shape, garment[mesh.weld]), shape.gradients(garment))
    with pytest.raises(GeometryError, match="flat vertices"):
        flat_gradients(mesh, shape, garment)


def test_cloth_bridges_the_cleft_of_the_seat(body_distance):
    """A seam in the hollow comes out, where the body between it and the next vertices would show."""
    mesh = mesh_pattern(draft("trousers").canonical(), 2.0)
    ignores = vertices_ignoring_arms(mesh)
    vertices = body_distance.push_out(sew_around_body(mesh, body_distance), ignores, 0.3, rounds=8)
    seat = (np.abs(vertices[:, 0]) < 1.0) & (vertices[:, 2] < 0) & (np.abs(vertices[:, 1] - 83.0) < 5.0)
    assert seat.any()
    sunk = vertices + np.where(seat, 4.0, 0.0)[:, None] * [0.0, 0.0, 1.0]
    sunk = body_distance.push_out(sunk, ignores, 0.3, rounds=8)
    covered = cover_body(mesh, sunk, body_distance, ignores)
    before, after = (depths(mesh, x, body_distance)[0] for x in (sunk, covered))
    assert before.max() > 3.0 and after.max() < 0.15 and after.sum() < 0.03 * before.sum()
    again = cover_body(mesh, covered, body_distance, ignores)
    assert (np.abs(again - covered).max(axis=1) > 0.05).mean() < 0.01
    assert depths(mesh, again, body_distance)[0].max() <= after.max()
