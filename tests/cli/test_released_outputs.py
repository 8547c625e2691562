"""``swifttailor convert FOLDER OUT.jsonl.gz``."""

from __future__ import annotations

import gzip
import json
import shutil

import pytest

from swifttailor.cli.main import run
from swifttailor.pattern import to_specification
from swifttailor.pattern.drafts import draft
from swifttailor.pattern.pattern_list import read_patterns


@pytest.fixture
def folder(tmp_path):
    """Two of Design2GarmentCode's answers, and one that fitted no program."""
    for name in ("circle-skirt", "t-shirt", "unfit"):
        place = tmp_path / "run" / name
        place.mkdir(parents=True)
        (place / "caption.json").write_text("[]")
        (place / "gpt_respond.txt").write_text("A garment.")
        if name != "unfit":
            content = to_specification(draft(name))
            content["pattern"]["stitches"].append([{"panel": "none", "edge": 0}] * 2)
            (place / f"{name}.json").write_text(json.dumps(content))
    return tmp_path / "run"


@pytest.mark.parametrize("ending", ["jsonl", "jsonl.gz"])
def test_a_folder_becomes_a_list_that_other_commands_read(folder, tmp_path, ending, capsys):
    out = tmp_path / f"list.{ending}"
    assert run(["convert", str(folder), str(out)]) == 1  # one cannot be sewn
    said = capsys.readouterr()
    assert "unfit: Design2GarmentCode wrote no pattern" in said.err
    assert "2 patterns" in said.out and "dangling-stitch in 2" in said.out and "1 cannot be sewn" in said.out
    entries = list(read_patterns(out))
    assert [e.id for e in entries] == ["circle-skirt", "t-shirt"] and not any(e.error for e in entries)
    for entry in entries:
        reading = entry.read()
        assert reading.findings == () and reading.pattern.canonical() == draft(entry.id).canonical()
    text = gzip.decompress(out.read_bytes()) if ending == "jsonl.gz" else out.read_bytes()
    first = json.loads(text.splitlines()[0])
    assert (
        first["layout"] == "design2garmentcode" and first["input"] == "circle-skirt" and first["error"] == ""
    )
    assert [change["code"] for change in first["mended"]] == ["dangling-stitch"]


def test_the_same_folder_gives_the_same_file_and_nothing_is_replaced(folder, tmp_path, capsys):
    shutil.rmtree(folder / "unfit")
    one, two = tmp_path / "one.jsonl.gz", tmp_path / "two.jsonl.gz"
    assert run(["convert", str(folder), str(one)]) == run(["convert", str(folder), str(two)]) == 0
    assert one.read_bytes() == two.read_bytes()
    one.write_text("mine")
    assert run(["convert", str(folder), str(one)]) == 2
    assert one.read_text() == "mine" and "one.jsonl.gz" in capsys.readouterr().err
    assert run(["convert", str(folder), str(one), "--overwrite"]) == 0
    assert one.read_bytes() == two.read_bytes()


def test_what_is_refused(folder, tmp_path, capsys):
    out = tmp_path / "out.jsonl"
    for arguments, message in (
        ([str(folder), str(out), "--layout", "gpt"], "There is no layout 'gpt'"),
        ([str(folder), str(out), "--layout", "aipparel"], "holds no outputs of AIpparel"),
        ([str(folder), str(tmp_path / "x.svg"), "--layout", "aipparel"], "--layout has no use in 'x.svg'"),
        ([str(tmp_path / "none"), str(out)], "There is no folder"),
        ([str(folder), str(out), "--allowance", "1"], "--allowance has no use in 'out.jsonl'"),
    ):
        assert run(["convert", *arguments]) == 2
        assert message in capsys.readouterr().err
    assert not out.exists()
