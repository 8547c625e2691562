"""Panels sewn around the body without physics."""

from __future__ import annotations

import numpy as np
import pytest

from swifttailor.draping.placement import place_vertices
from swifttailor.garment_sewer.pixels.rest_shape import rest_shape
from swifttailor.garment_sewer.pixels.sewn_prior import (
    SewingSettings,
    sew_around_body,
    vertices_ignoring_arms,
)
from swifttailor.panel_mesh import mesh_pattern
from swifttailor.pattern.drafts import draft


@pytest.fixture(scope="module", params=["t-shirt", "shirt-dress", "trousers"])
def mesh(request):
    return mesh_pattern(draft(request.param).canonical(), 6.0)


@pytest.fixture(scope="module")
def sewn(mesh, body_distance):
    return sew_around_body(mesh, body_distance)


def test_lies_outside_the_body(mesh, sewn, body_distance):
    distance, _ = body_distance.sample(sewn, vertices_ignoring_arms(mesh))
    assert (distance > -0.1).mean() > 0.99
    assert np.median(distance) < 12  # and not far from it


def test_is_far_less_stretched_than_the_placed_panels(mesh, sewn):
    def stretch(vertices):
        shape = rest_shape(mesh)
        size = np.linalg.norm(shape.gradients(vertices), axis=2)
        return float(np.average(np.abs(size - 1).mean(axis=1), weights=shape.area))

    assert stretch(sewn) < 0.12
    assert stretch(sewn) < 0.5 * stretch(place_vertices(mesh))


def test_goes_all_around_the_body(mesh, sewn):
    middle = np.abs(sewn[:, 0]) < 8
    assert sewn[middle, 2].max() > 5
    assert sewn[middle, 2].min() < -5


def test_is_the_same_every_time(mesh, sewn, body_distance):
    assert np.array_equal(sewn, sew_around_body(mesh, body_distance))


def test_without_iterations_only_moves_out_of_the_body(mesh, body_distance):
    still = sew_around_body(mesh, body_distance, SewingSettings(iterations=0))
    placed = place_vertices(mesh)
    outside = body_distance.sample(placed, vertices_ignoring_arms(mesh))[0] > 0.4
    assert np.array_equal(still[outside], placed[outside])


def test_a_finer_mesh_is_sewn_to_about_the_same_place(mesh, sewn, body_distance):
    from scipy.spatial import KDTree

    fine_mesh = mesh_pattern(mesh.pattern, 3.0)
    fine = sew_around_body(fine_mesh, body_distance)
    away, _ = KDTree(fine).query(sewn)
    assert away.mean() < 2.5
