"""``swifttailor evaluate pattern-maker`` with an untrained network."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import pytest
from maker_standins import given, write_edits, write_patterns

from swifttailor.cli.main import run
from swifttailor.evaluation.maker.run import Plan
from swifttailor.evaluation.results_page import results_page
from swifttailor.pattern.check.repair import Repair
from swifttailor.pattern.drafts import draft
from swifttailor.pattern_maker import maker as maker_module
from swifttailor.pattern_maker.maker import PatternMaker
from swifttailor.wishes.heard import Heard

TINY = Path(__file__).parents[1] / "pattern_maker" / "tiny_maker.zip"
TINY_SEWER = Path(__file__).parents[1] / "garment_sewer" / "tiny_sewer.onnx"


@pytest.fixture(scope="module")
def files(tmp_path_factory) -> tuple[Path, Path]:
    folder = tmp_path_factory.mktemp("asked")
    return write_patterns(folder), write_edits(folder)


def arguments(files, out: Path, *more: str) -> list[str]:
    given = ["evaluate", "pattern-maker", "--patterns", str(files[0]), "--out", str(out)]
    return [*given, "--weights", str(TINY), *more]


@pytest.fixture
def calls(monkeypatch) -> list[int]:
    """How many requests were answered together, call by call; the scribble that is written is not mended."""
    monkeypatch.setattr(maker_module, "mend", lambda pattern, *, alike: Repair(pattern, (), ()))
    seen: list[int] = []
    real = PatternMaker.generate_all

    def counted(self, requests, **more):
        seen.append(len(requests))
        return real(self, requests, **more)

    monkeypatch.setattr(PatternMaker, "generate_all", counted)
    return seen


def test_the_command_asks_prints_writes_and_goes_on(files, tmp_path, capsys, calls):
    out = tmp_path / "answers"
    asked = arguments(
        files, out, "--network-alone", "--edits", str(files[1]), "--limit", "1", "--pictures", "1"
    )
    assert run([*asked, "--samples", "1"]) == 0
    shown = capsys.readouterr().out
    assert calls == [1, 2, 1, 2], "a text and an edit both ways, then a sample of each"
    assert "questions: 1 text, 2 edit; seed 0" in shown and "tiny_maker.zip" in shown
    assert "answers of the network alone, temperature 0, one pattern each" in shown
    assert "commit" in shown and "cores" in shown and "patterns.jsonl: 4, at most 1 chosen by lot" in shown
    assert "paper: PatternMaker" in shown and "input unchanged" in shown and "#Sampling" in shown
    names = {p.name for p in out.iterdir()} - {".swifttailor"}
    written = {"answers.jsonl", "samples.jsonl", "scores.jsonl", "settings.json", "summary.json"}
    assert names == written | {"tables.txt", "sheet-text-01.png", "sheet-edit-01.png"}
    assert (out / "tables.txt").read_text() == shown
    summary = json.loads((out / "summary.json").read_text())
    assert summary["about"]["questions"] == {"text": 1, "edit": 2}
    lines = [json.loads(line) for line in (out / "scores.jsonl").read_text().splitlines()]
    assert [line["question"].split("/")[0] for line in lines] == ["text", "edit", "edit"]
    ours = summary["tasks"]["text"]["patterns"]["PatternMaker"]["by_name"]["vertex_cm"]
    assert ours["mean"] == pytest.approx(lines[0]["by_name"]["vertex_cm"])
    page = results_page([out / "summary.json"])
    assert "### Patterns edited after an instruction, there and back" in page
    assert "--edits edits.jsonl" in page and "| input unchanged |" in page and "#Sampling" in page
    sampled = summary["sampling"]["edit"]
    assert sampled["closed"] == sampled["paired"] == sampled["samples"] == 2

    calls.clear()
    answers = (out / "answers.jsonl").read_bytes()
    assert run([*asked, "--samples", "0", "--tasks", "text", "--json", "--pictures", "0"]) == 0
    again = json.loads(capsys.readouterr().out)
    assert calls == [] and (out / "answers.jsonl").read_bytes() == answers
    assert list(again["tasks"]) == ["text"] and again["sampling"] == {}
    assert again["tasks"]["text"] == summary["tasks"]["text"]

    assert run([*asked, "--samples", "0", "--seed", "3"]) == 2
    assert "seed was 0, now 3" in capsys.readouterr().err


def test_pictures_are_asked_for_where_there_are_drapes(files, data, tmp_path, capsys, monkeypatch):
    from swifttailor.data.renders.files import RenderSettings
    from swifttailor.evaluation.maker import pictures

    monkeypatch.setattr(pictures, "RenderSettings", lambda: RenderSettings(24, 2, False))
    shown_to: list[tuple[int, ...]] = []

    def answer(self, requests, **more):
        shown_to.extend(r.image.shape for r in requests)
        return [given(draft("fitted-skirt"))] * len(requests)

    monkeypatch.setattr(PatternMaker, "generate_all", answer)
    asked = arguments(files, tmp_path, "--data", str(data), "--tasks", "image", "--samples", "0")
    asked.append("--network-alone")
    assert run([*asked, "--pictures", "3", "--garments", "--sewer-weights", str(TINY_SEWER)]) == 0
    assert shown_to == [(24, 24, 3)] * 3, "there are drapes of three of the four patterns"
    shown = capsys.readouterr().out
    assert "questions: 3 image" in shown and "drawn of the drapes of validation" in shown
    assert (tmp_path / "sheet-image-01.png").is_file()
    assert "PatternMaker + GarmentSewer, image" in shown and "true patterns + GarmentSewer" in shown
    summary = json.loads((tmp_path / "summary.json").read_text())
    compared = summary["garments"]["image"]
    assert compared["answers"]["references"] == 3 and compared["unsewable"] == {}
    # Three times the same skirt is next to one of the three drapes alone.
    assert compared["answers"]["coverage"] == pytest.approx(1 / 3)
    assert compared["chamfer"] > compared["floor"]["mmd"] > 0
    assert summary["about"]["sewer_weights"]["file"] == "tiny_sewer.onnx"


def test_without_options_it_measures_what_generate_and_edit_do(files, tmp_path, capsys, monkeypatch):
    """The first pattern of each question lacks a seam: it is written again, warmer, and altered."""
    seen: list[tuple[int, float]] = []

    def answer(self, requests, *, seed, temperature, draw):
        seen.append((draw, round(temperature, 2)))
        shirt = draft("t-shirt")
        return [given(shirt if draw else replace(shirt, stitches=shirt.stitches[1:])) for _ in requests]

    monkeypatch.setattr(PatternMaker, "generate_all", answer)
    monkeypatch.setattr(Heard, "drafts", ())  # else nobody is asked to write
    out = tmp_path / "out"
    asked = arguments(files, out, "--sewer-weights", str(TINY_SEWER), "--samples", "0", "--pictures", "0")
    assert run([*asked, "--limit", "1"]) == 0
    assert seen[:2] == [(0, 0.2), (1, 0.35)]
    shown = capsys.readouterr().out
    assert "answers as swifttailor generate and edit give them, temperature 0.2, at most 4 attempts" in shown
    settings = json.loads((out / "settings.json").read_text())
    assert {"altered_by", "sewn_by"} <= set(settings["weights"])
    assert (settings["alter"], settings["crop"], settings["network_alone"]) == (True, True, False)
    (line,) = (json.loads(line) for line in (out / "answers.jsonl").read_text().splitlines())
    assert line["attempts"] == len(seen) > 1 and line["errors"] == 0
    assert f"{len(seen):.2f} patterns were tried for an answer, 1.00 until one could be made" in shown
    assert run([*asked, "--limit", "1", "--no-alter"]) == 2
    assert "alter was True, now False" in capsys.readouterr().err


def test_interrupted_it_says_how_to_go_on(files, tmp_path, capsys, monkeypatch):
    def interrupt(self, requests, **more):
        raise KeyboardInterrupt

    monkeypatch.setattr(PatternMaker, "generate_all", interrupt)
    assert run(arguments(files, tmp_path, "--limit", "1")) == 130
    assert f"kept in {tmp_path}; the same command goes on" in capsys.readouterr().err


def test_without_the_grammar_answers_that_are_no_patterns_have_a_reason(files, tmp_path, capsys):
    """The network is untrained: it writes none."""
    out = tmp_path / "free"
    asked = arguments(files, out, "--network-alone", "--decoding", "free", "--samples", "0")
    assert run(asked) == 2
    assert "Of 4 questions none was answered" in capsys.readouterr().err
    records = [json.loads(line) for line in (out / "answers.jsonl").read_text().splitlines()]
    assert len(records) == 4 and all("no pattern. Token" in record["error"] for record in records)
    assert json.loads((out / "settings.json").read_text())["decoding"] == "free"


def test_patterns_that_cannot_be_used_are_named(files, tmp_path, capsys, calls):
    bad = tmp_path / "bad.jsonl"
    bad.write_text('{"id": "broken", "pattern": {}}\n' + files[0].read_text().splitlines()[1] + "\n")
    out = tmp_path / "out"
    assert run(arguments((bad,), out, "--network-alone", "--samples", "0", "--pictures", "0")) == 1
    shown = capsys.readouterr().out
    assert "broken: not asked for." in shown and calls == [1]
    assert json.loads((out / "summary.json").read_text())["about"]["skipped"].keys() == {"broken"}


@pytest.mark.parametrize(
    ("more", "message"),
    [
        (["--tasks", "image"], "'image' needs pictures: give --data DIR"),
        (["--tasks", "text", "edit"], "'edit' needs edits: give --edits FILE"),
        (["--limit", "0"], "--limit is 0"),
        (["--seed", "-1"], "--seed is -1; from 0"),
        (["--temperature", "nan"], "--temperature is nan; from 0 to 10"),
        (["--attempts", "3", "--temperature", "0"], "At temperature 0 all 3 attempts are the same"),
        (["--network-alone", "--attempts", "3"], "--attempts is of no use with --network-alone"),
        (["--network-alone", "--no-alter"], "--no-alter is of no use with --network-alone"),
        (["--network-alone", "--no-crop"], "--no-crop is of no use with --network-alone"),
        (["--network-alone", "--sewer-weights", "x"], "--sewer-weights is of no use with --network-alone"),
        (["--decoding", "free"], "--decoding free is about the network alone"),
        (["--attempts", "0"], "--attempts is 0; from 1 to 64"),
        (["--samples", "-1"], "--samples is -1; from 0"),
        (["--garments"], "--garments compares with drapes: give the data set"),
        (["--sewer-weights", "x.onnx"], "Cannot read the weights 'x.onnx'"),
        (["--threads", "0"], "--threads is 0; from 1 to 256"),
        (["--pictures", "900"], "--pictures is 900; from 0"),
        (["--weights", "nowhere.zip"], "Cannot read the weights 'nowhere.zip'"),
        (["--data", "nowhere"], "holds no data set"),
        (["--edits", "nowhere.jsonl"], "no file or folder 'nowhere.jsonl'"),
        (["--patterns", "nowhere.jsonl"], "no file or folder 'nowhere.jsonl'"),
    ],
)
def test_what_cannot_be_done_is_said(files, tmp_path, capsys, more, message):
    out = tmp_path / "out"
    assert run(arguments(files, out, *more)) == 2
    assert message in capsys.readouterr().err
    assert not (out / "answers.jsonl").exists()


def test_tasks_are_those_that_there_is_something_for():
    here = Path()
    assert Plan((here,)).chosen_tasks() == ("text",)
    assert Plan((here,), edits=here).chosen_tasks() == ("text", "edit")
    assert Plan((here,), here, here).chosen_tasks() == ("text", "image", "text+image", "edit")
    assert Plan((here,), here, here, ("edit", "image")).chosen_tasks() == ("image", "edit")
