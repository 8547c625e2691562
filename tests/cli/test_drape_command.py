from __future__ import annotations

import dataclasses
import itertools
import json
import re
from pathlib import Path

import pytest
from old_style import old_style

import swifttailor.draping
from swifttailor.body import Body
from swifttailor.cli.main import run
from swifttailor.describing import measure_facts
from swifttailor.describing.differences import Step
from swifttailor.draping import FABRICS, time_limit
from swifttailor.draping.engines import engine_names
from swifttailor.draping.quality import WHEN_TOO_TIGHT, not_accepted_line
from swifttailor.garment.garment import Garment
from swifttailor.output_folder import OutputFolder
from swifttailor.pattern import Pattern, load_pattern
from swifttailor.pattern.drafts import draft
from swifttailor.wishes.instructions.hearing_changes import hear_instruction
from swifttailor.wishes.reader import WishReader

FILES = ["garment.glb", "garment.obj", "pattern.json", "pattern.svg", "preview.png", "report.json"]
COARSE = ["--edge-length", "6"]


@pytest.fixture(scope="module")
def skirt(tmp_path_factory) -> Path:
    return draft("fitted-skirt").save(tmp_path_factory.mktemp("patterns") / "skirt.json")


@pytest.fixture
def judge(monkeypatch):
    """Lets a test decide what the limits of quality say; the drape itself is real."""

    def decide(*reasons: str) -> None:
        real = swifttailor.draping.drape

        def drape(*arguments, **options):
            garment = real(*arguments, **options)
            quality = garment.report["quality"] | {"accepted": not reasons, "reasons": list(reasons)}
            return dataclasses.replace(garment, report=garment.report | {"quality": quality})

        monkeypatch.setattr(swifttailor.draping, "drape", drape)

    return decide


def test_an_accepted_garment(skirt, tmp_path, judge, capsys):
    judge()
    out = tmp_path / "new" / "skirt"
    assert run(["drape", str(skirt), "--out", str(out), *COARSE]) == 0
    assert sorted(p.name for p in out.iterdir()) == [".swifttailor", *FILES]
    captured = capsys.readouterr()
    assert captured.out.startswith("Accepted: ")
    assert str(out / "preview.png") in captured.out and str(out / "report.json") in captured.out
    assert [line for line in captured.err.splitlines() if line.startswith("sewing")]
    report = json.loads((out / "report.json").read_text())
    assert report["quality"]["accepted"] is True and report["edge_length_cm"] == 6
    assert {"loading", "meshing", "sewing", "draping", "measuring"} <= set(report["seconds"])
    assert load_pattern(out / "pattern.json").canonical() == load_pattern(skirt).canonical()


def test_a_garment_beyond_the_limits_is_written_with_the_reasons(skirt, tmp_path, judge, capsys):
    judge("did not come to rest", "too tight")
    assert run(["drape", str(skirt), "--out", str(tmp_path), "--no-preview", *COARSE]) == 1
    assert capsys.readouterr().out.startswith("Not accepted: did not come to rest; too tight.\n")
    assert sorted(p.name for p in tmp_path.iterdir()) == [
        ".swifttailor",
        *(f for f in FILES if f != "preview.png"),
    ]


@pytest.mark.parametrize(("strain", "advised"), [(0.28, True), (0.12, False)])
def test_what_is_too_tight_says_what_to_do(strain, advised):
    quality = {"accepted": False, "reasons": ["too tight", "not where it is worn"], "strain_p95": strain}
    line = not_accepted_line(quality)
    assert line.startswith("not accepted: too tight; not where it is worn.")
    assert line.endswith(WHEN_TOO_TIGHT) == advised
    assert not_accepted_line(quality | {"accepted": True}) == ""
    words = re.findall('"(.*?)"', WHEN_TOO_TIGHT)
    heard = hear_instruction(words[0], WishReader.load(), measure_facts(draft("t-shirt")))
    assert [wish.change for wish in heard.sure] == [Step("chest", 1, 5.0)]


def misplaced_lines(said: str) -> list[str]:
    """What is said of where panels stand, whichever command says it."""
    return [line.partition("misplaced-panel")[2] for line in said.splitlines() if "misplaced-panel" in line]


def test_what_check_finds_is_said_and_exit_code_1(tmp_path, judge, capsys):
    """A skirt of another program, around the origin: an accepted drape does not make it right."""
    judge()
    old = old_style(draft("circle-skirt"), names={"skirt_front": "front", "skirt_back": "back"})
    path = old.save(tmp_path / "old.json")
    arguments = ["drape", str(path), "--out", str(tmp_path / "out"), "--no-preview", *COARSE]
    assert run(arguments) == 1
    said = capsys.readouterr().out
    panels = {line.split(")")[0].strip(" (") for line in misplaced_lines(said)}
    assert panels == {p.name for p in old.panels} and "Accepted" in said
    report = json.loads((tmp_path / "out" / "report.json").read_text())
    assert {f["where"] for f in report["findings"] if f["code"] == "misplaced-panel"} == panels

    assert run(["check", str(path)]) == 1
    checked = capsys.readouterr().out
    assert all(f["code"] in checked for f in report["findings"])
    assert checked.count("misplaced-panel") == len(panels)
    assert run([*arguments, "--repair", "--overwrite"]) == 0
    mended = capsys.readouterr().out
    assert "cm up, to where it is worn" in mended and "warning" not in mended
    garment = Garment.load(tmp_path / "out")
    waist = Body.default().measurements.waist_level
    assert abs(garment.vertices[:, 1].max() - waist) < 4.0


def test_what_is_not_where_it_is_worn_is_not_accepted(tmp_path, capsys):
    path = old_style(draft("tank-top")).save(tmp_path / "old.json")
    assert run(["drape", str(path), "--out", str(tmp_path / "out"), "--no-preview", *COARSE]) == 1
    said = capsys.readouterr().out
    assert "Not accepted: not where it is worn: its top is" in said and "slid down" not in said


def test_a_time_limit_is_kept_by_a_single_garment(skirt, tmp_path, capsys, monkeypatch):
    seconds = itertools.count(0, 10)
    monkeypatch.setattr(time_limit.time, "process_time", lambda: next(seconds))
    arguments = ["drape", str(skirt), "--out", str(tmp_path / "out"), "--no-preview", *COARSE]
    assert run([*arguments, "--time-limit", "55"]) == 2
    said = capsys.readouterr().err
    assert "Gave up sewing after 55 seconds" in said and "--edge-length" in said and "Traceback" not in said
    assert not (tmp_path / "out" / "report.json").exists()


def test_a_stitch_to_nowhere_is_refused_before_the_physics(skirt, tmp_path, capsys, monkeypatch):
    specification = json.loads(skirt.read_text())
    specification["pattern"]["stitches"][0][0]["panel"] = "ghost"
    (tmp_path / "ghost.json").write_text(json.dumps(specification))

    def compiled(*_, **__):
        raise AssertionError("the solver was asked for")

    monkeypatch.setattr(swifttailor.draping, "drape", compiled)
    monkeypatch.setattr("swifttailor.draping.compiled_code.solver_is_compiled", compiled)
    assert run(["drape", str(tmp_path / "ghost.json"), "--out", str(tmp_path / "out")]) == 2
    assert "dangling-stitch (ghost" in capsys.readouterr().err


def test_json_is_the_report(skirt, tmp_path, capsys):
    code = run(["drape", str(skirt), "--out", str(tmp_path), "--json", "--no-preview", *COARSE])
    printed = json.loads(capsys.readouterr().out)
    assert printed == json.loads((tmp_path / "report.json").read_text())
    assert code == (0 if printed["quality"]["accepted"] else 1)


def test_errors_as_json(tmp_path, capsys):
    assert run(["drape", "none.json", "--out", str(tmp_path / "x"), "--json"]) == 2
    assert "none.json" in json.loads(capsys.readouterr().out)["error"]


def test_the_same_input_gives_the_same_files(skirt, tmp_path):
    for name in ("a", "b"):
        run(["drape", str(skirt), "--out", str(tmp_path / name), *COARSE])
    for file in FILES:
        if file != "report.json":
            assert (tmp_path / "a" / file).read_bytes() == (tmp_path / "b" / file).read_bytes(), file
    reports = [json.loads((tmp_path / name / "report.json").read_text()) for name in ("a", "b")]
    assert reports[0] | {"seconds": 0} == reports[1] | {"seconds": 0}


def test_other_files_in_the_folder_are_left_alone(skirt, tmp_path):
    (tmp_path / "notes.txt").write_text("mine")
    run(["drape", str(skirt), "--out", str(tmp_path), "--no-preview", *COARSE])
    assert (tmp_path / "notes.txt").read_text() == "mine"


def test_patterns_with_errors_are_refused_and_can_be_mended(skirt, tmp_path, capsys):
    sound = load_pattern(skirt)
    path = Pattern(sound.panels, (*sound.stitches, sound.stitches[0])).save(tmp_path / "twice.json")
    out = tmp_path / "out"
    assert run(["drape", str(path), "--out", str(out), *COARSE]) == 2
    said = capsys.readouterr().err
    assert "duplicate-stitch" in said and "swifttailor check PATTERN --repair REPAIRED" in said
    assert not out.exists()
    assert run(["drape", str(path), "--out", str(out), "--repair", "--no-preview", *COARSE]) in (0, 1)
    assert "Mended duplicate-stitch" in capsys.readouterr().out
    assert load_pattern(out / "pattern.json").canonical() == sound.canonical()
    assert "duplicate-stitch" in json.loads((out / "report.json").read_text())["mended"][0]


def test_a_refusal_leaves_what_was_there(skirt, tmp_path):
    with OutputFolder(tmp_path).fill() as folder:
        for name in FILES:
            (folder / name).write_text("from before")
    assert run(["drape", str(skirt), "--out", str(tmp_path), "--fabric", "brocade"]) == 2
    assert run(["drape", str(skirt), "--out", str(tmp_path), "--body", str(skirt)]) == 2
    assert {(tmp_path / name).read_text() for name in FILES} == {"from before"}


def test_the_newton_engine_says_what_to_install(skirt, tmp_path, capsys, monkeypatch):
    import sys

    monkeypatch.setitem(sys.modules, "newton", None)
    monkeypatch.setitem(sys.modules, "warp", None)
    assert run(["drape", str(skirt), "--out", str(tmp_path / "x"), "--engine", "newton"]) == 2
    assert "swifttailor[newton]" in capsys.readouterr().err
    assert not (tmp_path / "x").exists()


def test_the_help_names_every_choice(capsys):
    assert run(["drape", "--help"]) == 0
    shown = re.sub(r"\s+", " ", capsys.readouterr().out.replace("│", " "))
    for name in (*FABRICS, *engine_names()):
        assert re.search(rf"\b{name}\b", shown), name
    assert "--preview, --no-preview" in shown and "None)" not in shown.split("--out DIR")[1][:60]


def test_a_folder_that_cannot_be_written_is_refused_first(skirt, tmp_path, capsys, monkeypatch):
    monkeypatch.setattr("os.access", lambda path, mode: False)
    assert run(["drape", str(skirt), "--out", str(tmp_path / "x")]) == 2
    assert "cannot be written to" in capsys.readouterr().err
