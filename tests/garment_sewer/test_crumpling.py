"""Cloth that is predicted too short is smoothed and grows to its length; all cloth falls for a moment."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from swifttailor.body import Body
from swifttailor.draping.cloth import build_cloth
from swifttailor.draping.intersections import self_intersections
from swifttailor.draping.known_fabrics import get_fabric
from swifttailor.draping.relax import (
    CONTACT_INTERVAL,
    FRAMES,
    GROWING_FRAMES,
    GROWING_SUBSTEPS,
    SUBSTEPS,
    relax,
)
from swifttailor.errors import SimulationError
from swifttailor.garment_sewer import relaxing
from swifttailor.garment_sewer.crumpling import CRUMPLED, SHORT, crumpled_share, smoothed_where_crumpled
from swifttailor.garment_sewer.pixels.rest_shape import flat_gradients, rest_shape
from swifttailor.garment_sewer.relaxing import CRUMPLED_FRAMES, VERY_CRUMPLED, relaxed
from swifttailor.garment_sewer.sewer import GarmentSewer
from swifttailor.garment_sewer.to_scale import scaled_pattern, sewer_for
from swifttailor.panel_mesh import mesh_pattern
from swifttailor.panel_mesh.topology import edge_faces
from swifttailor.pattern.check import panel_regions
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


def _crossings(mesh, vertices):
    return self_intersections(vertices, edge_faces(mesh.faces)[0], mesh.faces)


@pytest.fixture(scope="module")
def shirt(sewer):
    return sewer.sew(draft("t-shirt", neck_widening=1.5), edge_length=3.0)


@pytest.fixture(scope="module")
def crumpled(shirt):
    """(v, 3) the shirt, stretched so that nothing is short; its left half is short and rough."""
    return _squeezed(shirt) + np.where(shirt.vertices[:, :1] > 10.0, _noise(shirt), 0.0)


def _squeezed(shirt):
    low = (shirt.vertices - [0.0, 130.0, 0.0]) * [2.0, 0.4, 2.0] + [0.0, 260.0, 0.0]
    return np.where(shirt.vertices[:, :1] > 10.0, low, 2.0 * shirt.vertices)


def _noise(shirt):
    return np.random.default_rng(0).normal(0.0, 1.5, shirt.vertices.shape)


def test_crumpled_cloth_is_smoothed_and_the_rest_stays(shirt, crumpled):
    smooth = smoothed_where_crumpled(shirt.mesh, crumpled, np.zeros(len(crumpled), dtype=bool))
    far = crumpled[:, 0] < -40.0
    assert far.any() and np.array_equal(smooth[far], crumpled[far])
    even = smoothed_where_crumpled(shirt.mesh, _squeezed(shirt), np.zeros(len(crumpled), dtype=bool))
    left = shirt.vertices[:, 0] > 15.0
    assert np.abs(smooth - even)[left].mean() < 0.5 * np.abs(_noise(shirt))[left].mean(), "noise is gone"


def test_what_is_held_or_not_crumpled_is_where_it_was(shirt, crumpled):
    everything = np.ones(len(crumpled), dtype=bool)
    assert np.array_equal(smoothed_where_crumpled(shirt.mesh, crumpled, everything), crumpled)
    some = np.random.default_rng(1).random(len(crumpled)) < 0.3
    smooth = smoothed_where_crumpled(shirt.mesh, crumpled, some)
    assert np.array_equal(smooth[some], crumpled[some]) and not np.allclose(smooth, crumpled)
    assert crumpled_share(shirt.mesh, 2.0 * shirt.vertices[shirt.mesh.weld]) == 0.0
    assert np.array_equal(
        smoothed_where_crumpled(shirt.mesh, 2.0 * shirt.vertices, ~everything), 2.0 * shirt.vertices
    )


def test_wide_skirts_come_out_crumpled_and_grow(sewer):
    skirt = sewer.sew(draft("circle-skirt"), edge_length=4.0)
    assert skirt.report["sewing"]["crumpled"] > CRUMPLED
    stages = []
    fallen = relaxed(skirt, progress=lambda stage, share: stages.append(stage))
    times = 2 if skirt.report["sewing"]["crumpled"] > VERY_CRUMPLED else 1
    assert fallen.report["relaxed_frames"] == times * CRUMPLED_FRAMES
    assert "relaxing" in fallen.report["seconds"] and stages[-1] == "relaxing"
    before, after = (crumpled_share(g.mesh, g.vertices[g.mesh.weld]) for g in (skirt, fallen))
    assert after < 0.1 * before, "the cloth has its length again"
    assert _crossings(skirt.mesh, skirt.vertices) > 20 > 5 >= _crossings(skirt.mesh, fallen.vertices)
    moved = np.linalg.norm(fallen.vertices - skirt.vertices, axis=1)
    assert np.median(moved) < 12.0, "and hangs where it was"
    assert "--no-relax" in finishing_notes(fallen)[0]


def test_what_is_not_crumpled_falls_for_a_moment(sewer):
    shirt = sewer.sew(draft("t-shirt"), edge_length=3.0)
    assert shirt.report["sewing"]["crumpled"] < CRUMPLED
    fallen = relaxed(shirt)
    assert fallen.report["relaxed_frames"] == FRAMES
    edges = edge_faces(shirt.mesh.faces)[0]
    cut = build_cloth(shirt.mesh, get_fabric("cotton")).arrays

    def strain(vertices):
        lengths = np.linalg.norm(np.diff(vertices[cut.edges], axis=1)[:, 0], axis=1)
        return np.percentile(np.abs(lengths / cut.rest - 1.0), 95)

    assert len(edges) and strain(fallen.vertices) < 0.8 * strain(shirt.vertices)
    assert np.median(np.linalg.norm(fallen.vertices - shirt.vertices, axis=1)) < 1.5


@pytest.mark.parametrize("name", ["shirt", "polo-shirt"])
def test_collars_lie_on_the_bodice_and_not_in_it(sewer, name):
    made = sewer.sew(draft(name))
    assert _crossings(made.mesh, made.vertices) > 10 > 5 >= _crossings(made.mesh, relaxed(made).vertices)


def test_collars_of_close_shirts_stay_turned_down(sewer):
    fallen = relaxed(sewer.sew(draft("shirt", chest_ease=4.0, waist_shaping=2.5)))
    mesh = fallen.mesh
    heights = {}
    for part in ("collar_back", "collar_fall_back"):
        of_part = np.array([part in panel.name for panel in mesh.pattern.panels])
        heights[part] = fallen.vertices[mesh.weld[of_part[mesh.flat_panel]], 1]
    assert np.median(heights["collar_fall_back"]) < np.median(heights["collar_back"]) + 1.0


def test_sleeves_and_hoods_are_not_smoothed(sewer):
    """While they are smooth they are short, and slip up the arm and off the head."""
    pattern = draft("robe")
    robe = sewer.sew(pattern, edge_length=4.0)
    report = robe.report | {"sewing": robe.report["sewing"] | {"crumpled": 0.3}}
    fallen = relaxed(replace(robe, report=report))
    on_arm = np.array([region == "arm" for region in panel_regions(pattern).values()])
    names = [panel.name for panel in pattern.panels]
    arm = np.zeros(robe.mesh.vertex_count, dtype=bool)
    order = [names.index(panel.name) for panel in robe.mesh.pattern.panels]
    arm[robe.mesh.weld[on_arm[order][robe.mesh.flat_panel]]] = True
    assert arm.any()
    ends = np.abs(robe.vertices[arm, 0]).max(), np.abs(fallen.vertices[arm, 0]).max()
    assert ends[1] > ends[0] - 5.0


def test_cloth_that_goes_to_infinity_is_left_and_said(sewer, monkeypatch):
    def torn(*_, **__):
        raise SimulationError("The cloth moved to infinity while it was relaxed.")

    skirt = sewer.sew(draft("circle-skirt"), edge_length=6.0)
    monkeypatch.setattr("swifttailor.draping.relax.relax", torn)
    left = relaxing.relaxed(skirt)
    assert np.array_equal(left.vertices, skirt.vertices)
    assert "infinity" in finishing_notes(left)[0]


def test_what_would_pass_through_itself_more_is_left_and_said(sewer, monkeypatch):
    skirt = sewer.sew(draft("circle-skirt"), edge_length=6.0)
    tangled = skirt.vertices.copy()
    tangled[::2] *= [-1.0, 1.0, 1.0]
    monkeypatch.setattr("swifttailor.draping.relax.relax", lambda one, **_: replace(one, vertices=tangled))
    left = relaxing.relaxed(skirt)
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
    left = relaxing.relaxed(skirt)
    assert np.array_equal(left.vertices, fallen if taken else skirt.vertices)
    assert taken or "slipped" in finishing_notes(left)[0]


@pytest.mark.parametrize(("share", "taken"), [(0.9, True), (1.1, False)])
def test_a_fold_may_touch_itself(sewer, monkeypatch, share, taken):
    skirt = sewer.sew(draft("circle-skirt"), edge_length=6.0)
    fallen = skirt.vertices - [0.0, 1.0, 0.0]
    monkeypatch.setattr("swifttailor.draping.relax.relax", lambda one, **_: replace(one, vertices=fallen))
    more = share * relaxing.MORE_CROSSINGS * len(skirt.mesh.faces)
    monkeypatch.setattr(relaxing, "_crossings", lambda _, v: 5 + more * np.array_equal(v, fallen))
    assert np.array_equal(relaxing.relaxed(skirt).vertices, fallen) == taken


def test_crossings_of_the_prediction_are_counted_only_where_they_matter(sewer, monkeypatch):
    skirt = sewer.sew(draft("circle-skirt"), edge_length=6.0)
    fallen = skirt.vertices - [0.0, 1.0, 0.0]
    monkeypatch.setattr("swifttailor.draping.relax.relax", lambda one, **_: replace(one, vertices=fallen))
    counted = []
    monkeypatch.setattr(relaxing, "_crossings", lambda _, v: counted.append(v) or 0)
    assert np.array_equal(relaxing.relaxed(skirt).vertices, fallen)
    assert len(counted) == 1 and np.array_equal(counted[0], fallen)


def test_cloth_grows_in_fewer_substeps_than_it_falls(sewer, monkeypatch):
    told = []

    def advance(x, v, cloth, field, held, contacts, lists, clearance, step):
        told.append((step.substeps, step.contact_interval, round(step.substeps * step.step * 60, 9)))
        return 1.0, 0, 0, lists

    monkeypatch.setattr("swifttailor.draping.simulation.advance_frame", advance)
    relaxing.relaxed(sewer.sew(draft("circle-skirt"), edge_length=6.0))
    assert told[0] == (GROWING_SUBSTEPS, CONTACT_INTERVAL, 1.0)
    assert told[GROWING_FRAMES:] == [(SUBSTEPS, CONTACT_INTERVAL, 1.0)] * (len(told) - GROWING_FRAMES)
    assert GROWING_SUBSTEPS < SUBSTEPS and len(told) > GROWING_FRAMES
    told.clear()
    monkeypatch.setattr(relaxing, "legs_apart", lambda mesh, start, hips: start)
    relaxing.relaxed(sewer.sew(draft("circle-skirt"), edge_length=6.0))
    assert set(told) == {(SUBSTEPS, 5, 1.0)}


def test_garments_of_another_scale_fall_as_well(sewer):
    pattern, factor = draft("circle-skirt"), 0.7
    default = Body.default()
    small = Body.from_mesh(default.vertices * factor, default.faces, name="small")
    own = sewer_for(sewer, small).sew(scaled_pattern(pattern, factor), edge_length=4.0 * factor)
    usual = sewer.sew(pattern, edge_length=4.0)
    assert np.ptp(own.vertices, axis=0) == pytest.approx(factor * np.ptp(usual.vertices, axis=0), rel=0.1)
    fallen = relaxed(own, body=small)
    assert fallen.report["relaxed_frames"] >= CRUMPLED_FRAMES
    assert crumpled_share(own.mesh, fallen.vertices[own.mesh.weld]) < 0.05


def test_relaxing_for_no_time_moves_nothing(sewer):
    shirt = sewer.sew(draft("t-shirt"), edge_length=6.0)
    assert np.array_equal(relax(shirt, frames=0).vertices, shirt.vertices)
