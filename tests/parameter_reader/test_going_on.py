"""A parameter reader that goes on from a model file."""

from __future__ import annotations

import json
import runpy
from pathlib import Path

import numpy as np
import pytest

from swifttailor.describing import Claim
from swifttailor.parameter_reader import ParameterReader
from swifttailor.parameter_reader.reader import SHIPPED
from swifttailor.pattern_library import Sought

pytestmark = pytest.mark.needs_torch
SCRIPT = Path(__file__).parents[2] / "scripts/train_parameter_reader_torch.py"


@pytest.mark.skipif(not SHIPPED.exists(), reason="the package has no parameter reader")
@pytest.mark.parametrize(("rate", "stays"), [("0", True), ("0.01", False)])
def test_it_begins_with_the_answers_of_the_file(rate, stays, tmp_path, monkeypatch):
    out = tmp_path / "reader.onnx"
    options = ["--draw", "13", "--steps", "2", "--start", str(SHIPPED), "--learning-rate", rate]
    monkeypatch.setattr("sys.argv", [str(SCRIPT), *options, "--out", str(out)])
    runpy.run_path(str(SCRIPT), run_name="__main__")
    before, after = ParameterReader.load(), ParameterReader.load(out)
    assert after.parameters == before.parameters
    sought = Sought.of_claims([Claim("kind", "skirt"), Claim("skirt_hem", "midi")])
    off = max(
        float(np.abs(one - other).max())
        for one, other in zip(before.shares(sought), after.shares(sought), strict=True)
    )
    assert (off < 1e-3) == stays
    card = json.loads(out.with_suffix(".json").read_text())
    assert card["config"]["start"] == SHIPPED.name and SHIPPED.name in card["data"]["files"]


def test_designs_with_choices_that_the_file_does_not_know_are_left_out():
    known_to = runpy.run_path(str(SCRIPT))["known_to"]
    parameters = ParameterReader.load().parameters
    choice = next(one for one in parameters if one.name == "meta.upper")
    design = {one.name: one.values[0] for one in parameters if not one.is_number}
    design |= {one.name: one.edges[0] for one in parameters if one.is_number}
    assert known_to(parameters, design | {"meta.upper": choice.values[-1]})
    assert not known_to(parameters, design | {"meta.upper": "Poncho"})
