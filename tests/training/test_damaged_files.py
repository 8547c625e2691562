"""Files of trainings and evaluations that are damaged, or somebody's, are refused in a sentence."""

from __future__ import annotations

import pytest

from swifttailor.errors import InputError
from swifttailor.evaluation.kept_settings import keep_settings
from swifttailor.training.run_record import RunRecord
from swifttailor.training.sewer_config import read_config

DAMAGED = {
    "empty": b"",
    "cut": b'{"steps": 1',
    "deep": b"[" * 200_000,
    "deep object": b'{"a":' * 100_000,
    "bytes": bytes(range(128, 256)),
    "list": b"[1]",
    "null": b"null",
}


@pytest.mark.parametrize("damage", DAMAGED)
def test_configurations_are_refused(damage, tmp_path):
    path = tmp_path / "config.json"
    path.write_bytes(DAMAGED[damage])
    with pytest.raises(InputError):
        read_config(str(path))


@pytest.mark.parametrize("damage", DAMAGED)
def test_runs_to_resume_are_refused(damage, tmp_path):
    (tmp_path / "config.json").write_bytes(DAMAGED[damage])
    with pytest.raises(InputError, match=str(tmp_path)):
        RunRecord(tmp_path).start({"steps": 1}, resume=True)
    assert (tmp_path / "config.json").read_bytes() == DAMAGED[damage]


@pytest.mark.parametrize("damage", DAMAGED)
def test_measurements_end_where_they_are_damaged(damage, tmp_path):
    (tmp_path / "metrics.jsonl").write_bytes(b'{"step": 1}\n' + DAMAGED[damage] + b"\n")
    record = RunRecord(tmp_path)
    assert record.lines() == [{"step": 1}]
    record.forget_after(1)
    assert (tmp_path / "metrics.jsonl").read_bytes() == b'{"step": 1}\n'


@pytest.mark.parametrize("damage", DAMAGED)
def test_settings_of_answers_are_refused(damage, tmp_path):
    (tmp_path / "settings.json").write_bytes(DAMAGED[damage])
    with pytest.raises(InputError, match="settings"):
        keep_settings(tmp_path / "settings.json", {"seed": 0}, "answers", [])
