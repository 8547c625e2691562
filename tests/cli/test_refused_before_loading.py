"""Patterns with errors are refused before anything is compiled, a network loaded, or a file written."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import pytest

import swifttailor
from swifttailor.cli.main import run
from swifttailor.errors import PatternError
from swifttailor.pattern import check_pattern, read_pattern_file, to_specification
from swifttailor.pattern.check import errors_of
from swifttailor.pattern.drafts import draft

HEAVY = ("numba", "llvmlite", "onnxruntime", "trimesh", "torch")
PROBE = f"""
import json, sys
from pathlib import Path
from swifttailor.cli.main import run

codes = [run(arguments) for arguments in json.loads(Path(sys.argv[1]).read_text())]
loaded = [name for name in {HEAVY!r} if name in sys.modules]
Path(sys.argv[2]).write_text(json.dumps([codes, loaded]))
"""


def stitched_to_nothing(file):
    file["pattern"]["stitches"][0][0]["panel"] = "nobody"


def stitched_to_no_edge(file):
    file["pattern"]["stitches"][0][0]["edge"] = 77


def stitched_twice(file):
    stitches = file["pattern"]["stitches"]
    stitches.append([stitches[0][0], stitches[1][0]])


def with_two_edges(file):
    panel = next(iter(file["pattern"]["panels"].values()))
    panel["vertices"], panel["edges"] = panel["vertices"][:2], [{"endpoints": [0, 1]}, {"endpoints": [1, 0]}]
    name = next(iter(file["pattern"]["panels"]))
    stitches = file["pattern"]["stitches"]
    file["pattern"]["stitches"] = [s for s in stitches if all(side["panel"] != name for side in s[:2])]


def with_an_open_outline(file):
    next(iter(file["pattern"]["panels"].values()))["edges"].pop()


DAMAGES = {
    stitched_to_nothing: "--repair removes the stitch",
    stitched_to_no_edge: "--repair removes the stitch",
    stitched_twice: "remove all but one of these stitches",
    with_two_edges: "remove the panel",
    with_an_open_outline: "--repair closes it with a straight edge",
}


def damaged(damage, folder: Path) -> Path:
    file = json.loads(json.dumps(to_specification(draft("t-shirt"))))
    damage(file)
    path = folder / f"{damage.__name__}.json"
    path.write_text(json.dumps(file))
    return path


def commands(pattern: Path, out: Path) -> list[list[str]]:
    place = ["--out", str(out / "made")]
    return [
        ["sew", str(pattern), *place],
        ["sew", str(pattern), "--size", "44", "--finish", *place],
        ["drape", str(pattern), *place],
        ["edit", str(pattern), "make it longer", *place],
        ["fit", str(pattern), "--size", "44", "--out", str(out / "fitted.json")],
        ["marker", str(pattern), "--out", str(out / "marker.svg")],
        *(["convert", str(pattern), str(out / f"made.{end}")] for end in ("pdf", "dxf", "md", "zip", "obj")),
    ]


def test_nothing_heavy_is_imported_for_what_is_refused(tmp_path):
    (tmp_path / "out").mkdir()
    asked = [line for damage in DAMAGES for line in commands(damaged(damage, tmp_path), tmp_path / "out")]
    (tmp_path / "asked").write_text(json.dumps(asked))
    program = [sys.executable, "-c", PROBE, str(tmp_path / "asked"), str(tmp_path / "answer")]
    done = subprocess.run(program, capture_output=True, text=True, timeout=120, check=True)
    codes, loaded = json.loads((tmp_path / "answer").read_text())
    assert codes == [2] * len(asked), done.stderr
    assert loaded == []
    assert list((tmp_path / "out").iterdir()) == []


@pytest.mark.parametrize("damage", DAMAGES)
def test_the_refusal_says_what_is_wrong_and_what_repairs_it(damage, tmp_path, capsys):
    path = damaged(damage, tmp_path)
    reading = read_pattern_file(path)
    errors = errors_of(check_pattern(reading.pattern, reader_findings=reading.findings))
    for arguments in commands(path, tmp_path / "out"):
        assert run(arguments) == 2
        said = "".join(capsys.readouterr())
        assert any(error.message in said for error in errors) and DAMAGES[damage] in said, arguments
        assert ("swifttailor check" in said) >= ("--repair" in DAMAGES[damage])


@pytest.mark.parametrize("command", ["sew", "drape", "edit"])
def test_what_repair_mends_is_made_when_asked(command, tmp_path, capsys):
    path, out = damaged(stitched_to_nothing, tmp_path), tmp_path / "out"
    words = ["make it 5 cm longer"] if command == "edit" else []
    assert run([command, str(path), *words, "--repair", "--no-preview", "--out", str(out)]) in (0, 1)
    made = read_pattern_file(out / "pattern.json")
    assert not errors_of(check_pattern(made.pattern, reader_findings=made.findings))
    assert len(made.pattern.stitches) == len(draft("t-shirt").stitches) - 1


def test_one_refused_pattern_stops_no_other(tmp_path, capsys):
    draft("t-shirt").save(tmp_path / "sound.json")
    paths = [str(damaged(stitched_to_nothing, tmp_path)), str(tmp_path / "sound.json")]
    assert run(["sew", *paths, "--no-preview", "--out", str(tmp_path / "out")]) == 1
    assert [folder.name for folder in (tmp_path / "out").iterdir() if folder.is_dir()] == ["sound"]


def test_python_refuses_before_weights_are_opened(tmp_path):
    tailor = swifttailor.Tailor(garment_sewer=tmp_path / "none.onnx", pattern_maker=tmp_path / "none.zip")
    twice = draft("t-shirt")
    twice = swifttailor.Pattern(
        twice.panels, (*twice.stitches, swifttailor.Stitch(twice.stitches[0].first, twice.stitches[1].first))
    )
    for make in (lambda: tailor.sew(twice), lambda: tailor.edit(twice, "longer")):
        with pytest.raises(PatternError, match="edge-stitched-twice"):
            make()
    with pytest.raises(PatternError, match="there is no panel 'nobody'"):
        tailor.sew(damaged(stitched_to_nothing, tmp_path))
