"""Whatever is put in: exit code 2, a sentence, no traceback, in bounded time, and no file touched."""

from __future__ import annotations

import gzip
import json

import pytest

from swifttailor.cli.main import run
from swifttailor.output_folder import OutputFolder
from swifttailor.pattern.drafts import draft
from swifttailor.pattern.garmentcode_writer import to_specification


def specification(**panel_changes) -> dict:
    """A sound skirt, one panel of which is changed."""
    value = json.loads(json.dumps(to_specification(draft("fitted-skirt"))))
    next(iter(value["pattern"]["panels"].values())).update(panel_changes)
    return value


def million_vertices() -> str:
    vertices = ",".join(f"[{k},{k % 7}]" for k in range(1_000_000))
    return json.dumps(specification(vertices="HERE")).replace('"HERE"', f"[{vertices}]")


BAD = {
    "picture": b"\x89PNG\r\n\x1a\n" + bytes(range(256)) * 40,
    "empty": b"",
    "truncated": lambda: json.dumps(specification())[:3000],
    "nested": b"[" * 500_000,
    "nested objects": b'{"pattern":' * 200_000,
    "million vertices": million_vertices,
    "nan": lambda: json.dumps(specification(translation=[float("nan"), 0, 0])),
    "huge number": lambda: json.dumps(specification(translation=[0, 0, "H"])).replace('"H"', "1e400"),
    "long integer": lambda: json.dumps(specification(translation=[0, 0, "H"])).replace('"H"', "9" * 5000),
    "wrong type": lambda: json.dumps(specification(edges="none")),
    "open loop": lambda: json.dumps(specification(edges=[{"endpoints": [0, 1]}, {"endpoints": [2, 3]}])),
    "utf-16": lambda: json.dumps(specification()).encode("utf-16"),
    "null": b"null",
    "zeros": bytes(10_000),
}


@pytest.fixture(scope="module")
def bad_files(tmp_path_factory):
    folder = tmp_path_factory.mktemp("bad")
    for name, content in BAD.items():
        content = content() if callable(content) else content
        data = content.encode() if isinstance(content, str) else content
        (folder / f"{name}.json").write_bytes(data)
    (folder / "directory.json").mkdir()
    return folder


NAMES = [*BAD, "directory", "missing"]
COMMANDS = {
    "check": lambda file, out: ["check", file],
    "check --json": lambda file, out: ["check", file, "--json"],
    "check --repair": lambda file, out: ["check", file, "--repair", out / "pattern.json"],
    "drape": lambda file, out: ["drape", file, "--out", out],
    "drape --repair": lambda file, out: ["drape", file, "--out", out, "--repair"],
    "drape --json": lambda file, out: ["drape", file, "--out", out, "--json"],
    "convert": lambda file, out: ["convert", file, out / "pattern.svg"],
    "convert to pdf": lambda file, out: ["convert", file, out / "pattern.pdf"],
    "marker": lambda file, out: ["marker", file, "--out", out / "marker.svg"],
    "draft --design": lambda file, out: ["draft", "--design", file, "--out", out / "pattern.json"],
    "ggi": lambda file, out: ["ggi", file, "--out", out],
    "ggi --decode": lambda file, out: ["ggi", "--decode", file, "--out", out],
}
EXISTING = ("pattern.json", "pattern.svg", "garment.glb", "garment.obj", "preview.png", "report.json")


@pytest.mark.timeout(60)
@pytest.mark.parametrize("command", list(COMMANDS))
@pytest.mark.parametrize("name", NAMES)
def test_bad_patterns(name, command, bad_files, tmp_path, capsys):
    with OutputFolder(tmp_path).fill() as folder:
        for file in EXISTING:
            (folder / file).write_text("from before")
    code = run([str(a) for a in COMMANDS[command](bad_files / f"{name}.json", tmp_path)])
    captured = capsys.readouterr()
    if name == "open loop" and command.startswith("check"):
        assert code in (1, 2)  # a fault that check can describe
        return
    assert code == 2
    assert "Traceback" not in captured.out + captured.err
    if command.endswith("--json"):
        said = json.loads(captured.out)["error"]
    else:
        assert captured.out == ""
        said = captured.err
    assert 20 < len(said) < 700 and f"{name}.json" in said
    assert {p.name for p in tmp_path.iterdir()} == {*EXISTING, ".swifttailor"}
    assert {(tmp_path / file).read_text() for file in EXISTING} == {"from before"}


@pytest.mark.timeout(60)
@pytest.mark.parametrize("name", [n for n in NAMES if n not in ("million vertices",)])
@pytest.mark.parametrize("ending", [".obj", ".glb"])
def test_bad_bodies(name, ending, bad_files, tmp_path, capsys):
    body = tmp_path / f"body{ending}"
    if name == "directory":
        body.mkdir()
    elif name != "missing":
        body.write_bytes((bad_files / f"{name}.json").read_bytes())
    pattern = draft("fitted-skirt").save(tmp_path / "skirt.json")
    for arguments in (
        ["drape", pattern, "--body", body, "--out", tmp_path / "out"],
        ["draft", "t-shirt", "--body", body, "--out", tmp_path / "out.json"],
    ):
        assert run([str(a) for a in arguments]) == 2
        captured = capsys.readouterr()
        assert captured.out == "" and "Traceback" not in captured.err and body.name in captured.err
    assert not (tmp_path / "out").exists() and not (tmp_path / "out.json").exists()


@pytest.mark.parametrize("name", ["a\0b.json", "x" * 5000 + ".json", ""])
def test_impossible_file_names(name, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    sound = str(draft("fitted-skirt").save(tmp_path / "skirt.json"))
    for arguments in (
        ["check", name],
        ["check", sound, "--repair", name],
        ["drape", name, "--out", "out"],
        ["convert", name, "x.svg"],
        ["convert", sound, name],
        ["ggi", name, "--out", "out"],
        ["ggi", "--decode", name, "--out", "out"],
        ["draft", "t-shirt", "--out", name],
        *([["drape", sound, "--out", name], ["drape", "--batch", name, "--out", "out"]] if name else []),
    ):
        assert run(arguments) == 2, arguments
        assert "Traceback" not in capsys.readouterr().err
    assert [p.name for p in tmp_path.iterdir()] == ["skirt.json"]


def test_batch_files_that_are_none(tmp_path, capsys):
    for name, data in {
        "a.jsonl": b"",
        "b.jsonl.gz": b"not gzip",
        "c.jsonl.gz": gzip.compress(b"{}" * 1000)[:12],
        "d.jsonl.gz": gzip.compress(b"")[:8],
        "e.jsonl.gz": b"",
    }.items():
        (tmp_path / name).write_bytes(data)
        out = tmp_path / f"{name}-out"
        assert run(["drape", "--batch", str(tmp_path / name), "--out", str(out)]) == 2, name
        captured = capsys.readouterr()
        assert captured.out == "" and "Traceback" not in captured.err and name in captured.err
        assert not out.exists()
