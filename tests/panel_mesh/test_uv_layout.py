from __future__ import annotations

import numpy as np
import pytest
import shapely
from hypothesis import given, settings
from hypothesis import strategies as st

from swifttailor.panel_mesh import mesh_pattern
from swifttailor.panel_mesh.uv_layout import GUTTER, lay_out_uv, pack_square
from swifttailor.pattern.drafts import draft


def test_uv_keeps_one_scale_and_lengths_everywhere(tube):
    mesh = tube.mesh
    uv, scale = lay_out_uv(mesh)
    assert uv.min() >= 0 and uv.max() <= 1
    flat = mesh.flat_vertices[mesh.flat_faces]
    laid = uv[mesh.flat_faces] * scale
    for a, b in ((0, 1), (1, 2), (2, 0)):
        np.testing.assert_allclose(
            np.linalg.norm(flat[:, a] - flat[:, b], axis=1),
            np.linalg.norm(laid[:, a] - laid[:, b], axis=1),
            atol=1e-9,
        )


def test_right_side_of_every_panel_faces_the_viewer_of_the_texture(tube):
    uv = lay_out_uv(tube.mesh)[0][tube.mesh.flat_faces]
    one, two = uv[:, 1] - uv[:, 0], uv[:, 2] - uv[:, 0]
    assert (one[:, 0] * two[:, 1] - one[:, 1] * two[:, 0] > 0).all()


def test_panels_stay_upright(tube):
    uv, scale = lay_out_uv(tube.mesh)
    for panel in (0, 1):
        of = tube.mesh.flat_panel == panel
        difference = uv[of, 1] * scale - tube.mesh.flat_vertices[of, 1]
        assert np.ptp(difference) < 1e-9


def test_sleeves_stand_upright_with_the_shoulder_up_and_their_right_side_out():
    mesh = mesh_pattern(draft("t-shirt", sleeve_length=60.0), 3.0)
    uv, scale = lay_out_uv(mesh)
    lying, _ = lay_out_uv(mesh, sleeves_upright=False)
    corners = uv[mesh.flat_faces]
    one, two = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    assert (one[:, 0] * two[:, 1] - one[:, 1] * two[:, 0] > 0).all()
    for k, panel in enumerate(mesh.pattern.panels):
        own = mesh.flat_panel == k
        wide, high = np.ptp(uv[own], axis=0) * scale
        if "sleeve" not in panel.name:
            assert np.corrcoef(uv[own, 1], mesh.flat_vertices[own, 1])[0, 1] == pytest.approx(1.0)
            continue
        assert high > 1.5 * wide and np.ptp(lying[own, 0]) > np.ptp(lying[own, 1])
        world = panel.to_world(mesh.flat_vertices[own])
        assert np.corrcoef(uv[own, 1], -np.abs(world[:, 0]))[0, 1] > 0.9, "the hand is down"


def test_panels_do_not_overlap(tube):
    mesh = tube.mesh
    uv, _ = lay_out_uv(mesh)
    shapes = [shapely.union_all(shapely.polygons(uv[mesh.flat_faces[mesh.face_panel == k]])) for k in (0, 1)]
    assert shapes[0].distance(shapes[1]) >= GUTTER * 0.99
    assert shapely.box(0, 0, 1, 1).contains(shapely.union_all(shapes))


def test_layout_is_deterministic(tube):
    np.testing.assert_array_equal(lay_out_uv(tube.mesh)[0], lay_out_uv(tube.mesh)[0])
    np.testing.assert_array_equal(tube.uv, lay_out_uv(tube.mesh)[0])
    assert tube.uv_scale == lay_out_uv(tube.mesh)[1]


side = st.floats(0.0, 1400.0).map(lambda x: round(x, 3))


@settings(max_examples=60, deadline=None)
@given(st.lists(st.tuples(side, side), min_size=1, max_size=40))
def test_packing_never_overlaps_and_keeps_the_gutter(sizes):
    sizes = np.array(sizes)
    corners, square = pack_square(sizes)
    gutter = GUTTER * square * (1 - 1e-9)
    low, high = corners, corners + sizes
    assert low.min() >= gutter and high.max() <= square - gutter
    apart = np.maximum(low[:, None] - high[None], low[None] - high[:, None]).max(axis=2)
    np.fill_diagonal(apart, np.inf)
    assert apart.min() >= gutter


@pytest.mark.parametrize("count", [1, 4, 9, 30])
def test_equal_boxes_fill_the_square_well(count):
    _, square = pack_square(np.full((count, 2), 10.0))
    assert count * 100 / square**2 > 0.45
