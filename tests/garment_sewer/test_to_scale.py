"""Sewing at the scale that the network learnt on."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial import KDTree

from swifttailor.body import Body, body_for
from swifttailor.garment.garment import Garment
from swifttailor.garment_sewer.sewer import GarmentSewer
from swifttailor.garment_sewer.to_scale import ScaledSewer, scaled_pattern, sewer_for
from swifttailor.panel_mesh import mesh_pattern
from swifttailor.pattern.drafts import draft
from swifttailor.refitting import fit


@pytest.fixture(scope="module")
def sewer():
    return GarmentSewer.load()


def test_bodies_of_the_default_height_are_not_scaled(sewer):
    assert type(sewer_for(sewer, Body.default())) is GarmentSewer
    assert isinstance(sewer_for(sewer, body_for("children 116")), ScaledSewer)


def test_scaling_there_and_back_is_the_pattern():
    pattern = draft("t-shirt")
    back = scaled_pattern(scaled_pattern(pattern, 1.7), 1 / 1.7)
    for a, b in zip(pattern.panels, back.panels, strict=True):
        for k in range(len(a.edges)):
            assert np.allclose(a.sample_edge(k, 7), b.sample_edge(k, 7), atol=1e-9)
        assert np.allclose(a.placement.translation, b.placement.translation)


def test_a_small_copy_of_the_default_body_wears_a_small_copy_of_the_garment(sewer):
    """The same pattern and body at 0.7 of their size give the same garment at 0.7 of its size."""
    default, factor = Body.default(), 0.7
    small = Body.from_mesh(default.vertices * factor, default.faces, name="small")
    pattern = draft("tank-top")
    large = sewer.sew(pattern, edge_length=4.0)
    scaled = scaled_pattern(pattern, small.measurements.height / default.measurements.height)
    own = sewer_for(sewer, small).sew(scaled, edge_length=4.0 * factor)
    # Its height is measured 0.2 % smaller, so that a panel may be meshed with a vertex less.
    assert abs(len(own.vertices) - len(large.vertices)) <= 0.01 * len(large.vertices)
    assert KDTree(large.vertices).query(own.vertices / factor)[0].mean() < 0.8
    assert own.report["edge_length_cm"] == pytest.approx(2.8)
    assert np.array_equal(own.pattern.panels[0].vertices, scaled.canonical().panels[0].vertices)


def test_a_childs_dress_hangs_from_the_childs_shoulders(sewer):
    child = body_for("children 116")
    pattern = fit(draft("fitted-dress"), child)
    garment = sewer_for(sewer, child).sew(pattern, edge_length=4.0)
    m = child.measurements
    assert m.shoulder_level - 3 < garment.vertices[:, 1].max() < m.neck_level + 4
    assert garment.report["sewing"]["inside_body"] < 0.01


def test_a_garment_has_the_mesh_of_its_pattern_and_its_folder_is_read_back(sewer, tmp_path):
    """Enlarged and made small again, panels whose points lie evenly would be joined in another way."""
    body = body_for("44")
    garment = sewer_for(sewer, body).sew(fit(draft("shirt-dress"), body))
    mesh = mesh_pattern(garment.pattern.canonical(), 2.0)
    assert np.array_equal(garment.mesh.faces, mesh.faces)
    assert np.array_equal(garment.mesh.flat_vertices, mesh.flat_vertices)
    garment.save(tmp_path / "dress")
    again = Garment.load(tmp_path / "dress")
    assert np.allclose(again.vertices, garment.vertices, atol=1e-3)
