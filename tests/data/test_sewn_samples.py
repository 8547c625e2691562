"""Data sets whose garments are GarmentSewer's."""

from __future__ import annotations

import json

import numpy as np
import pytest

from swifttailor.cli.main import run
from swifttailor.data.index import read_index
from swifttailor.data.reader import SplitReader
from swifttailor.garment_sewer.relaxing import relaxed
from swifttailor.garment_sewer.sewer import SHIPPED, GarmentSewer
from swifttailor.pattern import read_specification
from swifttailor.pattern.drafts import draft
from swifttailor.pattern.garmentcode_writer import to_specification

pytestmark = pytest.mark.skipif(not SHIPPED.is_file(), reason="the package has no weights of a GarmentSewer")


@pytest.fixture
def patterns(tmp_path):
    path = tmp_path / "train.jsonl"
    broken = to_specification(draft("tank-top"))
    broken["pattern"]["stitches"] *= 2
    given = {"skirt": to_specification(draft("fitted-skirt")), "broken": broken}
    path.write_text("\n".join(json.dumps({"id": id, "pattern": p}) for id, p in given.items()))
    return path


def test_garments_are_those_of_the_network(patterns, tmp_path, capsys):
    out = tmp_path / "out"
    command = ["data", "build", "--patterns", str(patterns), "--out", str(out), "--edge-length", "4"]
    assert run([*command, "--engine", "network", "--workers", "1"]) == 0
    assert "2 patterns: 1 accepted, 1 rejected, 0 failed" in capsys.readouterr().out
    index = read_index(out / "train")
    assert index.settings["engine"] == "network" and len(index.settings["weights"]) == 16
    assert [r.id for r in index.shards[0].rejected] == ["broken"]
    (sample,) = SplitReader(out / "train")
    pattern = read_specification(to_specification(draft("fitted-skirt"))).pattern
    sewn = relaxed(GarmentSewer.load().sew(pattern, edge_length=4.0))
    assert sample.mesh.vertex_count == sewn.mesh.vertex_count
    assert np.abs(sample.garment.vertices - sewn.vertices).max() < 0.02  # stored in 16 bits
    assert run(["data", "verify", str(out), "--workers", "1"]) == 0
    capsys.readouterr()
    # Drapes do not go into the same split.
    assert run([*command, "--workers", "1"]) == 2
    assert "engine was 'network', now 'xpbd'" in capsys.readouterr().err


def test_weights_without_the_engine_are_refused(patterns, tmp_path, capsys):
    command = ["data", "build", "--patterns", str(patterns), "--out", str(tmp_path / "out")]
    assert run([*command, "--sewer-weights", "x.onnx"]) == 2
    assert "--sewer-weights goes with --engine network" in capsys.readouterr().err
    assert run([*command, "--engine", "network", "--sewer-weights", str(tmp_path / "x.onnx")]) == 2
    assert "x.onnx" in capsys.readouterr().err
    assert not (tmp_path / "out").exists()
