from __future__ import annotations

import gzip
import json
from pathlib import Path

import pytest
from sample_makers import make_placed, run_here

from swifttailor.cli.data import DATA
from swifttailor.cli.main import run
from swifttailor.data.builder import BuildSettings, build_split
from swifttailor.data.edits.edit_file import read_edits
from swifttailor.data.pattern_source import patterns_of
from swifttailor.describing import Claim, measure_facts
from swifttailor.draping.batch import BatchSettings
from swifttailor.pattern import read_specification
from swifttailor.pattern.drafts import draft
from swifttailor.pattern.garmentcode_writer import to_specification
from swifttailor.pattern.pattern_list import read_patterns


@pytest.fixture
def patterns(tmp_path) -> Path:
    path = tmp_path / "garments.jsonl"
    lines = [{"id": n, "pattern": to_specification(draft(n))} for n in ("fitted-skirt", "tank-top")]
    path.write_text("\n".join(json.dumps(line) for line in lines))
    return path


@pytest.fixture
def dataset(patterns, tmp_path) -> Path:
    coarse = BuildSettings(BatchSettings(edge_length=8.0, preview=False))
    build_split(read_patterns(patterns), tmp_path / "set", "train", coarse, runner=run_here, make=make_placed)
    return tmp_path / "set"


def test_overview_and_help(capsys):
    assert run(["data", "--help"]) == 0
    shown = capsys.readouterr().out
    for name, command in DATA.commands.items():
        assert f"  {name}" in shown and command.summary in shown
        assert run(["data", name, "--help"]) == 0
        assert f"usage: swifttailor data {name}" in capsys.readouterr().out
    assert run(["data"]) == 2 and "usage: swifttailor data" in capsys.readouterr().err
    assert run(["data", "bild"]) == 2
    assert "There is no command 'data bild'. Did you mean 'data build'?" in capsys.readouterr().err


def test_build_says_what_came_of_it(patterns, tmp_path, capsys):
    out = tmp_path / "out"
    arguments = ["data", "build", "--patterns", str(patterns), "--out", str(out), "--edge-length", "8"]
    assert run([*arguments, "--limit", "1", "--workers", "1"]) == 0
    captured = capsys.readouterr()
    assert "1 patterns: " in captured.out and str(out / "garments") in captured.out
    assert "1/1" in captured.err and "left" in captured.err
    assert run([*arguments, "--workers", "2"]) == 0
    captured = capsys.readouterr()
    assert "2 patterns: " in captured.out and "going on: 1 were done before" in captured.err
    assert run(arguments) == 0 and "2 patterns: " in capsys.readouterr().out


@pytest.mark.parametrize(
    ("options", "message"),
    [
        (["--split", "a/b"], "The split's name 'a/b' cannot be that of a folder"),
        (["--split", ""], "The split's name ''"),
        (["--ray", "local", "--workers", "2"], "exclude each other"),
        (["--edge-length", "0.1"], "from 0.5 to 10 cm"),
        (["--seed", "-1"], "--seed is -1"),
        (["--workers", "0"], "from 1 to 1024"),
        (["--limit", "0"], "--limit is 0"),
        (["--time-limit", "nan"], "--time-limit is nan"),
        (["--fabric", "brocade"], "brocade"),
    ],
)
def test_options_of_build_that_cannot_be(options, message, patterns, tmp_path, capsys):
    out = tmp_path / "out"
    assert run(["data", "build", "--patterns", str(patterns), "--out", str(out), *options]) == 2
    assert message in capsys.readouterr().err
    assert not out.exists()


def test_verify_render_and_stats(dataset, capsys):
    assert run(["data", "verify", str(dataset), "--workers", "1"]) == 0
    assert capsys.readouterr().out == f"{dataset}: 2 samples, no faults\n"
    assert run(["data", "render", str(dataset), "--size", "32", "--random", "1", "--workers", "1"]) == 0
    assert "3 pictures of each of 2 garments" in capsys.readouterr().out
    assert run(["data", "stats", str(dataset), "--samples", "1", "--workers", "1"]) == 0
    assert "train: 2 of 2 patterns accepted (100.0%)" in capsys.readouterr().out
    names = {p.name for p in (dataset / "stats").iterdir()}
    assert names == {".swifttailor", "index.html", "pictures", "stats.json", "train-01.png"}
    assert run(["data", "stats", str(dataset / "train"), "--samples", "0", "--workers", "1", "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["train"]["accepted"] == 2
    next((dataset / "train").glob("shard-*")).write_bytes(b"")
    assert run(["data", "verify", str(dataset), "--workers", "1", "--json"]) == 1
    report = json.loads(capsys.readouterr().out)
    assert report["ok"] is False and report["faults"][0]["file"].startswith("train/shard-00000")
    assert run(["data", "verify", str(dataset), "--workers", "1"]) == 1
    assert capsys.readouterr().out.endswith(": 0 samples, 1 fault\n")


@pytest.mark.parametrize("command", ["verify", "render", "stats"])
def test_no_data_set(command, tmp_path, capsys):
    assert run(["data", command, str(tmp_path)]) == 2
    assert f"'{tmp_path}' holds no data set" in capsys.readouterr().err


def captions_in(text: str) -> dict[str, list[dict]]:
    return {line["id"]: line["captions"] for line in map(json.loads, text.splitlines())}


def test_captions_of_every_kind_of_source(dataset, patterns, tmp_path, capsys):
    assert run(["data", "captions", str(dataset), "--count", "2"]) == 0
    out = dataset / "train" / "captions.jsonl"
    assert capsys.readouterr().out == f"2 captions of each of 2 patterns in {out}\n"
    written = captions_in(out.read_text())
    assert set(written) == {"fitted-skirt", "tank-top"}
    for id, captions in written.items():
        facts = measure_facts(draft(id))
        assert len(captions) == 2 and len({c["text"] for c in captions}) == 2
        for caption in captions:
            claims = [Claim(**values) for values in caption["claims"]]
            assert claims and all(claim.holds(facts) for claim in claims)
    assert run(["data", "captions", str(patterns), "--count", "2"]) == 0
    assert captions_in(capsys.readouterr().out) == written
    folder = tmp_path / "folder"
    folder.mkdir()
    for id in written:
        (folder / f"{id}.json").write_text(json.dumps(to_specification(draft(id))))
    assert run(["data", "captions", str(folder), "--count", "2", "--out", str(tmp_path / "all.jsonl")]) == 0
    assert captions_in((tmp_path / "all.jsonl").read_text()) == written
    capsys.readouterr()
    single = ["data", "captions", str(folder / "tank-top.json"), "--text", "--style", "terse", "--count", "3"]
    assert run(single) == 0
    lines = capsys.readouterr().out.splitlines()
    assert len(lines) == 3 and all(len(line.split()) <= 8 for line in lines)


def test_what_cannot_be_read_is_complained_of_and_the_rest_captioned(patterns, capsys):
    patterns.write_text(patterns.read_text() + '\n{"id": "bad", "pattern": {}}\nnonsense\n')
    assert run(["data", "captions", str(patterns), "--count", "1"]) == 1
    captured = capsys.readouterr()
    assert len(captured.out.splitlines()) == 2
    assert captured.err.startswith("bad: ") and "\n#4: " in captured.err
    assert run(["data", "captions", str(patterns), "--style", "haiku"]) == 2
    assert "no caption style 'haiku'" in capsys.readouterr().err
    assert run(["data", "captions", str(patterns.with_name("none.jsonl"))]) == 2


@pytest.mark.parametrize("ending", ["jsonl", "jsonl.gz"])
def test_edits_can_be_read_back_and_do_what_they_say(ending, patterns, tmp_path, capsys):
    longer = to_specification(draft("fitted-skirt", length=90))
    designs = tmp_path / "designs.jsonl"
    designs.write_text(json.dumps({"id": "e1", "base": "fitted-skirt", "pattern": longer}) + "\n")
    out = tmp_path / f"edits.{ending}"
    arguments = ["data", "edits", str(patterns), "--designs", str(designs), "--count", "1", "--out"]
    assert run([*arguments, str(out)]) == 0
    raw = out.read_bytes()
    lines = [json.loads(x) for x in (gzip.decompress(raw) if ending.endswith("gz") else raw).splitlines()]
    assert capsys.readouterr().out == f"{len(lines)} pairs in {out}\n"
    assert [line["source"] for line in lines[-2:]] == ["design", "design, reversed"]
    assert {line["base"] for line in lines} == {"fitted-skirt", "tank-top"}
    assert [line["id"] for line in lines[-2:]] == ["e1/design", "e1/design, reversed"]
    assert len({line["id"] for line in lines}) == len(lines)
    for line in lines:
        before, after = (measure_facts(read_specification(line[k]).pattern) for k in ("pattern", "edited"))
        assert line["instruction"] and line["changes"]
        for change in line["changes"]:
            if "gain" in change:
                claim = Claim(**change["gain"])
                assert claim.holds(after) and not claim.holds(before)
    assert run([*arguments, str(tmp_path / f"again.{ending}")]) == 0
    assert (tmp_path / f"again.{ending}").read_bytes() == raw


def test_designs_that_cannot_be_used_are_complained_of(patterns, tmp_path, capsys):
    designs = tmp_path / "designs.jsonl"
    lines = [{"id": "e1", "pattern": to_specification(draft("fitted-skirt", length=90))}]
    lines.append({"id": "e2", "base": "fitted-skirt", "pattern": {}})
    designs.write_text("\n".join(map(json.dumps, lines)))
    arguments = ["data", "edits", str(patterns), "--designs", str(designs), "--count", "0", "--out"]
    assert run([*arguments, str(tmp_path / "out.jsonl")]) == 1
    errors = capsys.readouterr().err
    assert 'e1: The line names no pattern that was edited: "base" is None' in errors and "\ne2: " in errors
    assert (tmp_path / "out.jsonl").read_bytes() == b""


def test_versions_are_patterns_like_any_others(patterns, tmp_path, capsys):
    out = tmp_path / "recut.jsonl"
    assert run(["data", "edits", str(patterns), "--versions", "--count", "2", "--out", str(out)]) == 0
    lines = [json.loads(line) for line in out.read_text().splitlines()]
    assert capsys.readouterr().out == f"{len(lines)} patterns in {out}\n"
    assert [line["base"] for line in lines] == ["fitted-skirt"] * 2 + ["tank-top"] * 2
    assert len({line["id"] for line in lines}) == 4 and not any("/" in line["id"] for line in lines)
    read = dict(patterns_of(out))
    assert list(read) == [line["id"] for line in lines]
    facts = {base: measure_facts(draft(base)) for base in ("fitted-skirt", "tank-top")}
    for line in lines:
        assert measure_facts(read[line["id"]]) != facts[line["base"]]
    assert [v.base for v in read_edits(out)] == [line["base"] for line in lines]
    arguments = ["data", "edits", str(patterns), "--versions", "--designs", str(out), "--out"]
    assert run([*arguments, str(tmp_path / "x.jsonl")]) == 2


def test_edits_need_a_name_that_says_the_format(patterns, tmp_path, capsys):
    assert run(["data", "edits", str(patterns), "--out", str(tmp_path / "edits.json")]) == 2
    assert ".jsonl or .jsonl.gz is written" in capsys.readouterr().err
    assert run(["data", "edits", str(patterns), "--out", str(tmp_path / "e.jsonl"), "--count", "99"]) == 2
    assert "--count is 99; from 0 to 46" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("command", "name"),
    [
        *(("stats", f"stats/{name}") for name in ("index.html", "stats.json", "train-01.png")),
        ("stats", "stats/pictures/train-000000-front.webp"),
        ("captions", "train/captions.jsonl"),
        *(("render", f"train/renders/{name}") for name in ("index.json", "renders-mine.safetensors")),
    ],
)
def test_files_of_others_in_a_data_set_stay(command, name, dataset, capsys):
    (dataset / name).parent.mkdir(parents=True, exist_ok=True)
    (dataset / name).write_text("my own work")
    before = (dataset / name).stat().st_mtime_ns
    size = {"render": ["--size", "32", "--random", "1"]}.get(command, [])
    more = ["--workers", "1"] if command != "captions" else []
    samples = ["--samples", "2"] if command == "stats" else []
    assert run(["data", command, str(dataset), *size, *more, *samples]) == 2
    said = capsys.readouterr().err
    assert "would be replaced" in said or "is damaged" in said or "holds no renders" in said
    assert (dataset / name).read_text() == "my own work"
    assert (dataset / name).stat().st_mtime_ns == before
    assert [p.name for p in (dataset / name).parent.iterdir()].count(Path(name).name) == 1


def test_only_shards_of_a_killed_build_are_removed(dataset, patterns):
    mine = dataset / "train" / "shard-of-mine.safetensors"
    left = dataset / "train" / "shard-00007-0123456789ab.safetensors"
    for path in (mine, left):
        path.write_text("x")
    coarse = BuildSettings(BatchSettings(edge_length=8.0, preview=False))
    build_split(read_patterns(patterns), dataset, "train", coarse, runner=run_here, make=make_placed)
    assert mine.read_text() == "x" and not left.exists()
