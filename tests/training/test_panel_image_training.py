"""A network of one image per panel is trained and used like the other."""

from __future__ import annotations

import json
from dataclasses import replace

import numpy as np
import pytest

from swifttailor.body import Body
from swifttailor.data.reader import SplitReader
from swifttailor.errors import InputError
from swifttailor.garment_sewer.pixels.body_distance import BodyDistance
from swifttailor.garment_sewer.pixels.pixel_table import tabulate
from swifttailor.garment_sewer.sewer import GarmentSewer
from swifttailor.ggi.outline_decode import outline_sampler
from swifttailor.ggi.panel_cells import lay_out_in_cells
from swifttailor.training.sewer_config import read_config
from swifttailor.training.sewer_samples import SewerSamples, choose_layout

TINY = [
    "network.resolution=64",
    "network.hidden_size=32",
    "network.heads=2",
    "network.convolutions=[8, 8, 16, 16]",
    "conditioning.prior=sewn",
    "batch_size=4",
    "learning_rate=0.003",
    "warmup_steps=3",
    "steps=40",
    "validate_every=40",
    "validation_garments=2",
    "pictures=0",
    "ema=0.9",
]


@pytest.fixture(scope="module")
def cache(tmp_path_factory):
    return tmp_path_factory.mktemp("cache")


@pytest.fixture(scope="module")
def run(data, cache, tmp_path_factory):
    from swifttailor.training.sewer_loop_torch import train

    out = tmp_path_factory.mktemp("runs") / "cells"
    return out, train(read_config("per-panel", TINY), data, out, cache=cache, threads=1)


def test_samples_are_what_is_computed_afresh_and_kept_apart_from_packed_ones(data, tmp_path):
    reader = SplitReader(data / "train")
    samples = SewerSamples(reader, tmp_path, 64, "sewn", kind="per_panel")
    packed = SewerSamples(reader, tmp_path, 64, "sewn")
    layout = choose_layout(reader[0], 64, 0, "per_panel")
    assert np.array_equal(layout.stretch, lay_out_in_cells(reader[0].pattern, 64).stretch)
    table, fresh = samples.get(0).table, tabulate(layout, "sewn", BodyDistance.of(Body.default()))
    assert np.array_equal(table.pixels, fresh.pixels)
    assert not np.array_equal(packed.get(0).table.pixels, fresh.pixels)
    for name, tolerance in (("panel_cm", 1e-6), ("panel_log_cm", 1e-6), ("prior", 0.01)):
        assert np.abs(getattr(table, name) - getattr(fresh, name)).max() <= tolerance, name
    # What the cache holds of a pixel's place is rounded to a 255th of a pixel.
    assert (np.abs(table.local() - fresh.local()) <= 0.003 * fresh.panel_cm[fresh.panel] + 1e-4).all()


@pytest.mark.needs_torch
def test_it_learns_and_its_card_says_the_layout(run):
    out, card = run
    assert card["config"]["conditioning"]["layout"] == "per_panel"
    assert "aspect" in card["config"]["conditioning"]["channels"]
    assert card == json.loads((out / "card.json").read_text())
    # The rule of the data moves every vertex by 6.4 cm; an untrained network is that far off.
    assert card["validation"]["mean"] < 4.0


@pytest.mark.needs_torch
def test_it_sews_as_the_training_measured(run, data):
    from swifttailor.evaluation.garment_error import measure_error
    from swifttailor.garment_sewer.export_torch import torch_model

    out, card = run
    model = torch_model(out / "weights.safetensors", card)
    sewer = GarmentSewer(model, BodyDistance.of(Body.default()))
    assert sewer.model.conditioning.layout == "per_panel"
    reader = SplitReader(data / "validation")
    errors = []
    for k in range(len(reader)):
        sample = reader[k]
        prepared = sewer.prepare(sample.pattern, edge_length=6.0)
        assert prepared.layout.stretch is not None
        (values,) = sewer.predict([prepared])
        assert np.isfinite(sewer.decode(prepared, values).vertices).all()
        flat = outline_sampler(prepared.layout, sample.mesh).weights @ values
        errors.append(measure_error(sample.mesh, flat, sample.vertices, sewer.body).mean)
    assert np.mean(errors) == pytest.approx(card["validation"]["mean"], abs=0.1)


@pytest.mark.needs_torch
def test_another_layout_does_not_resume_it_nor_start_from_it(run, data, cache, tmp_path):
    from swifttailor.training.sewer_loop_torch import train

    out, _ = run
    packed = read_config("small", TINY)
    with pytest.raises(InputError, match="layout: 'per_panel' before, 'packed' now"):
        train(packed, data, out, cache=cache, resume=True)
    started = replace(packed, start=str(out / "weights.safetensors"), steps=1)
    with pytest.raises(InputError, match="to start with cannot be used"):
        train(started, data, tmp_path / "other", cache=cache)
