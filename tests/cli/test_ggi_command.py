from __future__ import annotations

import numpy as np
import pytest
from PIL import Image

from swifttailor.cli.main import run
from swifttailor.garment.garment import Garment
from swifttailor.ggi.file import read_ggi
from swifttailor.panel_mesh import mesh_pattern
from swifttailor.pattern.drafts import draft

PATTERN_FILES = {"ggi.npz", "semantic.png", "stitching.png"}


@pytest.fixture
def pattern_file(tmp_path):
    return draft("tank-top").save(tmp_path / "tank-top.json")


@pytest.fixture
def garment_folder(tmp_path):
    pattern = draft("tank-top").with_rotation_reading("extrinsic").canonical()
    mesh = mesh_pattern(pattern, 5.0)
    vertices = np.random.default_rng(0).normal(0.0, 40.0, (mesh.vertex_count, 3))
    report = {"edge_length_cm": 5.0, "rotation": "extrinsic"}
    return Garment(mesh, vertices, report).save(tmp_path / "worn", preview=False)


def files(folder):
    return {p.name for p in folder.iterdir()}


def test_a_pattern_becomes_two_images(pattern_file, tmp_path, capsys):
    out = tmp_path / "deep" / "images"
    assert run(["ggi", str(pattern_file), "--out", str(out)]) == 0
    assert files(out) == PATTERN_FILES | {".swifttailor"}
    images = read_ggi(out / "ggi.npz")
    assert images.resolution == 256 and images.geometry is None
    assert images.layout.pattern == draft("tank-top").canonical()
    printed = capsys.readouterr().out
    assert f"{images.layout.cm_per_pixel:.3g} cm per pixel" in printed and str(out / "ggi.npz") in printed
    with Image.open(out / "semantic.png") as picture:
        assert picture.size == (256, 256)


def test_a_garment_becomes_three_images(garment_folder, tmp_path):
    out = tmp_path / "images"
    assert run(["ggi", str(garment_folder), "--out", str(out), "--resolution", "100"]) == 0
    assert files(out) == PATTERN_FILES | {"geometry.png", ".swifttailor"}
    images = read_ggi(out / "ggi.npz")
    garment = Garment.load(garment_folder)
    assert images.resolution == 100 and images.layout.pattern == garment.pattern
    assert images.layout.pattern.panels[0].placement.reading == "extrinsic"
    shown = images.geometry[images.occupancy]
    low, high = garment.vertices.min(axis=0), garment.vertices.max(axis=0)
    assert (shown >= low - 0.01).all() and (shown <= high + 0.01).all()
    assert (np.ptp(shown, axis=0) > 0.5 * (high - low)).all()


def test_options_reach_the_layout(pattern_file, tmp_path):
    scale = ["--cm-per-pixel", "2.5", "--packing", "rows", "--rotation", "extrinsic"]
    assert run(["ggi", str(pattern_file), "--out", str(tmp_path / "images"), *scale]) == 0
    layout = read_ggi(tmp_path / "images" / "ggi.npz").layout
    assert layout.cm_per_pixel == 2.5
    assert layout.pattern == draft("tank-top").with_rotation_reading("extrinsic").canonical()


def test_the_same_input_gives_the_same_bytes(garment_folder, tmp_path):
    for name in ("a", "b"):
        assert run(["ggi", str(garment_folder), "--out", str(tmp_path / name), "--resolution", "64"]) == 0
    for name in PATTERN_FILES | {"geometry.png"}:
        assert (tmp_path / "a" / name).read_bytes() == (tmp_path / "b" / name).read_bytes(), name


@pytest.mark.parametrize(
    ("arguments", "says"),
    [
        ([], "Give either a pattern or a garment's folder"),
        (["PATTERN", "--decode", "x.npz"], "Give either a pattern or a garment's folder"),
        (["PATTERN", "--resolution", "3"], "resolution is 3; from 16 to 4096"),
        (["PATTERN", "--cm-per-pixel", "0.001"], "do not fit into 256 x 256"),
        (["PATTERN", "--method", "grid"], "--method is for making garments, with --decode"),
        (["PATTERN", "--edge-length", "2"], "--edge-length is for making garments, with --decode"),
        (["--decode", "x.npz", "--resolution", "64"], "--resolution is for drawing images; leave it out"),
        (["--decode", "x.npz", "--packing", "rows"], "--packing is for drawing images"),
        (["FOLDER", "--rotation", "extrinsic"], "leave --rotation out"),
        (["x.npz"], "swifttailor ggi --decode x.npz --out DIR"),
        (["none.json"], "Cannot read 'none.json'"),
        (["EMPTY"], "holds no pattern.json"),
    ],
)
def test_misuse_is_answered_with_a_sentence(arguments, says, pattern_file, garment_folder, tmp_path, capsys):
    (tmp_path / "empty").mkdir()
    stands_for = {"PATTERN": pattern_file, "FOLDER": garment_folder, "EMPTY": tmp_path / "empty"}
    out = tmp_path / "images"
    assert run(["ggi", *(str(stands_for.get(a, a)) for a in arguments), "--out", str(out)]) == 2
    assert says in capsys.readouterr().err
    assert not out.exists()


def test_a_file_in_place_of_the_folder_is_refused(pattern_file, capsys):
    assert run(["ggi", str(pattern_file), "--out", str(pattern_file)]) == 2
    assert "is a file, not a folder" in capsys.readouterr().err
