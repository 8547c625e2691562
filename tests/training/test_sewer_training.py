"""A small network learns, goes on exactly where it was interrupted, and leaves a full record."""

from __future__ import annotations

import json
import shutil
from dataclasses import replace

import numpy as np
import pytest

from swifttailor.data.index import read_index
from swifttailor.errors import InputError, MissingExtraError
from swifttailor.training.config_file import config_values
from swifttailor.training.extra import require_training_packages
from swifttailor.training.sewer_config import read_config

TINY = [
    "network.resolution=64",
    "network.hidden_size=32",
    "network.layers=4",
    "network.heads=2",
    "network.convolutions=[8, 8, 16, 16]",
    "batch_size=4",
    "learning_rate=0.003",
    "warmup_steps=3",
    "steps=12",
    "validate_every=6",
    "validation_garments=2",
    "log_every=2",
    "pictures=0",
    "ema=0.9",
    "losses.strain=0.1",
    "layouts=2",
]

OF_NORMS = ("running_mean", "running_var", "num_batches_tracked")
"""What norms count beside their weights."""


@pytest.fixture(scope="module")
def config():
    return read_config("small", TINY)


@pytest.fixture(scope="module")
def cache(tmp_path_factory):
    return tmp_path_factory.mktemp("cache")


@pytest.fixture(scope="module")
def run(config, data, cache, tmp_path_factory):
    """A finished training: its folder and its card."""
    from swifttailor.training.sewer_loop_torch import train

    out = tmp_path_factory.mktemp("runs") / "whole"
    return out, train(config, data, out, cache=cache, threads=1)


def measurements(folder):
    """metrics.jsonl without the seconds, which differ."""
    lines = [json.loads(line) for line in (folder / "metrics.jsonl").read_text().splitlines()]
    return [{k: v for k, v in line.items() if k != "seconds"} for line in lines]


@pytest.mark.needs_torch
def test_interrupted_and_resumed_equals_uninterrupted_bit_for_bit(run, config, data, cache, tmp_path):
    from swifttailor.training.sewer_loop_torch import train

    whole, _ = run
    train(config, data, tmp_path / "run", cache=cache, threads=1, stop_after=5)
    # What was measured after the last checkpoint is done again.
    with (tmp_path / "run/metrics.jsonl").open("a") as stream:
        stream.write('{"step": 6, "total": 1}\n{"step": 7, "to')
    train(config, data, tmp_path / "run", cache=cache, threads=1, resume=True)
    for name in ("weights.safetensors", "config.json"):
        assert (tmp_path / "run" / name).read_bytes() == (whole / name).read_bytes(), name
    expected = {line["step"]: line for line in measurements(whole) if "total" in line}
    found = {line["step"]: line for line in measurements(tmp_path / "run") if "total" in line}
    assert found == expected


@pytest.mark.needs_torch
def test_what_is_written_down_is_the_mean_of_the_steps_before(run, config, data, cache, tmp_path):
    from swifttailor.training.sewer_loop_torch import train

    train(replace(config, log_every=1), data, tmp_path / "run", cache=cache, threads=1)
    single = [line for line in measurements(tmp_path / "run") if "total" in line]
    for line in (line for line in measurements(run[0]) if "total" in line):
        pair = [s["total"] for s in single if s["step"] in (line["step"] - 1, line["step"])]
        assert len(pair) == 2 and line["total"] == pytest.approx(np.mean(pair), rel=1e-5)


@pytest.mark.needs_torch
def test_begins_with_the_weights_of_another_run(run, config, data, cache, tmp_path):
    from safetensors.numpy import load_file

    from swifttailor.training.sewer_loop_torch import train

    out, card = run
    started = replace(config, start=str(out / "weights.safetensors"), steps=1, learning_rate=1e-9)
    again = train(started, data, tmp_path / "run", cache=cache, threads=1)
    before, after = load_file(out / "weights.safetensors"), load_file(tmp_path / "run/weights.safetensors")
    weights = [k for k in before if not k.endswith(OF_NORMS)]  # these follow the garments, not the rate
    assert max(np.abs(before[k] - after[k]).max() for k in weights) < 1e-6
    assert again["validation"]["mean"] == pytest.approx(card["validation"]["mean"], abs=0.1)
    (tmp_path / "text").write_text("no weights")
    with pytest.raises(InputError, match="to start with cannot be used"):
        train(replace(config, start=str(tmp_path / "text")), data, tmp_path / "other", cache=cache)


@pytest.mark.needs_torch
def test_begins_with_a_model_file(run, config, data, cache, tmp_path):
    from swifttailor.garment_sewer.export_torch import export
    from swifttailor.training.sewer_loop_torch import train

    out, card = run
    model = export(out / "weights.safetensors", card, tmp_path / "model.onnx")
    started = replace(config, start=str(model), steps=1, learning_rate=1e-9)
    again = train(started, data, tmp_path / "run", cache=cache, threads=1)
    assert again["validation"]["mean"] == pytest.approx(card["validation"]["mean"], abs=0.1)


@pytest.mark.needs_torch
def test_learns(config, data, cache, tmp_path):
    from swifttailor.training.sewer_loop_torch import train

    longer = replace(config, steps=120, validate_every=60, mirror=0.0, repack=0.0)
    card = train(longer, data, tmp_path / "run", cache=cache, threads=1)
    # The rule of the data moves every vertex by 6.4 cm; an untrained network is that far off.
    assert card["validation"]["mean"] < 2.0


@pytest.mark.needs_torch
def test_record_says_what_was_trained_on_what(run, config, data):
    out, card = run
    assert card == json.loads((out / "card.json").read_text())
    assert card["config"] == config_values(config) == json.loads((out / "config.json").read_text())
    assert card["data"]["train"]["garments"] == 6
    assert card["data"]["validation"]["garments"] == 2
    assert card["data"]["train"]["shards_sha256"] != card["data"]["validation"]["shards_sha256"]
    assert card["training"]["steps"] == 12
    assert card["training"]["garments_seen"] == 48
    assert card["training"]["threads"] == 1
    assert set(card["validation"]["kinds"]) == {"upper", "skirt"}
    assert card["parameters"] > 10_000
    lines = measurements(out)
    assert [line["step"] for line in lines if "total" in line] == [2, 4, 6, 8, 10, 12]
    assert [line["step"] for line in lines if "validation" in line] == [6, 12]


@pytest.mark.needs_torch
def test_weights_are_the_moving_average(run):
    import torch
    from safetensors.numpy import load_file

    out, card = run
    weights = load_file(out / "weights.safetensors")
    state = torch.load(out / "checkpoint.pt", weights_only=True)
    assert set(weights) == set(state["network"])
    assert sum(v.size for k, v in weights.items() if not k.endswith(OF_NORMS)) == card["parameters"]
    for name, value in weights.items():
        assert np.array_equal(value, state["average"][name].numpy()), name
    assert any(not np.array_equal(v, state["network"][k].numpy()) for k, v in weights.items())


@pytest.mark.needs_torch
def test_a_second_training_in_the_folder_is_refused(run, config, data, cache, tmp_path):
    from swifttailor.training.sewer_loop_torch import train

    out, _ = run
    with pytest.raises(InputError, match="already"):
        train(config, data, out, cache=cache)
    with pytest.raises(InputError, match="seed: 0 before, 1 now"):
        train(replace(config, seed=1), data, out, cache=cache, resume=True)
    with pytest.raises(InputError, match="no training"):
        train(config, data, tmp_path, cache=cache, resume=True)


@pytest.mark.needs_torch
def test_a_damaged_checkpoint_is_refused(run, config, data, cache, tmp_path):
    import shutil

    from swifttailor.training.sewer_loop_torch import train

    shutil.copytree(run[0], tmp_path / "run")
    path = tmp_path / "run/checkpoint.pt"
    path.write_bytes(path.read_bytes()[:1000])
    with pytest.raises(InputError, match="is damaged"):
        train(config, data, tmp_path / "run", cache=cache, resume=True)


@pytest.mark.needs_torch
def test_time_ends_a_training(config, data, cache, tmp_path):
    from swifttailor.training.sewer_loop_torch import train

    longer = replace(config, steps=100_000)
    card = train(longer, data, tmp_path / "run", cache=cache, threads=1, max_minutes=0.04)
    assert 1 <= card["training"]["steps"] < 1000
    assert card["training"]["minutes"] < 0.5
    rates = [line["rate"] for line in measurements(tmp_path / "run") if "rate" in line]
    assert rates[-1] < 0.5 * max(longer.learning_rate * 0.9, max(rates))


@pytest.mark.needs_torch
def test_a_batch_is_what_the_pieces_are(config, data, cache):
    """The tensors of a batch against the images drawn one by one in numpy."""
    import torch

    from swifttailor.data.reader import SplitReader
    from swifttailor.garment_sewer.conditioning import conditioning_image
    from swifttailor.training.sewer_batch_torch import assemble, to_tensors
    from swifttailor.training.sewer_samples import SewerSamples

    samples = SewerSamples(SplitReader(data / "train"), cache, 64, "sewn", 2)
    chosen = [samples.get(0), samples.get(4, 1)]
    batch = assemble([to_tensors(s, torch.device("cpu")) for s in chosen], config.conditioning)
    truth = batch.truth
    for k, sample in enumerate(chosen):
        table = sample.table
        expected = conditioning_image(table, config.conditioning)
        assert np.allclose(batch.conditioning[k].numpy(), expected, atol=1e-5)

        def at(image, k=k, pixels=table.pixels):
            return image[k].reshape(*image.shape[1:-2], -1)[..., pixels].numpy()

        assert np.array_equal(at(truth.panel), table.panel)
        assert np.array_equal(at(truth.contour), table.contour)
        assert np.array_equal(at(truth.edge_distance), sample.edge_distance)
        assert np.array_equal(at(truth.ignores_arms), sample.ignores_arms[table.panel])
        assert np.array_equal(at(truth.target).T, sample.target)
        assert np.array_equal(at(batch.prior).T, table.prior)
        assert np.allclose(at(truth.local).T, table.local(), atol=1e-5)
        assert (truth.panel[k] >= 0).sum() == len(table.pixels) == truth.occupancy[k].sum()
        sewn = np.flatnonzero(table.partner >= 0)
        own = truth.pairs[(truth.pairs[:, 0] // 64**2) == k].numpy() - k * 64**2
        assert np.array_equal(own, np.stack([table.pixels[sewn], table.pixels[table.partner[sewn]]], axis=1))
    counts = [len(s.sides) for s in chosen]
    assert truth.sides.shape == (sum(counts), 2, 64)


@pytest.mark.needs_torch
def test_batches_depend_on_their_number_alone(config, data, cache):
    import torch

    from swifttailor.data.reader import SplitReader
    from swifttailor.training.sewer_batch_torch import TrainingBatches
    from swifttailor.training.sewer_samples import SewerSamples

    reader = SplitReader(data / "train")
    samples = SewerSamples(reader, cache, 64, "sewn", 2)

    def batches(**parts):
        return TrainingBatches(samples, reader, config, torch.device("cpu"), **parts)

    forward = batches()
    first, third = forward[0], forward[2]
    again = batches()
    assert torch.equal(again[2].conditioning, third.conditioning)
    assert torch.equal(again[0].conditioning, first.conditioning)
    assert not torch.equal(first.conditioning, third.conditioning)
    # Two processes share a batch between them.
    shares = [batches(part=k, parts=2)[0].truth.target for k in (0, 1)]
    assert torch.equal(torch.stack(shares, dim=1).flatten(0, 1), first.truth.target)


@pytest.mark.needs_torch
def test_a_part_of_the_garments_is_the_same_in_every_epoch(config, data, cache, monkeypatch):
    import torch

    from swifttailor.data.reader import SplitReader
    from swifttailor.training.sewer_batch_torch import TrainingBatches
    from swifttailor.training.sewer_samples import SewerSamples

    reader = SplitReader(data / "train")
    samples = SewerSamples(reader, cache, 64, "sewn", 2)
    plain = replace(config, mirror=0.0, repack=0.0, layouts=1, batch_size=1, training_garments=2)
    seen = []
    get = SewerSamples.get
    monkeypatch.setattr(SewerSamples, "get", lambda self, k, layout: seen.append(k) or get(self, k, layout))
    batches = TrainingBatches(samples, reader, plain, torch.device("cpu"))
    for step in range(8):
        batches[step]
    assert len(reader) > 2 == len(set(seen))
    assert all(set(seen[k : k + 2]) == set(seen) for k in range(0, 8, 2))


@pytest.mark.needs_torch
def test_pictures_are_drawn(run, config, data, cache, tmp_path):
    import torch
    from PIL import Image

    from swifttailor.data.reader import SplitReader
    from swifttailor.garment_sewer.network_torch import build_network
    from swifttailor.training.sewer_samples import SewerSamples
    from swifttailor.training.sewer_validation_torch import Validation

    reader = SplitReader(data / "validation")
    samples = SewerSamples(reader, cache, 64, "sewn")
    validation = Validation(samples, reader, replace(config, pictures=1), torch.device("cpu"))
    network = build_network(config.network, config.conditioning.count)
    validation.draw(network, tmp_path / "sheet.png")
    with Image.open(tmp_path / "sheet.png") as picture:
        assert picture.size == (1800, 540)
        assert np.asarray(picture).std() > 10


@pytest.mark.needs_torch
def test_in_bfloat16_it_learns_what_it_learns_in_float32(run, config, data, cache, tmp_path):
    from safetensors.torch import load_file

    from swifttailor.training.sewer_loop_torch import train

    lowered = replace(config, precision="bfloat16", pictures=1, validate_every=12)
    low = train(lowered, data, tmp_path / "low", cache=cache, threads=1)
    high = train(
        replace(config, precision="float32", validate_every=12),
        data,
        tmp_path / "high",
        cache=cache,
        threads=1,
    )
    assert low["training"]["precision"] == "bfloat16"
    assert low["validation"]["mean"] == pytest.approx(high["validation"]["mean"], rel=0.05)
    weights = load_file(tmp_path / "low" / "weights.safetensors")
    assert {str(v.dtype) for k, v in weights.items() if not k.endswith("batches_tracked")} == {
        "torch.float32"
    }
    assert (tmp_path / "low" / "validation-0000012.png").stat().st_size > 10_000


@pytest.mark.needs_torch
def test_a_data_set_without_validation_is_refused(config, data, tmp_path):
    from swifttailor.training.sewer_loop_torch import train

    with pytest.raises(InputError, match="no split 'validation'"):
        train(config, data / "train", tmp_path / "run")


def test_without_torch_the_extra_is_named(monkeypatch):
    import importlib.util

    monkeypatch.setattr(importlib.util, "find_spec", lambda name: None)
    with pytest.raises(MissingExtraError, match=r"swifttailor\[train\]"):
        require_training_packages("Training")


@pytest.mark.needs_torch
def test_garments_of_a_network_are_refused(config, data, tmp_path):
    from swifttailor.training.sewer_loop_torch import train

    copy = shutil.copytree(data, tmp_path / "data")
    index = read_index(copy / "validation")
    replace(index, settings={"engine": "network"}).save(copy / "validation")
    with pytest.raises(InputError, match="are those of a GarmentSewer, from which none can learn"):
        train(config, copy, tmp_path / "run")
