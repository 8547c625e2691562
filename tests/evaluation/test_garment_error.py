"""A predicted garment against its drape."""

from __future__ import annotations

import numpy as np
import pytest

from swifttailor.body import Body
from swifttailor.errors import GeometryError
from swifttailor.evaluation.garment_error import measure_error, summarize
from swifttailor.evaluation.garment_kind import garment_kind
from swifttailor.garment_sewer.closing import seam_gaps
from swifttailor.garment_sewer.pixels.body_distance import BodyDistance
from swifttailor.panel_mesh import mesh_pattern
from swifttailor.pattern.drafts import draft


@pytest.fixture(scope="module")
def mesh():
    return mesh_pattern(draft("t-shirt").canonical(), 5.0)


@pytest.fixture(scope="module")
def body() -> BodyDistance:
    return BodyDistance.of(Body.default())


@pytest.fixture
def drape(mesh):
    return np.random.default_rng(0).normal([0, 100, 60], 1, (mesh.vertex_count, 3))


def test_the_drape_itself_has_no_error(mesh, body, drape):
    error = measure_error(mesh, drape[mesh.weld], drape, body)
    assert (
        error.mean == error.p90 == error.offset == error.seam_gap == error.seam_gap_p95 == error.inside == 0
    )
    assert error.kind == "upper"


def test_a_shift_is_all_offset(mesh, body, drape):
    error = measure_error(mesh, drape[mesh.weld] + [3.0, 0, 4.0], drape, body)
    assert error.mean == pytest.approx(5)
    assert error.p90 == pytest.approx(5)
    assert error.offset == pytest.approx(5)
    assert error.seam_gap == pytest.approx(0)


def test_panels_pulled_apart_leave_gaps(mesh, body, drape):
    flat = drape[mesh.weld] + np.array([0.0, 2.0, 0.0]) * mesh.flat_panel[:, None]
    gaps = seam_gaps(mesh, flat)
    expected = []
    for stitch in mesh.pattern.stitches:
        a, b = (mesh.pattern.panel_index(r.panel) for r in stitch.sides)
        run = mesh.edge_vertices[a][stitch.first.edge]
        expected += [2.0 * abs(a - b)] * len(run)
    assert np.allclose(gaps, expected)


def test_what_is_inside_the_body_is_counted(mesh, body):
    drape = np.full((mesh.vertex_count, 3), [0.0, 110.0, 0.0])  # in the middle of the belly
    drape[::2] = [0, 110, 200]
    error = measure_error(mesh, drape[mesh.weld], drape, body)
    assert error.inside == pytest.approx(0.5, abs=0.01)


def test_merging_takes_the_mean(mesh, drape):
    noise = np.random.default_rng(1).normal(0, 1, (len(mesh.weld), 3))
    merged = mesh.welded_mean(drape[mesh.weld] + noise)
    for v in range(0, mesh.vertex_count, 7):
        assert np.allclose(merged[v], drape[v] + noise[mesh.weld == v].mean(axis=0))


def test_wrong_shapes_are_refused(mesh, body, drape):
    with pytest.raises(GeometryError, match="was given positions"):
        measure_error(mesh, drape, drape, body)


def test_summary_is_by_kind(mesh, body, drape):
    skirt = mesh_pattern(draft("fitted-skirt").canonical(), 5.0)
    rest = np.full((skirt.vertex_count, 3), [0.0, 100.0, 60.0])
    errors = [
        measure_error(mesh, drape[mesh.weld] + [1.0, 0, 0], drape, body),
        measure_error(mesh, drape[mesh.weld] + [2.0, 0, 0], drape, body),
        measure_error(skirt, rest[skirt.weld] + [6.0, 0, 0], rest, body),
    ]
    summary = summarize(errors)
    assert summary["garments"] == 3
    assert summary["mean"] == pytest.approx(3)
    assert summary["median"] == pytest.approx(2)
    assert set(summary["kinds"]) == {"upper", "skirt"}
    assert summary["kinds"]["upper"]["mean"] == pytest.approx(1.5)
    assert summarize([]) == {"garments": 0}


@pytest.mark.parametrize(
    ("name", "kind"),
    [
        ("t-shirt", "upper"),
        ("hoodie", "upper"),
        ("shirt-dress", "dress"),
        ("fitted-dress", "dress"),
        ("jumpsuit", "jumpsuit"),
        ("trousers", "trousers"),
        ("circle-skirt", "skirt"),
    ],
)
def test_kinds_of_drafts(name, kind):
    assert garment_kind(draft(name)) == kind
