"""Gradients of cloth in space against its flat panels, and their unstretched part."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from swifttailor.garment_sewer.pixels.rest_shape import nearest_unstretched, rest_shape
from swifttailor.panel_mesh import mesh_pattern
from swifttailor.pattern import Pattern
from swifttailor.pattern.drafts import draft


@pytest.fixture(scope="module")
def panel_mesh():
    panel = draft("t-shirt").panels[0]
    return mesh_pattern(Pattern((panel,), (), "one panel"), 4.0)


@given(arrays(np.float64, (2, 3), elements=st.floats(-3, 3)))
def test_every_face_has_the_gradient_of_the_map_that_placed_it(panel_mesh, columns):
    shape = rest_shape(panel_mesh)
    flat = np.zeros((panel_mesh.vertex_count, 2))
    flat[panel_mesh.weld] = panel_mesh.flat_vertices
    gradients = shape.gradients(flat @ columns + [5.0, 100.0, -3.0])
    assert np.allclose(gradients, columns, atol=1e-9)


def test_areas_are_those_of_the_panels(panel_mesh):
    shape = rest_shape(panel_mesh)
    area = abs(panel_mesh.pattern.panels[0].signed_area())
    assert shape.area.sum() == pytest.approx(area, rel=0.02)  # chords cut curves off
    assert shape.vertex_area.sum() == pytest.approx(shape.area.sum())


@given(arrays(np.float64, (2, 3), elements=st.floats(-10, 10)))
def test_nearest_unstretched_is_the_polar_factor(gradient):
    left, size, right = np.linalg.svd(gradient, full_matrices=False)
    if size[1] < 1e-2:  # hardly any extent in one direction: what is nearest is a matter of digits
        return
    assert np.allclose(nearest_unstretched(gradient[None])[0], left @ right, atol=1e-6)


def test_nearest_unstretched_of_nothing_is_finite():
    assert np.isfinite(nearest_unstretched(np.zeros((1, 2, 3)))).all()
    assert np.isfinite(nearest_unstretched(np.array([[[1.0, 0, 0], [1.0, 0, 0]]]))).all()
