from __future__ import annotations

import json

import numpy as np
import pytest
from sewn_tube import tube_garment

from swifttailor.errors import InputError, PatternError
from swifttailor.garment.garment import Garment
from swifttailor.panel_mesh import mesh_pattern
from swifttailor.pattern.drafts import draft


def dress(edge_length=4.0) -> Garment:
    """A draft with darts, curves and gathers, its vertices anywhere."""
    pattern = draft("fitted-dress").canonical()
    mesh = mesh_pattern(pattern, edge_length)
    vertices = np.random.default_rng(3).normal(0.0, 60.0, (mesh.vertex_count, 3))
    return Garment(mesh, vertices, {"edge_length_cm": edge_length, "rotation": "intrinsic", "seed": 7})


@pytest.fixture
def folder(tmp_path):
    return dress().save(tmp_path / "dress", preview=False)


def change_report(folder, **changes):
    report = json.loads((folder / "report.json").read_text()) | changes
    (folder / "report.json").write_text(json.dumps({k: v for k, v in report.items() if v is not None}))


@pytest.mark.parametrize("without", ["", "garment.obj", "garment.glb"])
def test_what_was_saved_comes_back(folder, without):
    if without:
        (folder / without).unlink()
    saved, loaded = dress(), Garment.load(folder)
    assert loaded.pattern == saved.pattern and loaded.report == saved.report
    for name in ("flat_vertices", "flat_faces", "flat_panel", "weld", "faces"):
        assert np.array_equal(getattr(loaded.mesh, name), getattr(saved.mesh, name)), name
    digits = 1e-3 if without == "garment.obj" else 1e-6  # float32 metres, or six decimals of a centimetre
    assert np.abs(loaded.vertices - saved.vertices).max() < digits
    assert [s.stitch for s in loaded.seams] == [s.stitch for s in saved.seams]


def test_the_rotation_of_the_report_is_used(folder):
    change_report(folder, rotation="extrinsic")
    assert Garment.load(folder).pattern == dress().pattern.with_rotation_reading("extrinsic")


def test_another_edge_length_is_noticed(folder):
    change_report(folder, edge_length_cm=5.0)
    with pytest.raises(InputError, match=r"does not belong to .* vertices and .* faces"):
        Garment.load(folder)


def test_a_pattern_changed_beside_its_garment_is_noticed(folder):
    pattern = json.loads((folder / "pattern.json").read_text())
    panel = pattern["pattern"]["panels"]["skirt_back"]
    panel["vertices"] = [[x, 1.001 * y] for x, y in panel["vertices"]]
    (folder / "pattern.json").write_text(json.dumps(pattern))
    with pytest.raises(InputError, match="does not belong to"):
        Garment.load(folder)


def test_faces_in_another_order_are_noticed(folder):
    lines = (folder / "garment.obj").read_text().splitlines()
    faces = [k for k, line in enumerate(lines) if line.startswith("f ")]
    lines[faces[0]], lines[faces[1]] = lines[faces[1]], lines[faces[0]]
    (folder / "garment.obj").write_text("\n".join(lines))
    with pytest.raises(InputError, match="join other vertices"):
        Garment.load(folder)


@pytest.mark.parametrize(
    ("changes", "says"),
    [
        ({"edge_length_cm": None}, "does not say at which edge length"),
        ({"edge_length_cm": True}, "does not say at which edge length"),
        ({"edge_length_cm": "2"}, "does not say at which edge length"),
        ({"edge_length_cm": 0.001}, "between 0.05 and 50"),
        ({"rotation": "sideways"}, "'rotation' is 'sideways'"),
    ],
)
def test_broken_reports_are_refused(folder, changes, says):
    change_report(folder, **changes)
    with pytest.raises(InputError, match=says):
        Garment.load(folder)


@pytest.mark.parametrize("text", ["", "[]", "{", "[" * 100_000, "\xff"])
def test_reports_that_are_none_are_refused(folder, text):
    (folder / "report.json").write_bytes(text.encode("latin-1"))
    with pytest.raises(InputError, match=r"report\.json"):
        Garment.load(folder)


@pytest.mark.parametrize("missing", ["pattern.json", "report.json"])
def test_missing_files_are_named(folder, missing):
    (folder / missing).unlink()
    with pytest.raises(InputError, match=missing.replace(".", r"\.")):
        Garment.load(folder)


def test_a_folder_without_a_mesh_is_refused(folder):
    (folder / "garment.obj").unlink()
    (folder / "garment.glb").unlink()
    with pytest.raises(InputError, match=r"neither garment\.obj nor garment\.glb"):
        Garment.load(folder)


def test_a_folder_that_is_none(tmp_path):
    with pytest.raises(InputError, match=r"holds no pattern\.json"):
        Garment.load(tmp_path / "nowhere")
    (tmp_path / "pattern.json").write_text("{}")
    (tmp_path / "report.json").write_text('{"edge_length_cm": 2}')
    with pytest.raises(PatternError):
        Garment.load(tmp_path)


def test_garments_that_say_nothing_of_their_mesh_are_refused_when_loaded(tmp_path):
    tube_garment().save(tmp_path, preview=False)
    with pytest.raises(InputError, match="edge_length_cm"):
        Garment.load(tmp_path)
