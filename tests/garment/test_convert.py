from __future__ import annotations

from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest
import tyro
from sewn_tube import tube_pattern

from swifttailor.cli.convert import Convert
from swifttailor.errors import InputError
from swifttailor.garment.formats import read_garment_mesh
from swifttailor.pattern import load_pattern


@pytest.fixture
def folder(tube, tmp_path) -> Path:
    return tube.save(tmp_path / "made", preview=False)


@pytest.mark.parametrize("source", ["garment.glb", "garment.obj", ""])
@pytest.mark.parametrize("target", ["x.glb", "x.obj", "x.ply", "x.stl", "sub/x.USDA"])
def test_garments_convert_to_every_format(tube, folder, tmp_path, source, target, capsys):
    assert Convert(folder / source, tmp_path / target).run() == 0
    assert capsys.readouterr().out.strip() == str(tmp_path / target)
    mesh = read_garment_mesh(tmp_path / target)
    assert len(mesh.vertices) == len(tube.vertices) and len(mesh.faces) == len(tube.faces)
    np.testing.assert_allclose(mesh.vertices.mean(axis=0), tube.vertices.mean(axis=0), atol=1e-3)


def test_a_chain_of_conversions_keeps_seams_and_texture(tube, folder, tmp_path):
    Convert(folder, tmp_path / "a.usdc").run()
    Convert(tmp_path / "a.usdc", tmp_path / "b.obj").run()
    mesh = read_garment_mesh(tmp_path / "b.obj")
    assert [line.tolist() for line in mesh.lines] == [s.vertices.tolist() for s in tube.seams]
    np.testing.assert_allclose(mesh.uv, tube.uv, atol=1e-6)


@pytest.mark.parametrize("source", ["pattern.json", ""])
def test_patterns_convert(folder, tmp_path, source):
    Convert(folder / source, tmp_path / "x.svg").run()
    assert ElementTree.parse(tmp_path / "x.svg").getroot().tag.endswith("svg")
    Convert(folder / source, tmp_path / "x.json").run()
    assert load_pattern(tmp_path / "x.json") == tube_pattern()


def test_rotation_reading_is_passed_on(folder, tmp_path):
    assert Convert(folder, tmp_path / "x.json", rotation="extrinsic").run() == 0


def test_source_is_never_overwritten(folder):
    before = (folder / "garment.obj").read_bytes()
    for source, target in (("garment.obj", "garment.obj"), ("", "garment.obj"), ("", "pattern.json")):
        with pytest.raises(InputError, match="same file"):
            Convert(folder / source, folder / "." / target).run()
    assert (folder / "garment.obj").read_bytes() == before


def test_same_file_is_seen_through_links(folder):
    (folder / "link.obj").symlink_to(folder / "garment.obj")
    with pytest.raises(InputError, match="same file"):
        Convert(folder / "garment.obj", folder / "link.obj").run()


@pytest.mark.parametrize(
    ("source", "target", "reason"),
    [
        ("pattern.json", "x.docx", r"Accepted: \.svg, \.json"),
        ("pattern.json", "x.glb", "swifttailor drape"),
        ("garment.glb", "x.svg", r"Accepted: \.glb"),
        ("garment.glb", "x", r"Accepted: \.glb"),
        ("report.txt", "x.glb", "neither a pattern"),
        ("none.glb", "x.obj", "There is no file"),
    ],
)
def test_refusals_name_what_is_accepted(folder, tmp_path, source, target, reason):
    (folder / "report.txt").write_text("text")
    with pytest.raises(InputError, match=reason):
        Convert(folder / source, tmp_path / target).run()
    assert not (tmp_path / target).exists()


def test_command_line(folder):
    command = tyro.cli(Convert, args=[str(folder), "out.svg", "--rotation", "extrinsic"])
    assert command == Convert(folder, Path("out.svg"), "extrinsic")
