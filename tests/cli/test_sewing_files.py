"""``convert`` and ``marker`` write files to sew from; what makes no sense is answered with a sentence."""

from __future__ import annotations

import json

import numpy as np
import pypdfium2
import pytest
from PIL import Image

from swifttailor.cli.main import run
from swifttailor.garment import Garment
from swifttailor.garment.formats import read_garment_mesh
from swifttailor.panel_mesh import mesh_pattern
from swifttailor.pattern.drafts import draft


@pytest.fixture(scope="module")
def shirt(tmp_path_factory):
    """A folder with a garment, and its pattern as a file beside it."""
    folder = tmp_path_factory.mktemp("shirt")
    pattern = draft("t-shirt").canonical()
    pattern.save(folder / "shirt.json")
    mesh = mesh_pattern(pattern, 4.0)
    flat = [p.to_world(mesh.flat_vertices[mesh.flat_panel == k]) for k, p in enumerate(pattern.panels)]
    garment = Garment(mesh, mesh.welded_mean(np.concatenate(flat)), {"edge_length_cm": 4.0})
    garment.save(folder / "worn", preview=False)
    Image.new("RGB", (64, 64), "navy").save(folder / "worn" / "preview.png")
    Image.new("RGB", (30, 30), "red").save(folder / "print.png")
    return folder


@pytest.mark.parametrize("source", ["shirt.json", "worn"])
@pytest.mark.parametrize("ending", ["pdf", "dxf", "md", "zip"])
def test_files_to_sew_from(shirt, tmp_path, source, ending, capsys):
    target = tmp_path / "new" / f"a.{ending}"
    assert run(["convert", str(shirt / source), str(target)]) == 0
    assert capsys.readouterr().out.splitlines()[-1] == str(target)
    assert target.stat().st_size > 500
    if ending == "pdf":
        cover = pypdfium2.PdfDocument(target)[0].get_textpage().get_text_bounded()
        assert ("worn" if source == "worn" else "shirt") in cover and "m of cloth 140 cm wide" in " ".join(
            cover.split()
        )


def test_allowances_and_paper_are_obeyed(shirt, tmp_path):
    options = ["--allowance", "1.5", "--hem-allowance", "4", "--edge-allowance", "0.6", "--paper", "letter"]
    assert run(["convert", str(shirt / "shirt.json"), str(tmp_path / "a.pdf"), *options]) == 0
    document = pypdfium2.PdfDocument(tmp_path / "a.pdf")
    assert document[1].get_size() == pytest.approx((612, 792))
    assert "seams 1.5 cm, hems 4 cm" in " ".join(document[0].get_textpage().get_text_bounded().split())


def test_fronts_are_cut_on_the_fold_where_asked(shirt, tmp_path, capsys):
    for fold, expected in {"none": "cut 2, mirrored", "front": "cut 1 on the fold"}.items():
        out = tmp_path / f"{fold}.md"
        assert run(["convert", str(shirt / "shirt.json"), str(out), "--fold", fold]) == 0
        assert f"**Bodice front**: {expected}" in out.read_text()
    assert run(["convert", str(shirt / "shirt.json"), str(tmp_path / "a.svg"), "--fold", "both"]) == 2
    assert "no use" in capsys.readouterr().err


def test_a_marker_tells_its_length(shirt, tmp_path, capsys):
    out = tmp_path / "m.svg"
    command = ["marker", str(shirt / "worn"), "--width", "150", "--out", str(out), "--seconds", "1", "--json"]
    assert run(command) == 0
    told = json.loads(capsys.readouterr().out)
    assert told["width_cm"] == 150 and 50 < told["length_cm"] <= told["length_of_boxes_cm"] + 0.1
    assert 0 < told["waste"] < 0.6 and out.exists()


def test_a_marker_replaces_nothing_unasked(shirt, tmp_path, capsys):
    """Searches end where their time does, so the same command may draw another marker."""
    out = tmp_path / "m.svg"
    out.write_text("mine")
    command = ["marker", str(shirt / "shirt.json"), "--out", str(out), "--seconds", "1"]
    assert run(command) == 2 and out.read_text() == "mine"
    assert "would be replaced" in capsys.readouterr().err
    assert run([*command, "--overwrite"]) == 0 and "<svg" in out.read_text()


def test_a_garment_with_color_print_and_body(shirt, tmp_path):
    for name, options in {
        "plain": [],
        "red": ["--color", "#ff0000"],
        "printed": ["--print", str(shirt / "print.png"), "--print-width", "5"],
        "worn": ["--with-body"],
    }.items():
        assert run(["convert", str(shirt / "worn"), str(tmp_path / f"{name}.glb"), *options]) == 0
    sizes = {name: (tmp_path / f"{name}.glb").stat().st_size for name in ("plain", "printed", "worn")}
    assert sizes["plain"] < sizes["printed"] and sizes["plain"] + 50_000 < sizes["worn"]
    assert b'"baseColorFactor":[1.0,0.0,0.0,1.0]' in (tmp_path / "red.glb").read_bytes()
    plain, worn = (read_garment_mesh(tmp_path / f"{n}.glb") for n in ("plain", "worn"))
    assert len(plain.faces) == len(worn.faces) and len(plain.line_names) == len(draft("t-shirt").stitches)


def test_the_body_beside_a_garment_is_its_wearers(shirt, tmp_path, capsys):
    """Not the one that all patterns are drafted for first."""
    import trimesh

    child = ["--size", "children 122", "--edge-length", "4"]
    run(["sew", str(shirt / "shirt.json"), *child, "--out", str(tmp_path / "child")])
    run(["sew", str(shirt / "shirt.json"), *child, "--pose", "T", "--out", str(tmp_path / "level")])
    spans = {}
    for name in ("child", "level"):
        assert run(["convert", str(tmp_path / name), str(tmp_path / f"{name}.glb"), "--with-body"]) == 0
        body = trimesh.load(tmp_path / f"{name}.glb").geometry["body"]
        assert np.ptp(body.vertices[:, 1]) == pytest.approx(1.22, abs=0.02)
        spans[name] = np.ptp(body.vertices[:, 0])
    assert spans["level"] > 1.1 * spans["child"]
    run(["sew", str(shirt / "shirt.json"), *child, "--fit", "never", "--out", str(tmp_path / "large")])
    capsys.readouterr()
    assert run(["convert", str(tmp_path / "large"), str(tmp_path / "large.glb"), "--with-body"]) == 2
    assert "does not hold the measures of its wearer" in capsys.readouterr().err
    assert not (tmp_path / "large.glb").exists()


def huge_print(folder):
    """500 megapixels in a small file."""
    path = folder / "huge.png"
    Image.new("1", (25_000, 20_000)).save(path)
    return path


BAD = {
    "unknown paper": (["shirt.json", "a.pdf", "--paper", "a9"], "paper"),
    "paper of 9 m": (["shirt.json", "a.pdf", "--paper", "9000x900cm"], "paper"),
    "allowance of 4 m": (["shirt.json", "a.pdf", "--allowance", "400"], "--allowance"),
    "allowance below 0": (["shirt.json", "a.dxf", "--hem-allowance", "-1"], "--hem-allowance"),
    "no number": (["shirt.json", "a.md", "--edge-allowance", "nan"], "--edge-allowance"),
    "useless allowance": (["shirt.json", "a.svg", "--allowance", "1"], "no use"),
    "useless color": (["worn", "a.ply", "--color", "#aabbcc"], "no use"),
    "color by name": (["worn", "a.glb", "--color", "red"], "#rrggbb"),
    "print of a mesh": (["worn/garment.obj", "a.glb", "--print", "print.png"], "folder"),
    "print that is no picture": (["worn", "a.glb", "--print", "shirt.json"], "not a readable picture"),
    "print that is not there": (["worn", "a.glb", "--print", "none.png"], "no picture"),
    "print in text": (["worn", "a.usda", "--print", "print.png"], "no use"),
    "print of 0 cm": (["worn", "a.glb", "--print", "print.png", "--print-width", "0"], "repeat"),
    "500 megapixels": (["worn", "a.glb", "--print", "huge.png"], "too large"),
    "cloth of 1 cm": (["shirt.json", "a.pdf", "--cloth-width", "1"], "cloth"),
    "no folder": (["shirt.json", "/proc/none/a.pdf"], "Cannot write"),
    "unknown ending": (["shirt.json", "a.plt"], "cannot be converted"),
}


@pytest.mark.timeout(60)
@pytest.mark.parametrize("name", list(BAD))
def test_bad_requests_cost_a_sentence_and_no_file(shirt, tmp_path, monkeypatch, name, capsys):
    monkeypatch.chdir(shirt)
    if name == "500 megapixels":
        huge_print(shirt)
    words, expected = BAD[name]
    before = sorted(p.name for p in shirt.rglob("*"))
    words = [str(tmp_path / w) if w.startswith("a.") else w for w in words]
    assert run(["convert", *words]) == 2
    said = capsys.readouterr().err
    assert said.startswith("Error: ") and expected in said and "Traceback" not in said
    assert list(tmp_path.iterdir()) == [] and sorted(p.name for p in shirt.rglob("*")) == before


@pytest.mark.parametrize(
    ("options", "expected"),
    [
        (["--width", "5"], "cloth"),
        (["--width", "22"], "wider than the cloth"),
        (["--seconds", "0"], "--seconds"),
        (["--seed", "-3"], "--seed"),
        (["--out", "m.doc"], "ending"),
        (["--allowance", "99"], "--allowance"),
    ],
)
def test_bad_markers(shirt, tmp_path, monkeypatch, options, expected, capsys):
    monkeypatch.chdir(tmp_path)
    assert run(["marker", str(shirt / "shirt.json"), *options]) == 2
    assert expected in capsys.readouterr().err and list(tmp_path.iterdir()) == []


def test_without_the_extra_it_is_named(shirt, tmp_path, monkeypatch, capsys):
    import sys

    for module in ("reportlab", "reportlab.pdfgen.canvas", "spyrrow"):
        monkeypatch.setitem(sys.modules, module, None)
    for command in (
        ["convert", "shirt.json", str(tmp_path / "a.pdf")],
        ["marker", "shirt.json", "--out", str(tmp_path / "a.svg")],
    ):
        monkeypatch.chdir(shirt)
        assert run(command) == 2
        assert "swifttailor[print]" in capsys.readouterr().err
    assert run(["convert", "shirt.json", str(tmp_path / "a.dxf")]) == 0
