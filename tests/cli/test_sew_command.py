"""``swifttailor sew``."""

from __future__ import annotations

import errno
import json
import os
from pathlib import Path
from unittest import mock

import pytest
from old_style import old_style

from swifttailor.cli.main import run
from swifttailor.garment.garment import Garment
from swifttailor.pattern import write_pattern
from swifttailor.pattern.drafts import draft

TINY = str(Path(__file__).parents[1] / "garment_sewer" / "tiny_sewer.onnx")


@pytest.fixture
def shirt(tmp_path) -> Path:
    return write_pattern(draft("t-shirt"), tmp_path / "shirt.json") or tmp_path / "shirt.json"


def test_one_pattern_to_one_folder(shirt, tmp_path, capsys):
    assert run(["sew", str(shirt), "--out", str(tmp_path / "out"), "--weights", TINY]) == 0
    said = capsys.readouterr().out
    assert "shirt.json" in said and "are closed" in said
    names = {p.name for p in (tmp_path / "out").iterdir()}
    assert names == {
        *("pattern.json", "pattern.svg", "garment.glb", "garment.obj", "report.json", "preview.png"),
        ".swifttailor",
    }
    garment = Garment.load(tmp_path / "out")
    assert garment.report["findings"] == []
    assert set(garment.report["seconds"]) == {"loading", "drawing", "network", "decoding", "relaxing"}


def test_many_patterns_to_a_folder_each_and_a_broken_one_stops_no_other(shirt, tmp_path, capsys):
    write_pattern(draft("trousers"), tmp_path / "trousers.json")
    (tmp_path / "broken.json").write_text("{")
    files = [str(tmp_path / f"{n}.json") for n in ("shirt", "broken", "trousers")]
    assert run(["sew", *files, "--out", str(tmp_path / "out"), "--weights", TINY, "--json"]) == 1
    reports = json.loads(capsys.readouterr().out)
    assert [Path(r["pattern"]).name for r in reports] == ["shirt.json", "broken.json", "trousers.json"]
    assert ["error" in r for r in reports] == [False, True, False]
    assert {p.name for p in (tmp_path / "out").iterdir()} == {"shirt", "trousers"}


def test_a_pattern_with_faults_is_sewn_and_they_are_said(shirt, tmp_path, capsys):
    specification = json.loads(shirt.read_text())
    stitches = specification["pattern"]["stitches"]
    stitches.append(stitches[0])  # an edge sewn twice cannot be meshed
    shirt.write_text(json.dumps(specification))
    assert run(["sew", str(shirt), "--out", str(tmp_path / "out"), "--weights", TINY]) == 1
    assert "mended" in capsys.readouterr().out
    assert Garment.load(tmp_path / "out").report["mended"]


def test_what_stands_elsewhere_is_said_and_mended(tmp_path, capsys):
    old = old_style(draft("circle-skirt"))
    path = old.save(tmp_path / "old.json")
    assert run(["sew", str(path), "--out", str(tmp_path / "out"), "--weights", TINY]) == 1
    assert capsys.readouterr().out.count("warning: misplaced-panel") == len(old.panels)
    arguments = ["sew", str(path), "--out", str(tmp_path / "mended"), "--weights", TINY, "--repair"]
    assert run(arguments) == 1
    said = capsys.readouterr().out
    assert "mended misplaced-panel" in said and "warning" not in said
    tops = [Garment.load(tmp_path / name).vertices[:, 1].max() for name in ("out", "mended")]
    assert tops[0] < 40.0 < 80.0 < tops[1]


def test_nothing_made_is_exit_code_2(tmp_path, capsys):
    (tmp_path / "broken.json").write_text("[]")
    arguments = ["sew", str(tmp_path / "broken.json"), "--out", str(tmp_path / "out"), "--weights", TINY]
    assert run(arguments) == 2
    assert "Not sewn: " in capsys.readouterr().out
    assert not (tmp_path / "out").exists()


def test_missing_weights_are_said(shirt, tmp_path, capsys):
    assert run(["sew", str(shirt), "--out", str(tmp_path / "out"), "--weights", "nothing.onnx"]) == 2
    assert "Cannot read the weights" in capsys.readouterr().err
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        ([], "No pattern"),
        (["a/x.json", "b/x.json"], "would both be written"),
        (["x.json", "--edge-length", "50"], "0.5 to 10"),
    ],
)
def test_what_cannot_work_is_refused_at_once(arguments, said, tmp_path, capsys, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert run(["sew", *arguments, "--out", "out"]) == 2
    assert said in capsys.readouterr().err


def test_finished_by_physics(tmp_path):
    write_pattern(draft("fitted-skirt"), tmp_path / "skirt.json")
    arguments = ["sew", str(tmp_path / "skirt.json"), "--out", str(tmp_path / "out"), "--weights", TINY]
    assert run([*arguments, "--finish", "--edge-length", "4"]) in (0, 1)
    report = Garment.load(tmp_path / "out").report
    assert report["quality"]["static"]
    assert report["quality"]["penetrating_fraction"] == 0
    assert report["seconds"]["finishing"] > 0


def test_a_full_disk_stops_at_the_first_garment_and_leaves_no_half_of_it(
    shirt, tmp_path, capsys, monkeypatch
):
    write_pattern(draft("trousers"), tmp_path / "trousers.json")
    write_pattern(draft("fitted-skirt"), tmp_path / "skirt.json")
    files = [str(tmp_path / f"{n}.json") for n in ("shirt", "trousers", "skirt")]
    real, out = os.replace, tmp_path / "out"

    def full(source, target):
        if Path(target) == out / "trousers" / "garment.obj":
            raise OSError(errno.ENOSPC, "No space left on device")
        real(source, target)

    arguments = ["sew", *files, "--out", str(out), "--weights", TINY]
    monkeypatch.setattr("os.replace", full)
    assert run(arguments) == 2
    said = capsys.readouterr()
    assert "the disk is full" in said.err and "start the same command again" in said.err
    assert "skirt.json" not in said.out, "nothing is tried that cannot be kept"
    assert {p.name for p in out.iterdir()} == {"shirt"}, "half a garment would be taken for a foreign folder"
    monkeypatch.setattr("os.replace", real)
    assert run(arguments) == 0
    assert {p.name for p in out.iterdir()} == {"shirt", "trousers", "skirt"}


def test_what_was_in_a_folder_before_stays_where_a_garment_fails(shirt, tmp_path, capsys, monkeypatch):
    out = tmp_path / "out"
    out.mkdir()
    (out / "note.txt").write_text("mine")
    monkeypatch.setattr("os.replace", mock.Mock(side_effect=OSError(errno.ENOSPC, "No space left")))
    assert run(["sew", str(shirt), "--out", str(out), "--weights", TINY]) == 2
    assert [p.name for p in out.iterdir()] == ["note.txt"] and (out / "note.txt").read_text() == "mine"
