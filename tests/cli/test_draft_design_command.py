"""``swifttailor draft --design``: GarmentCode's designs, for whom the options name."""

from __future__ import annotations

import json

import pytest

from swifttailor.body import body_for
from swifttailor.cli.main import run
from swifttailor.pattern import load_pattern
from swifttailor.refitting import draft_design

DESIGN = {"meta.bottom": "Pants", "meta.wb": "FittedWB", "pants.length": 0.8}
NESTED = """
design:
  meta: {bottom: {v: Pants, type: select}, wb: {v: FittedWB}, upper: {v: null}}
  pants:
    length: {v: 0.8, range: [0.2, 0.9], type: float}
"""


@pytest.fixture
def design(tmp_path):
    path = tmp_path / "pants.yaml"
    path.write_text(NESTED)
    return path


def test_drafts_for_the_body_that_is_named(design, tmp_path, capsys):
    out = tmp_path / "new" / "pants-44.json"
    assert (
        run(["draft", "--design", str(design), "--size", "44", "--measure", "height=180", "--out", str(out)])
        == 0
    )
    body = body_for("44", {"height": 180})
    written, expected = load_pattern(out), draft_design(DESIGN, body)
    assert written.panels == expected.panels and written.stitches == expected.stitches
    assert written.drafted_for == body.made_for
    said = capsys.readouterr().out
    assert f"{out}: for women EU 44, height 180 (height 180," in said


def test_without_a_body_it_is_the_default_one(design, tmp_path, capsys):
    assert run(["draft", f"--design={design}", "--out", str(tmp_path / "a.json")]) == 0
    assert load_pattern(tmp_path / "a.json").panels == draft_design(DESIGN).panels
    assert "for default" in capsys.readouterr().out


def test_a_run_of_sizes_prints_as_one_pattern(design, tmp_path, capsys):
    pytest.importorskip("reportlab")
    folder = tmp_path / "run"
    assert run(["draft", "--design", str(design), "--sizes", "38-42", "--out", str(folder), "--json"]) == 0
    reports = json.loads(capsys.readouterr().out)
    assert [r["body"] for r in reports] == ["women EU 38", "women EU 40", "women EU 42"]
    assert run(["convert", str(folder), str(tmp_path / "run.pdf")]) == 0
    assert "in 3 sizes" in capsys.readouterr().out


def test_where_a_dart_comes_or_goes_sizes_are_not_nested(design, tmp_path, capsys):
    folder = tmp_path / "run"
    assert run(["draft", "--design", str(design), "--sizes", "36-38", "--out", str(folder)]) == 0
    assert run(["convert", str(folder), str(tmp_path / "run.dxf")]) == 2
    assert "Size 36 is not cut like the others: its piece of the panels wb_front" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("content", "arguments", "said"),
    [
        (NESTED, ["--size", "99"], "There is no size '99'"),
        (NESTED, ["--size", "44", "--sizes", "36-40"], "Give one of them"),
        (NESTED, ["--measure", "waist=400"], "38 to 190 cm is accepted"),
        (NESTED.replace("0.8", "80"), [], "pants.length is '80'; accepted is a number from 0.2 to 0.9"),
        (NESTED.replace("length", "lenght"), [], "did you mean 'pants.length'?"),
        (NESTED.replace("Pants", "null"), [], "only a waistband (FittedWB)"),
        ("a: [", [], "is not valid YAML"),
        ("- 1", [], "holds no design"),
        ("", [], "holds no design"),
        (NESTED, ["t-shirt"], "Both a garment ('t-shirt') and --design"),
    ],
)
def test_bad_input_is_a_sentence_and_nothing_is_written(content, arguments, said, design, tmp_path, capsys):
    design.write_text(content)
    before = sorted(tmp_path.iterdir())
    assert run(["draft", "--design", str(design), *arguments, "--out", str(tmp_path / "x")]) == 2
    assert said in capsys.readouterr().err
    assert sorted(tmp_path.iterdir()) == before


def test_the_design_itself_is_not_replaced(design, capsys):
    assert run(["draft", "--design", str(design), "--out", str(design), "--overwrite"]) == 2
    assert "is the design itself" in capsys.readouterr().err
    assert design.read_text() == NESTED
