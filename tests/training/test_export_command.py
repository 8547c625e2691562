"""``swifttailor train export`` and files that are there already; other tests export networks."""

from __future__ import annotations

import json

import pytest

from swifttailor.cli import train_export
from swifttailor.cli.main import run
from swifttailor.training import extra


@pytest.fixture
def trained(tmp_path, monkeypatch):
    """The folder of a training, whose export takes no network."""
    monkeypatch.setattr(extra, "require_training_packages", lambda what: None)
    monkeypatch.setattr(train_export.TrainExport, "_export", lambda self, model, out: _written(out))
    folder = tmp_path / "run"
    folder.mkdir()
    (folder / "card.json").write_text(json.dumps({"model": "GarmentSewer"}))
    return folder


def _written(out):
    out.write_bytes(b"a network")
    return "exactly torch's"


@pytest.mark.parametrize("name", ["sewer.onnx", "sewer.json"])
def test_files_of_others_stay(name, trained, tmp_path, capsys):
    out = tmp_path / "made" / "sewer.onnx"
    out.parent.mkdir()
    (out.parent / name).write_text("my own work")
    assert run(["train", "export", str(trained), "--out", str(out)]) == 2
    assert f"'{out.parent / name}' would be replaced" in capsys.readouterr().err
    assert [p.name for p in out.parent.iterdir()] == [name]
    assert (out.parent / name).read_text() == "my own work"
    assert run(["train", "export", str(trained), "--out", str(out), "--overwrite"]) == 0
    assert out.read_bytes() == b"a network"
    assert json.loads(out.with_suffix(".json").read_text())["file"]["bytes"] == 9
