"""Design parameters as the ranges and choices that a network answers with."""

from __future__ import annotations

import importlib.util
import sys
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

pytestmark = pytest.mark.needs_torch
SCRIPT = Path(__file__).parents[2] / "scripts" / "design_parameters_torch.py"


@pytest.fixture(scope="module")
def script():
    spec = importlib.util.spec_from_file_location("design_parameters_torch", SCRIPT)
    assert spec is not None and spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    sys.modules[spec.name] = module
    spec.loader.exec_module(module)
    return module


def designs_of(seed, count):
    rng = np.random.default_rng(seed)
    lengths = np.where(rng.random(count) < 0.4, 0.2, rng.uniform(0.2, 1.0, count))
    necks = rng.choice(["v", "crew"], count)
    return [
        {"length": float(length), "neck": str(neck), "hood": bool(k % 2), "fixed": 1.0}
        for k, (length, neck) in enumerate(zip(lengths, necks, strict=True))
    ]


@given(st.integers(0, 1000), st.integers(80, 400))
@settings(max_examples=20, deadline=None)
def test_every_value_has_a_range_and_no_range_is_empty(script, seed, count):
    designs = designs_of(seed, count)
    found = {p.path: p for p in script.parameters_of(designs)}
    assert set(found) == {"length", "neck", "hood"}, "what never varies is not learnt"
    length = found["length"]
    numbers = [length.number_of(d["length"]) for d in designs]
    assert set(numbers) == set(range(len(length.values))), "each range holds some of the values"
    assert length.values == sorted(length.values)
    assert {found["neck"].values[found["neck"].number_of(d["neck"])] for d in designs} == {"v", "crew"}
    assert found["hood"].values[found["hood"].number_of(True)] is True


def test_the_first_candidate_is_the_likeliest_and_all_can_be_built(script):
    import torch

    parameters = script.parameters_of(designs_of(0, 200))
    wanted = {p.path: len(p.values) - 1 for p in parameters}
    logits = torch.cat([torch.eye(len(p.values))[wanted[p.path]] * 9.0 for p in parameters])
    candidates = script.candidates(logits, parameters, np.random.default_rng(0))
    assert len(candidates) == script.CANDIDATES
    assert candidates[0] == {p.path: p.values[wanted[p.path]] for p in parameters}
    assert all(c[p.path] in p.values for c in candidates for p in parameters)
