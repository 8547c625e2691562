"""What a card says of where weights come from."""

from __future__ import annotations

import hashlib

import pytest

from swifttailor.errors import InputError
from swifttailor.training import run_record
from swifttailor.training.run_record import RunRecord, command, file_checksums


def test_files_are_named_by_their_checksums(tmp_path):
    (tmp_path / "train.jsonl").write_text("one")
    (tmp_path / "more").mkdir()
    (tmp_path / "more/train.jsonl").write_text("other")
    (tmp_path / "folder").mkdir()
    (tmp_path / "folder/a.json").write_text("{}")
    sources = [tmp_path / "train.jsonl", tmp_path / "more/train.jsonl", tmp_path / "folder"]
    found = file_checksums(sources)
    assert found["train.jsonl"] == hashlib.sha256(b"one").hexdigest()
    assert found[str(tmp_path / "more/train.jsonl")] == hashlib.sha256(b"other").hexdigest()
    (tmp_path / "folder/a.json").rename(tmp_path / "folder/b.json")
    again = file_checksums(sources)
    assert again["folder"] != found["folder"] and len(again) == 3
    with pytest.raises(InputError, match="Cannot read"):
        file_checksums([tmp_path / "none"])


@pytest.mark.parametrize("program", ["/usr/bin/swifttailor", "/src/swifttailor/__main__.py"])
def test_the_command_is_what_makes_it_again(program, monkeypatch):
    arguments = ["train", "wish-reader", "--resume", "--out", "my run"]
    monkeypatch.setattr(run_record.sys, "argv", [program, *arguments])
    assert command() == "swifttailor train wish-reader --out 'my run'"
    monkeypatch.setattr(run_record.sys, "argv", ["pytest", "--resume"])
    assert command() == ""


@pytest.mark.parametrize(
    "name",
    ["config.json", "metrics.jsonl", "card.json", "weights.safetensors", "checkpoint.pt", "validation-1.png"],
)
def test_a_training_replaces_nobody_s_files(name, tmp_path):
    (tmp_path / name).write_text("mine")
    with pytest.raises(InputError, match=r"would be replaced|There is a training"):
        RunRecord(tmp_path).start({}, resume=False)
    assert (tmp_path / name).read_text() == "mine" and [p.name for p in tmp_path.iterdir()] == [name]


def test_one_training_at_a_time(tmp_path):
    first = RunRecord(tmp_path / "run")
    first.start({"steps": 1}, resume=False)
    for resume in (False, True):
        with pytest.raises(InputError, match="Another training is at work"):
            RunRecord(tmp_path / "run").start({"steps": 1}, resume=resume)
    first.end()
    RunRecord(tmp_path / "run").start({"steps": 1}, resume=True)
