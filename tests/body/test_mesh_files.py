from __future__ import annotations

import json

import numpy as np
import pytest
from PIL import Image
from shapes import garmentcode_folder, icosphere, mesh_of, write_obj

from swifttailor.body import Body, BodyPart
from swifttailor.body.measuring import MEAN_BODY
from swifttailor.body.orientation import oriented_outward
from swifttailor.errors import InputError


def _write(path, vertices, faces):
    if path.suffix == ".obj":
        return write_obj(path, vertices, faces)
    mesh_of(vertices, faces).export(path)
    return path


@pytest.mark.parametrize("ending", ["obj", "ply", "glb", "stl"])
def test_every_format_gives_the_same_body(body, tmp_path, ending):
    own = Body.load(_write(tmp_path / f"me.{ending}", body.vertices / 100, body.faces))
    assert own.name == "me"
    assert len(own.faces) == len(body.faces)
    assert len(own.vertices) == len(body.vertices)
    np.testing.assert_allclose(own.vertices.min(0), body.vertices.min(0), atol=1e-3)
    np.testing.assert_allclose(own.vertices.max(0), body.vertices.max(0), atol=1e-3)
    assert mesh_of(own.vertices, own.faces).is_watertight
    counts = np.bincount(own.vertex_part, minlength=6)
    np.testing.assert_allclose(counts, np.bincount(body.vertex_part, minlength=6), rtol=0.02)


@pytest.mark.parametrize("unit", [0.01, 1.0, 10.0])
def test_units_are_told_by_the_height(body, tmp_path, unit):
    moved = body.vertices * unit + np.array([70.0, -20.0, 33.0]) * unit
    own = Body.load(write_obj(tmp_path / "me.obj", moved, body.faces))
    np.testing.assert_allclose(np.ptp(own.vertices, axis=0), np.ptp(body.vertices, axis=0), atol=1e-2)
    assert own.vertices[:, 1].min() == pytest.approx(0.0, abs=1e-9)
    assert abs(own.vertices[:, 0].min() + own.vertices[:, 0].max()) < 1e-2


def test_a_body_near_the_axis_stays_where_it_is(body, tmp_path):
    own = Body.load(write_obj(tmp_path / "me.obj", body.vertices, body.faces))
    np.testing.assert_allclose(own.vertices.max(0), body.vertices.max(0), atol=1e-4)


def test_an_inside_out_body_is_turned(body, tmp_path):
    own = Body.load(write_obj(tmp_path / "me.obj", body.vertices, body.faces[:, ::-1]))
    assert mesh_of(own.vertices, own.faces).volume > 0


def test_faces_turned_at_random_are_turned_back(body, tmp_path):
    flip = np.random.default_rng(0).random(len(body.faces)) < 0.4
    faces = np.where(flip[:, None], body.faces[:, ::-1], body.faces)
    own = Body.load(write_obj(tmp_path / "me.obj", body.vertices, faces))
    mesh = mesh_of(own.vertices, own.faces)
    assert mesh.is_winding_consistent
    assert mesh.volume == pytest.approx(mesh_of(body.vertices, body.faces).volume, rel=1e-4)


def test_every_piece_is_turned_outward():
    outer, inner = icosphere(10.0, 2), icosphere(2.0, 2, centre=(1, 2, 3))
    vertices = np.concatenate([outer[0], inner[0]])
    faces = np.concatenate([outer[1][:, ::-1], inner[1][:, ::-1] + len(outer[0])])
    faces[::3] = faces[::3, ::-1]
    mesh = mesh_of(vertices, oriented_outward(vertices, faces))
    assert mesh.is_winding_consistent
    assert mesh.volume == pytest.approx(mesh_of(*outer).volume + mesh_of(*inner).volume)


def test_missing_measurements_are_measured(body, tmp_path):
    path = write_obj(tmp_path / "me.obj", body.vertices * 0.9, body.faces)
    own = Body.load(path).measurements
    assert own.height == pytest.approx(0.9 * body.vertices[:, 1].max(), abs=0.01)
    for name in ("bust", "waist", "hips", "leg_circ"):
        assert getattr(own, name) == pytest.approx(0.9 * MEAN_BODY[name], rel=0.05), name
    assert own.neck_w == pytest.approx(0.9 * MEAN_BODY["neck_w"], rel=0.01)
    assert own.shoulder_incl == MEAN_BODY["shoulder_incl"]


@pytest.mark.parametrize("ending", ["yaml", "json"])
def test_given_measurements_are_kept(body, tmp_path, ending):
    path = write_obj(tmp_path / "me.obj", body.vertices, body.faces)
    given = {"body": {"waist": 70.5, "hips": 99, "something_else": "a note"}}
    notes = tmp_path / f"me.{ending}"
    notes.write_text(json.dumps(given))  # JSON is YAML
    own = Body.load(path, notes).measurements
    assert own.waist == 70.5
    assert own.hips == 99.0
    assert own.bust == pytest.approx(MEAN_BODY["bust"], rel=0.03)


def test_garmentcodes_body_is_read_with_its_measurements():
    folder = garmentcode_folder() / "body"
    own = Body.load(folder / "mean_all.obj", folder / "mean_all.yaml")
    assert own.measurements.as_dict() == MEAN_BODY
    assert set(np.unique(own.vertex_part)) == {int(part) for part in BodyPart}
    left = own.vertices[own.vertex_part == BodyPart.LEFT_ARM]
    assert left[:, 0].min() > 8
    assert left[:, 0].max() > 60


@pytest.mark.parametrize(
    ("turn", "message"),
    [
        (np.array([[1, 0, 0], [0, 0, -1], [0, 1, 0]]), "stand along Z.*rotate it by -90 degrees about X"),
        (np.array([[0, 0, 1], [0, 1, 0], [-1, 0, 0]]), "face along X.*rotate it by 90 degrees about Y"),
        (np.diag([1, -1, -1]), "upside down"),
        (np.diag([-1, 1, -1]), "faces -Z.*180 degrees"),
    ],
)
def test_a_body_that_stands_otherwise_is_refused_with_the_mend(body, tmp_path, turn, message):
    path = write_obj(tmp_path / "me.obj", body.vertices @ turn.T, body.faces)
    with pytest.raises(InputError, match=message):
        Body.load(path)


def test_absurd_heights_are_refused(body, tmp_path):
    for scale in (1e-5, 0.15, 30.0, 1e7):
        path = write_obj(tmp_path / "me.obj", body.vertices * scale, body.faces)
        with pytest.raises(InputError, match="units tall"):
            Body.load(path)


def test_nan_vertices_are_refused(body, tmp_path):
    path = write_obj(tmp_path / "me.obj", body.vertices, body.faces)
    lines = path.read_text().splitlines()
    lines[10] = "v nan 1.0 2.0"
    path.write_text("\n".join(lines))
    with pytest.raises(InputError, match="NaN"):
        Body.load(path)


def test_files_that_are_no_meshes_are_refused(tmp_path):
    text = tmp_path / "text.obj"
    text.write_text("Dear diary,\nthis is no mesh.\n")
    picture = tmp_path / "picture.ply"
    Image.new("RGB", (4, 4)).save(picture, format="PNG")
    empty = tmp_path / "empty.glb"
    empty.touch()
    no_faces = tmp_path / "points.obj"
    no_faces.write_text("v 0 0 0\nv 0 1 0\nv 0 0 1\n")
    binary = tmp_path / "noise.stl"
    binary.write_bytes(np.random.default_rng(0).bytes(500))
    broken = tmp_path / "broken.obj"
    broken.write_text("v 0 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 9\n")
    lying = tmp_path / "lying.ply"
    lying.write_text(
        "ply\nformat binary_little_endian 1.0\nelement vertex 999999999999\nproperty float x\n"
        "property float y\nproperty float z\nelement face 999999999\n"
        "property list uchar int vertex_indices\nend_header\n"
    )
    flat = tmp_path / "flat.obj"
    flat.write_text("v 0 0 0\nv 0 1.7 0\nv 0 1 0\nf 1 2 3\n")
    for path in (text, picture, empty, no_faces, binary, broken, lying, flat):
        with pytest.raises(InputError, match=path.name):
            Body.load(path)
    for path in (tmp_path / "missing.obj", tmp_path / "body.fbx", tmp_path):
        with pytest.raises(InputError):
            Body.load(path)
    (tmp_path / "folder.obj").mkdir()
    with pytest.raises(InputError, match="not a file"):
        Body.load(tmp_path / "folder.obj")


def test_too_large_files_are_refused_unread(tmp_path, monkeypatch):
    path = write_obj(tmp_path / "me.obj", *icosphere(80.0, 3))
    monkeypatch.setattr("swifttailor.body.mesh_files.MAX_FACES", 100)
    with pytest.raises(InputError, match="faces; at most 100"):
        Body.load(path)
    monkeypatch.setattr("swifttailor.body.mesh_files.MAX_FILE_BYTES", 1000)
    with pytest.raises(InputError, match="MB are accepted"):
        Body.load(path)


@pytest.mark.parametrize(
    ("content", "message"),
    [
        ("[1, 2]", "no body measurements"),
        ("body: {weist: 70}", "no body measurements"),
        ("body: {waist: wide}", "finite number"),
        ("body: {waist: .nan}", "finite number"),
        ("body: {waist: -3}", "above zero"),
        ("body: {waist: true}", "finite number"),
        ("body: {height: 1.72}", "state a height"),
        ("body: [unclosed", "not valid YAML"),
        ("!!python/object/apply:os.system ['true']", "not valid YAML"),
    ],
)
def test_bad_measurement_files_are_refused(body, tmp_path, content, message):
    path = write_obj(tmp_path / "me.obj", body.vertices, body.faces)
    notes = tmp_path / "me.yaml"
    notes.write_text(content)
    with pytest.raises(InputError, match=message):
        Body.load(path, notes)


def test_unreadable_measurement_files_are_refused(body, tmp_path):
    path = write_obj(tmp_path / "me.obj", body.vertices, body.faces)
    for name, content in (("big.yaml", b"#" * 1_000_001), ("bytes.yaml", b"\xff\xfe\x00"), ("x.json", b"{")):
        (tmp_path / name).write_bytes(content)
        with pytest.raises(InputError, match=name):
            Body.load(path, tmp_path / name)
    with pytest.raises(InputError, match="missing"):
        Body.load(path, tmp_path / "missing.yaml")
