"""``swifttailor fit`` and the options of the wearer."""

from __future__ import annotations

import errno
import json
import os
from pathlib import Path

import pytest

from swifttailor.cli.main import run
from swifttailor.garment.folder_wearer import wearer_of
from swifttailor.garment.garment import Garment
from swifttailor.pattern import load_pattern
from swifttailor.pattern.drafts import draft


@pytest.fixture
def shirt(tmp_path):
    return draft("t-shirt").save(tmp_path / "shirt.json")


def test_a_size_run_writes_a_pattern_for_each_size(shirt, tmp_path, capsys):
    assert run(["fit", str(shirt), "--sizes", "36,44", "--out", str(tmp_path / "run"), "--json"]) == 0
    reports = json.loads(capsys.readouterr().out)
    assert [r["body"] for r in reports] == ["women EU 36", "women EU 44"]
    widths = [load_pattern(r["file"]).panel("left_btorso").bounding_box()[1, 0] for r in reports]
    assert len(set(widths)) == 2


def test_sew_refits_to_a_size_and_stands_in_a_pose(shirt, tmp_path, capsys):
    out = tmp_path / "sewn"
    arguments = ["sew", str(shirt), "--measure", "bust=96", "height=176", "--figure", "men"]
    assert run([*arguments, "--pose", "down", "--edge-length", "4", "--no-preview", "--out", str(out)]) in (
        0,
        1,
    )
    report = json.loads((out / "report.json").read_text())
    assert report["pose"] == "down"
    assert report["fitted_to"]["measures"]["bust"] == pytest.approx(96, abs=0.5)
    assert load_pattern(out / "pattern.json").drafted_for.figure == "men"


@pytest.fixture(scope="module")
def child(tmp_path_factory) -> Path:
    """A shirt refitted to a child: the file says so."""
    folder = tmp_path_factory.mktemp("child")
    draft("t-shirt").save(folder / "shirt.json")
    fitted = folder / "child.json"
    assert run(["fit", str(folder / "shirt.json"), "--size", "children 122", "--out", str(fitted)]) in (0, 1)
    return fitted


def test_a_refitted_pattern_is_checked_around_its_own_wearer(child, tmp_path, capsys):
    """A child's shirt is not an adult's that has slid down; a repair would have raised it by half a metre."""
    capsys.readouterr()
    run(["check", str(child), "--json", "--repair", str(tmp_path / "mended.json")])
    told = json.loads(capsys.readouterr().out)
    assert "misplaced-panel" not in {f["code"] for f in told["findings"]}
    assert "misplaced-panel" not in {c["code"] for c in told["changes"]}


@pytest.mark.parametrize("command", ["sew", "drape"])
def test_a_refitted_pattern_is_worn_by_whom_it_names(child, tmp_path, capsys, command):
    out = tmp_path / command
    run([command, str(child), "--edge-length", "4", "--no-preview", "--out", str(out)])
    assert "children EU 122" in capsys.readouterr().out
    garment = Garment.load(out)
    assert garment.report["body"] == "children EU 122"
    assert garment.vertices[:, 1].max() < 110.0  # the child's shoulders, not an adult's
    assert "misplaced-panel" not in {f["code"] for f in garment.report["findings"]}
    assert wearer_of(out).name == "children EU 122"


def test_each_of_many_patterns_is_worn_by_its_own_wearer(child, shirt, tmp_path, capsys):
    out = tmp_path / "many"
    again = tmp_path / "another.json"
    again.write_bytes(child.read_bytes())
    files = [str(child), str(again), str(shirt)]
    run(["sew", *files, "--edge-length", "4", "--no-preview", "--out", str(out)])
    names = [Garment.load(out / name).report.get("body") for name in ("child", "another", "shirt")]
    assert names == ["children EU 122", "children EU 122", None]  # None is the default body


def test_a_pattern_whose_wearer_there_is_not_is_not_sewn_and_says_why(child, shirt, tmp_path, capsys):
    document = json.loads(child.read_text())
    document["properties"]["drafted_for"]["measures"] = {"bust": 60, "waist": 120}
    nobody = tmp_path / "nobody.json"
    nobody.write_text(json.dumps(document))
    out = tmp_path / "sewn"
    assert run(["sew", str(nobody), str(shirt), "--edge-length", "4", "--no-preview", "--out", str(out)]) == 1
    said = capsys.readouterr().out
    assert "nobody.json" in said and "bust=60" in said
    assert [p.name for p in out.iterdir() if p.is_dir()] == ["shirt"]


@pytest.mark.parametrize("fitting", ["auto", "never"])
def test_edit_keeps_the_size_where_only_a_height_is_given(fitting):
    from dataclasses import replace

    from swifttailor.body import body_for
    from swifttailor.cli.edit import Edit

    dress = replace(draft("t-shirt"), drafted_for=body_for("46").made_for)
    edit = Edit(pattern=Path("dress"), instruction="longer", measure=("height=160",), fit=fitting)
    order = edit.order("longer", edit=dress)
    worn = order.body if fitting == "auto" else edit.tailor(dress.drafted_for).body
    assert worn is not None and worn.name == "women EU 46, height 160"
    assert worn.measurements.height == pytest.approx(160, abs=0.5)
    assert worn.measurements.bust == pytest.approx(104, abs=0.5)


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["--measure", "waist=0"], "38 to 190 cm is accepted"),
        (["--measure", "waist=400"], "38 to 190 cm is accepted"),
        (["--measure", "bust=60", "waist=120"], "The nearest that one has"),
        (["--measure", "girth=90"], "There is no measure 'girth'"),
        (["--size", "99"], "There is no size '99'"),
        (["--size", "44", "--sizes", "36-40"], "Give one of them"),
        (["--sizes", "44-36"], "not a run of sizes"),
        ([], "No body was given"),
    ],
)
def test_bad_input_is_a_sentence_and_nothing_is_written(shirt, tmp_path, capsys, arguments, said):
    before = sorted(tmp_path.iterdir())
    assert run(["fit", str(shirt), *arguments, "--out", str(tmp_path / "x")]) == 2
    assert said in capsys.readouterr().err
    assert sorted(tmp_path.iterdir()) == before


def test_the_pattern_itself_is_not_replaced(shirt, capsys):
    before = shirt.read_bytes()
    assert run(["fit", str(shirt), "--size", "44", "--out", str(shirt), "--overwrite"]) == 2
    assert shirt.read_bytes() == before


def test_batches_are_draped_as_they_are(tmp_path, capsys):
    assert run(["drape", "--batch", str(tmp_path), "--size", "44", "--out", str(tmp_path / "o")]) == 2
    assert "swifttailor fit" in capsys.readouterr().err


def test_a_run_of_sizes_is_written_whole_or_not_at_all(shirt, tmp_path, capsys, monkeypatch):
    real, out = os.replace, tmp_path / "run"

    def full(source, target):
        if Path(target) == out / "women-eu-44.json":
            raise OSError(errno.ENOSPC, "No space left on device")
        real(source, target)

    monkeypatch.setattr("os.replace", full)
    assert run(["fit", str(shirt), "--sizes", "36,44", "--out", str(out)]) == 2
    assert "the disk is full" in capsys.readouterr().err
    assert not out.exists()
