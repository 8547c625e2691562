"""Weights half-way between two trainings."""

from __future__ import annotations

import hashlib
import json
import subprocess
import sys
from pathlib import Path

import numpy as np
from safetensors.numpy import load_file, save_file

SCRIPT = Path(__file__).resolve().parents[2] / "scripts" / "average_weights.py"


def run_of(folder: Path, value: float, steps: int, size: int = 3) -> Path:
    folder.mkdir()
    save_file(
        {"layer": np.full(size, value, np.float32), "steps": np.array(steps)}, folder / "weights.safetensors"
    )
    (folder / "card.json").write_text(json.dumps({"model": "PictureReader", "steps": steps}))
    return folder


def averaged(*arguments: object) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, str(SCRIPT), *map(str, arguments)]
    return subprocess.run(command, capture_output=True, text=True, timeout=120)


def test_weights_are_averaged_and_counts_are_those_of_the_first(tmp_path):
    ours, others = run_of(tmp_path / "ours", 3.0, 7), run_of(tmp_path / "others", 1.0, 2)
    assert averaged(ours, others, "--share", 0.25, "--out", tmp_path / "both").returncode == 0
    found = load_file(tmp_path / "both" / "weights.safetensors")
    assert found["layer"].dtype == np.float32 and np.allclose(found["layer"], 1.5) and found["steps"] == 7
    card = json.loads((tmp_path / "both" / "card.json").read_text())
    before = hashlib.sha256((others / "weights.safetensors").read_bytes()).hexdigest()
    assert card == {
        "model": "PictureReader",
        "steps": 7,
        "averaged": {"share": 0.25, "with": before},
    }


def test_networks_of_other_shapes_are_refused(tmp_path):
    ours, others = run_of(tmp_path / "ours", 3.0, 7), run_of(tmp_path / "others", 1.0, 2, size=4)
    refused = averaged(ours, others, "--out", tmp_path / "both")
    assert refused.returncode == 2 and "different shapes" in refused.stderr
    assert not (tmp_path / "both").exists()
