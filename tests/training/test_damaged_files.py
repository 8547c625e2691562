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


@pytest.mark.needs_torch
def test_checkpoints_are_refused_wherever_they_are_damaged(tmp_path):
    import torch

    from swifttailor.training.checkpoint_torch import read_checkpoint, write_checkpoint

    device = torch.device("cpu")
    state = {"step": 3, "weights": torch.arange(1000.0), "optimiser": {"mean": torch.ones(300)}}
    path = write_checkpoint(tmp_path, state)
    whole = path.read_bytes()
    assert torch.equal(read_checkpoint(tmp_path, device, state)["weights"], state["weights"])
    values = [whole.index(t.numpy().tobytes()) for t in (state["weights"], state["optimiser"]["mean"])]
    flipped = [whole[:k] + bytes([whole[k] ^ 1]) + whole[k + 1 :] for k in (values[0] + 2002, values[1] + 3)]
    for damaged in (*flipped, whole[: len(whole) // 2], whole[:-1], b"", b"{}", whole[1:]):
        path.write_bytes(damaged)
        with pytest.raises(InputError, match="is damaged") as refused:
            read_checkpoint(tmp_path, device, state)
        assert len(str(refused.value)) < 500
