"""Cloth that is predicted too short is known, and gets the folds of the coarse drape."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from swifttailor.body import Body
from swifttailor.draping.relax import relax
from swifttailor.errors import SimulationError
from swifttailor.garment_sewer import relaxing
from swifttailor.garment_sewer.crumpling import (
    CRUMPLED,
    SHORT,
    CrumpledGarment,
    crumpled_share,
    folded_like,
)
from swifttailor.garment_sewer.pixels.rest_shape import flat_gradients, rest_shape
from swifttailor.garment_sewer.relaxing import VERY_CRUMPLED, relaxed_where_crumpled
from swifttailor.garment_sewer.sewer import GarmentSewer
from swifttailor.garment_sewer.to_scale import scaled_pattern, sewer_for
from swifttailor.panel_mesh import mesh_pattern
from swifttailor.pattern.drafts import draft
from swifttailor.tailor.reporting import finishing_notes


@pytest.fixture(scope="module")
def mesh():
    return mesh_pattern(draft("t-shirt").canonical(), 4.0)


@pytest.fixture(scope="module")
def flat(mesh):
    """(m, 3) the panels as they are cut, in one plane."""
    return np.pad(mesh.flat_vertices, ((0, 0), (0, 1)))


@pytest.fixture(scope="module")
def sewer():
    return GarmentSewer.load()


@given(turn=st.integers(0, 2**31), along=st.floats(0.3, 1.2), across=st.floats(0.3, 1.2))
def test_cloth_is_crumpled_where_it_is_short_in_any_direction(mesh, flat, turn, along, across):
    turned = Rotation.random(random_state=turn % 2**31).as_matrix()
    placed = (flat * [along, across, 1.0]) @ turned
    is_short = min(along, across) < SHORT
    if abs(min(along, across) - SHORT) > 1e-6:
        assert crumpled_share(mesh, placed) == pytest.approx(float(is_short))


def test_the_share_is_that_of_the_area(mesh, flat):
    first = mesh.flat_panel == 0
    shape = rest_shape(mesh)
    area = shape.area[mesh.flat_panel[shape.corners[:, 0]] == 0].sum() / shape.area.sum()
    assert crumpled_share(mesh, np.where(first[:, None], 0.5 * flat, flat)) == pytest.approx(area)


def test_the_share_is_that_of_singular_values(mesh, flat):
    rough = flat + np.random.default_rng(0).normal(0.0, 1.0, flat.shape)
    shape = rest_shape(mesh)
    stretch = np.linalg.svd(flat_gradients(mesh, shape, rough), compute_uv=False)
    wanted = shape.area[stretch[:, 1] < SHORT].sum() / shape.area.sum()
    assert 0.1 < wanted < 0.9
    assert crumpled_share(mesh, rough) == pytest.approx(wanted)


def test_folds_are_taken_and_places_kept(mesh, flat):
    """Waves of 4 cm come from the folded cloth, a shift and a wide bend from the prediction."""
    wide = 3.0 * np.sin(mesh.welded_mean(flat)[mesh.weld][:, :1] / 60.0) * [0.0, 0.0, 1.0]
    predicted = np.add(flat, [5.0, -2.0, 1.0]) + wide
    noise = np.random.default_rng(0).normal(0.0, 0.5, (mesh.vertex_count, 3))[mesh.weld]
    folded = flat + noise
    found = folded_like(mesh, predicted, folded)
    assert np.abs(found - noise - predicted).mean() < 0.25 * np.abs(noise).mean() + 0.1
    shifted = np.add(folded, [1.0, 2.0, 3.0])
    assert np.allclose(folded_like(mesh, shifted, folded), shifted)


def test_wide_skirts_come_out_crumpled_and_are_relaxed(sewer):
    skirt = sewer.sew(draft("circle-skirt"), edge_length=4.0)
    assert isinstance(skirt, CrumpledGarment) and skirt.report["sewing"]["crumpled"] > CRUMPLED
    stages = []
    relaxed = relaxed_where_crumpled(skirt, progress=lambda stage, share: stages.append(stage))
    frames = 40 if skirt.report["sewing"]["crumpled"] > VERY_CRUMPLED else 20
    assert relaxed.report["relaxed_frames"] == frames and "relaxing" in relaxed.report["seconds"]
    assert stages[-1] == "relaxing"
    before, after = (crumpled_share(g.mesh, g.vertices[g.mesh.weld]) for g in (skirt, relaxed))
    assert after < 0.5 * before, "the cloth has its length again"
    moved = np.linalg.norm(relaxed.vertices - skirt.vertices, axis=1)
    assert np.median(moved) < 12.0, "and hangs where it was"
    assert "--no-relax" in finishing_notes(relaxed)[0]


def test_what_is_not_crumpled_stays_as_it_is(sewer):
    shirt = sewer.sew(draft("t-shirt"), edge_length=4.0)
    assert shirt.report["sewing"]["crumpled"] < CRUMPLED
    assert relaxed_where_crumpled(shirt) is shirt


def test_cloth_that_goes_to_infinity_is_left_and_said(sewer, monkeypatch):
    def torn(*_, **__):
        raise SimulationError("The cloth moved to infinity while it was relaxed.")

    skirt = sewer.sew(draft("circle-skirt"), edge_length=6.0)
    monkeypatch.setattr("swifttailor.draping.relax.relax", torn)
    left = relaxing.relaxed_where_crumpled(skirt)
    assert np.array_equal(left.vertices, skirt.vertices)
    assert "infinity" in finishing_notes(left)[0]


def test_what_would_pass_through_itself_more_is_left_and_said(sewer, monkeypatch):
    skirt = sewer.sew(draft("circle-skirt"), edge_length=6.0)
    tangled = skirt.vertices.copy()
    tangled[::2] *= [-1.0, 1.0, 1.0]
    monkeypatch.setattr("swifttailor.draping.relax.relax", lambda one, **_: replace(one, vertices=tangled))
    left = relaxing.relaxed_where_crumpled(skirt)
    assert np.array_equal(left.vertices, skirt.vertices)
    assert "passed through itself" in finishing_notes(left)[0]


@pytest.mark.parametrize(
    ("crumpled", "drop", "taken"), [(0.2, 2.0, True), (0.2, 3.0, False), (0.4, 3.0, True)]
)
def test_what_slips_is_left_where_it_was(sewer, monkeypatch, crumpled, drop, taken):
    skirt = sewer.sew(draft("circle-skirt"), edge_length=6.0)
    skirt = replace(skirt, report=skirt.report | {"sewing": {"crumpled": crumpled}})
    fallen = skirt.vertices - [0.0, drop, 0.0]
    report = skirt.report | {"seconds": {"relaxing": 0.1}}
    monkeypatch.setattr(
        "swifttailor.draping.relax.relax", lambda one, **_: replace(one, vertices=fallen, report=report)
    )
    left = relaxing.relaxed_where_crumpled(skirt)
    assert np.array_equal(left.vertices, fallen if taken else skirt.vertices)
    assert taken or "slipped" in finishing_notes(left)[0]


@pytest.mark.parametrize(("share", "taken"), [(0.9, True), (1.1, False)])
def test_a_fold_may_touch_itself(sewer, monkeypatch, share, taken):
    skirt = sewer.sew(draft("circle-skirt"), edge_length=6.0)
    fallen = skirt.vertices - [0.0, 1.0, 0.0]
    monkeypatch.setattr("swifttailor.draping.relax.relax", lambda one, **_: replace(one, vertices=fallen))
    more = share * relaxing.MORE_CROSSINGS * len(skirt.mesh.faces)
    monkeypatch.setattr(relaxing, "_crossings", lambda _, v: 5 + more * np.array_equal(v, fallen))
    assert np.array_equal(relaxing.relaxed_where_crumpled(skirt).vertices, fallen) == taken


def test_folds_are_of_the_scale_of_the_garment(sewer):
    pattern, factor = draft("circle-skirt"), 0.7
    default = Body.default()
    small = Body.from_mesh(default.vertices * factor, default.faces, name="small")
    own = sewer_for(sewer, small).sew(scaled_pattern(pattern, factor), edge_length=4.0 * factor)
    usual = sewer.sew(pattern, edge_length=4.0)
    assert isinstance(own, CrumpledGarment) and isinstance(usual, CrumpledGarment)
    for mine, wanted in ((own.vertices, usual.vertices), (own.folded, usual.folded)):
        assert np.ptp(mine, axis=0) == pytest.approx(factor * np.ptp(wanted, axis=0), rel=0.1)


def test_relaxing_for_no_time_moves_nothing(sewer):
    shirt = sewer.sew(draft("t-shirt"), edge_length=6.0)
    assert np.array_equal(relax(shirt, frames=0).vertices, shirt.vertices)
