from __future__ import annotations

import json
import os
import subprocess
import sys

import numpy as np
import pytest
import tyro

from swifttailor.cli.check import Check
from swifttailor.cli.main import run
from swifttailor.errors import InputError, PatternError
from swifttailor.pattern import EdgeRef, Pattern, Stitch, load_pattern, to_specification
from swifttailor.pattern.drafts import draft


@pytest.fixture
def clean(tmp_path, square_pattern):
    return square_pattern.save(tmp_path / "clean.json")


@pytest.fixture
def faulty(tmp_path, square_pattern):
    """A repeated stitch (mended by --repair) and nothing else."""
    stitches = (*square_pattern.stitches, square_pattern.stitches[0])
    return Pattern(square_pattern.panels, stitches).save(tmp_path / "faulty.json")


@pytest.fixture
def hopeless(tmp_path, square_pattern):
    """A repeated stitch and an edge stitched twice, between whose partners nobody can choose."""
    extra = (square_pattern.stitches[0], Stitch(EdgeRef("front", 3), EdgeRef("back", 0)))
    return Pattern(square_pattern.panels, (*square_pattern.stitches, *extra)).save(tmp_path / "hopeless.json")


def test_a_clean_pattern_gives_zero_and_one_line(clean, capsys):
    assert Check(clean).run() == 0
    assert capsys.readouterr().out == f"{clean}: nothing to report\n"


def test_findings_give_one_and_say_what_where_why_and_how_to_mend(faulty, capsys):
    assert Check(faulty).run() == 1
    lines = capsys.readouterr().out.splitlines()
    assert lines[0].startswith("error    duplicate-stitch: front, edge 1, stitch 2: repeats")
    assert "each edge may be in one stitch only" in lines[1] and "--repair removes" in lines[1]
    assert lines[2] == f"{faulty}: 1 error"


def test_json_is_one_object_on_stdout(faulty, clean, capsys):
    assert Check(faulty, json=True).run() == 1
    printed = json.loads(capsys.readouterr().out)
    assert set(printed) == {"path", "ok", "findings", "changes"}
    assert printed["path"] == str(faulty) and printed["ok"] is False and printed["changes"] == []
    assert printed["findings"][0] | {"message": ""} == {
        "code": "duplicate-stitch", "severity": "error", "message": "", "panel": "front", "edge": 1,
        "stitch": 2, "value": None, "why": "each edge may be in one stitch only; other programs refuse the "
        "pattern", "repair": "--repair removes the stitch",
    }  # fmt: skip
    assert Check(clean, json=True).run() == 0
    assert json.loads(capsys.readouterr().out)["ok"] is True


def test_repair_writes_another_file_and_leaves_the_input(faulty, square_pattern, tmp_path, capsys):
    before = faulty.read_bytes()
    out = tmp_path / "new" / "mended.json"
    assert Check(faulty, repair=out).run() == 0
    assert load_pattern(out) == square_pattern and faulty.read_bytes() == before
    printed = capsys.readouterr().out
    assert "mended   duplicate-stitch: front, edge 1, stitch 2: removed the stitch" in printed
    assert f"1 change; the pattern is in {out}" in printed
    assert [p.name for p in out.parent.iterdir()] == ["mended.json"]


def test_repair_over_the_input_itself(faulty, square_pattern):
    before = faulty.read_bytes()
    with pytest.raises(InputError, match="would be replaced"):
        Check(faulty, repair=faulty).run()
    assert faulty.read_bytes() == before
    assert Check(faulty, repair=faulty, overwrite=True).run() == 0
    assert load_pattern(faulty) == square_pattern


def test_a_sound_file_is_not_written_over_itself(clean):
    clean.write_text(json.dumps(json.loads(clean.read_text())))  # other spacing than ours
    before = clean.read_bytes(), clean.stat().st_mtime_ns
    assert Check(clean, repair=clean).run() == 0
    assert (clean.read_bytes(), clean.stat().st_mtime_ns) == before


def test_what_cannot_be_repaired_stays_listed(hopeless, tmp_path, capsys):
    out = tmp_path / "out.json"
    assert Check(hopeless, repair=out, json=True).run() == 1
    printed = json.loads(capsys.readouterr().out)
    assert {c["code"] for c in printed["changes"]} == {"duplicate-stitch"}
    assert "edge-stitched-twice" in {f["code"] for f in printed["findings"]}
    assert len(load_pattern(out).stitches) == 3


def test_notes_alone_are_ok(clean, capsys):
    written = json.loads(clean.read_text()) | {"comment": "by hand"}
    clean.write_text(json.dumps(written))
    assert Check(clean).run() == 0
    assert "1 note" in capsys.readouterr().out


def test_text_from_the_file_is_not_taken_for_markup(square_pattern, tmp_path, capsys):
    front = json.loads(json.dumps(to_specification(square_pattern)))
    front["pattern"]["panels"]["[bold]x[/nope]"] = front["pattern"]["panels"].pop("front")
    front["pattern"]["stitches"] = []
    path = tmp_path / "p.json"
    path.write_text(json.dumps(front))
    assert Check(path).run() == 1
    assert "[bold]x[/nope]" in capsys.readouterr().out


def test_unreadable_files_raise_or_print_json(tmp_path, capsys):
    with pytest.raises(InputError, match="No such file"):
        Check(tmp_path / "none.json").run()
    text = tmp_path / "p.json"
    text.write_text("{}")
    with pytest.raises(PatternError, match="no 'pattern'"):
        Check(text).run()
    assert Check(text, json=True).run() == 2
    printed = json.loads(capsys.readouterr().out)
    assert printed["ok"] is False and "no 'pattern'" in printed["error"]


def test_panels_inside_the_default_body_are_found(square_pattern, tmp_path):
    from dataclasses import replace

    from swifttailor.body import Body
    from swifttailor.body.probe import probe_body
    from swifttailor.pattern import Placement, check_pattern

    probe = probe_body(Body.default())
    assert 140 < probe.top < 210 and abs(probe.bottom) < 1
    distances = probe.signed_distance(np.array([[0.0, 110.0, 0.0], [0.0, 110.0, 60.0]]))
    assert distances[0] < -5 and distances[1] > 30
    front = replace(square_pattern.panels[0], placement=Placement((0.0, 80.0, 2.0)))
    path = replace(square_pattern, panels=(front, square_pattern.panels[1])).save(tmp_path / "p.json")
    assert "inside-body" in [f.code for f in check_pattern(load_pattern(path), body=probe)]
    assert Check(path).run() == 1 and Check(path, body=False).run() == 0


def test_the_options_parse(tmp_path):
    parsed = tyro.cli(Check, args=["p.json", "--repair", "o.json", "--json", "--rotation", "extrinsic"])
    assert parsed.pattern.name == "p.json" and parsed.repair is not None and parsed.repair.name == "o.json"
    assert parsed.json and parsed.rotation == "extrinsic" and parsed.body
    assert not tyro.cli(Check, args=["p.json"]).json


def test_as_a_process(faulty, tmp_path):
    program = "import sys, tyro; from swifttailor.cli.check import Check; sys.exit(tyro.cli(Check).run())"
    environment = {**os.environ, "PYTHONIOENCODING": "ascii", "NO_COLOR": "1"}
    done = subprocess.run(
        [sys.executable, "-c", program, str(faulty)], capture_output=True, text=True, env=environment
    )
    assert done.returncode == 1 and "duplicate-stitch" in done.stdout and done.stderr == ""


def test_of_very_many_findings_the_first_are_printed_and_all_on_request(tmp_path, capsys):
    count = 300
    file = specification_of_many_faults(count)
    path = tmp_path / "hostile.json"
    path.write_text(json.dumps(file))
    assert run(["check", str(path)]) == 1
    said = capsys.readouterr().out.splitlines()
    assert len(said) < 100
    assert any(line.startswith("error") for line in said[:2]), "gravest first"
    assert run(["check", str(path), "--json"]) == 1
    found = len(json.loads(capsys.readouterr().out)["findings"])
    assert found == count
    assert f"... and {found - 40:,} more findings. All of them: --all, or --json" in said
    assert run(["check", str(path), "--all"]) == 1
    everything = capsys.readouterr().out
    assert everything.count("dangling-stitch") == count and "more findings" not in everything
    assert run(["check", str(path), "--repair", str(tmp_path / "repaired.json")]) in (0, 1)
    repaired = capsys.readouterr().out
    assert repaired.count("mended") == 40 and "more changes" in repaired


def specification_of_many_faults(count):
    """A T-shirt with so many stitches to nowhere."""
    file = json.loads(json.dumps(to_specification(draft("t-shirt"))))
    nowhere = [[{"panel": "nowhere", "edge": k}, {"panel": "nowhere", "edge": k + 1}] for k in range(count)]
    file["pattern"]["stitches"] += nowhere
    return file
