"""Several processes train one network: each with a copy of it, or each with a part."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from safetensors.numpy import load_file

from swifttailor.errors import InputError
from swifttailor.pattern import to_specification
from swifttailor.pattern.drafts import draft

pytestmark = pytest.mark.needs_torch

TINY = [
    "network.hidden_size=32",
    "network.layers=2",
    "network.heads=2",
    "network.key_value_heads=1",
    "network.intermediate_size=64",
    "network.vision_hidden_size=32",
    "network.vision_layers=1",
    "network.vision_heads=2",
    "network.image_size=64",
    "batch_size=4",
    "reads=4",
    "optimizer=adamw",
    "learning_rate=0.003",
    "warmup_steps=1",
    "steps=6",
    "validate_every=3",
    "validation_samples=2",
    "log_every=3",
    "ema=0.9",
    "recuts=0",
]
UNPLANNED = "network.planning=false"
"""A plan is foreseen with the whole network."""
OF_NORMS = ("running_mean", "running_var", "num_batches_tracked")
"""What norms count beside their weights."""
FLOAT32, BFLOAT16, SHARD = "precision=float32", "precision=bfloat16", "shard=true"
RUNS: dict[str, tuple[int, list[str]]] = {
    "copies": (0, [FLOAT32, UNPLANNED]),
    "parts": (0, [FLOAT32, SHARD, UNPLANNED]),
    "resumed": (3, [FLOAT32, SHARD, UNPLANNED]),
    "planned": (0, [FLOAT32]),
    "low": (0, [BFLOAT16, SHARD, UNPLANNED]),
    "muon": (0, [FLOAT32, SHARD, UNPLANNED, "optimizer=muon"]),
}
"""Of each the step after which it is interrupted and resumed, 0 for none, and values of the configuration."""
SCRIPT = """
import json, os, sys
from pathlib import Path
from swifttailor.errors import InputError
from swifttailor.training.maker_config import read_config
from swifttailor.training.maker_loop_torch import train

folder, runs = Path(sys.argv[1]), json.loads(sys.argv[2])
for out, (stop, values) in runs.items():
    try:
        for resume in (False, True) if stop else (False,):
            train(read_config("small", values), [folder / "train.jsonl"], folder / out, resume=resume,
                  validation=[folder / "other.jsonl"], cache=folder / "cache", stop_after=stop or None,
                  threads=1)
    except InputError as error:
        (folder / f"{out}-{os.environ['RANK']}.txt").write_text(str(error))
"""


@pytest.fixture(scope="module")
def folder(tmp_path_factory) -> Path:
    folder = tmp_path_factory.mktemp("several")
    for name, lengths in (("train", (45.0, 53.0, 61.0)), ("other", (50.0,))):
        patterns = {f"{name}{k}": draft("fitted-skirt", length=n) for k, n in enumerate(lengths)}
        lines = [json.dumps({"id": k, "pattern": to_specification(p)}) for k, p in patterns.items()]
        (folder / f"{name}.jsonl").write_text("\n".join(lines) + "\n")
    (folder / "script.py").write_text(SCRIPT)
    return folder


@pytest.fixture(scope="module")
def trained(folder) -> Callable[[str], dict[str, np.ndarray]]:
    """Weights of each of `RUNS`; all are run by the same two processes, which take long to start."""
    runs = {out: (stop, [*TINY, *values]) for out, (stop, values) in RUNS.items()}
    command = [sys.executable, "-m", "torch.distributed.run", "--standalone", "--nproc_per_node", "2"]
    command += [str(folder / "script.py"), str(folder), json.dumps(runs)]
    environment = os.environ | {"OMP_NUM_THREADS": "1", "CUDA_VISIBLE_DEVICES": ""}
    done = subprocess.run(command, capture_output=True, text=True, timeout=900, env=environment)
    assert done.returncode == 0, done.stderr[-3000:]
    return lambda out: load_file(folder / out / "weights.safetensors")


def apart(one: dict[str, np.ndarray], other: dict[str, np.ndarray]) -> float:
    assert one.keys() == other.keys()
    assert {k: v.shape for k, v in one.items()} == {k: v.shape for k, v in other.items()}
    return max(float(np.abs(one[k] - other[k]).max()) for k in one)


def test_in_parts_or_in_copies_the_same_is_learnt_and_gone_on_with(folder, trained):
    copies, parts = trained("copies"), trained("parts")
    assert apart(copies, parts) < 1e-4
    assert apart(parts, trained("resumed")) < 1e-6
    lines = [json.loads(line) for line in (folder / "resumed/metrics.jsonl").read_text().splitlines()]
    assert [line["step"] for line in lines if "validation" in line] == [3, 6]
    card = json.loads((folder / "parts/card.json").read_text())
    assert card["training"]["processes"] == 2
    learnt = {k: v for k, v in copies.items() if not k.endswith(OF_NORMS)}
    assert card["parameters"] == sum(v.size for v in learnt.values())


def test_copies_are_told_what_they_foresee(trained):
    planned = trained("planned")
    assert np.abs(planned["planned_in.weight"]).max() > 1e-3  # it began at 0


def test_parts_compute_in_bfloat16_and_stay_float32(trained):
    parts = trained("low")
    assert {v.dtype for k, v in parts.items() if not k.endswith(OF_NORMS)} == {np.dtype(np.float32)}
    assert 1e-6 < apart(parts, trained("parts")) < 0.1


def test_what_needs_whole_matrices_is_not_split(folder, trained):
    for rank in range(2):
        assert "optimizer=muon needs whole matrices" in (folder / f"muon-{rank}.txt").read_text()
    assert not (folder / "muon/weights.safetensors").exists()


def test_what_needs_the_whole_network_is_not_split(folder):
    from swifttailor.training.maker_config import read_config
    from swifttailor.training.maker_loop_torch import train

    for value in ("network.planning=true", "compiled=true"):
        values = [*TINY, "shard=true", *([] if "planning" in value else [UNPLANNED]), value]
        with pytest.raises(InputError, match=f"{value} cannot go with shard=true"):
            train(read_config("small", values), [folder / "train.jsonl"], folder / "no")


def test_one_process_has_nothing_to_split(folder):
    from swifttailor.training.maker_config import read_config
    from swifttailor.training.maker_loop_torch import train

    with pytest.raises(InputError, match="there is one"):
        train(
            read_config("small", [*TINY, UNPLANNED, "shard=true"]),
            [folder / "train.jsonl"],
            folder / "alone",
            validation=[folder / "other.jsonl"],
            cache=folder / "cache",
        )
