"""What a card says of where weights come from."""

from __future__ import annotations

import hashlib

import pytest

from swifttailor.errors import InputError
from swifttailor.training import run_record
from swifttailor.training.run_record import command, file_checksums


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
