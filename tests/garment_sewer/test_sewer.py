"""From a pattern to a garment by a model file, without torch."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from swifttailor.errors import InputError
from swifttailor.garment.garment import Garment
from swifttailor.garment_sewer.model_file import load_model
from swifttailor.garment_sewer.pixels.sewn_prior import vertices_ignoring_arms
from swifttailor.garment_sewer.sewer import GarmentSewer
from swifttailor.panel_mesh.topology import topology
from swifttailor.pattern import Pattern
from swifttailor.pattern.drafts import draft

TINY = Path(__file__).with_name("tiny_sewer.onnx")
"""An untrained network (scripts/make_tiny_sewer_torch.py): it predicts its prior."""


@pytest.fixture(scope="module")
def sewer() -> GarmentSewer:
    return GarmentSewer.load(TINY)


@pytest.mark.parametrize("name", ["t-shirt", "hoodie", "shirt-dress", "jumpsuit", "circle-skirt"])
def test_every_draft_becomes_one_closed_garment_outside_the_body(sewer, name):
    garment = sewer.sew(draft(name), edge_length=3.0)
    counts = topology(garment.faces, len(garment.vertices))
    assert counts.components == 1
    assert counts.nonmanifold_edges == counts.inconsistent_edges == 0
    distance, _ = sewer.body.sample(garment.vertices, vertices_ignoring_arms(garment.mesh))
    assert (distance < 0).mean() <= 0.005
    assert garment.report["sewing"]["inside_body"] == pytest.approx((distance < 0).mean())
    assert set(garment.report["seconds"]) == {"drawing", "network", "decoding"}


def test_a_garment_does_not_depend_on_order_or_company(sewer):
    pattern = draft("t-shirt")
    shuffled = Pattern(pattern.panels[::-1], pattern.stitches[::-1], pattern.name)
    alone = sewer.sew(pattern)
    assert np.array_equal(sewer.sew(shuffled).vertices, alone.vertices)
    prepared = [sewer.prepare(draft("trousers")), sewer.prepare(pattern)]
    together = sewer.decode(prepared[1], sewer.predict(prepared)[1])
    assert np.abs(together.vertices - alone.vertices).max() < 1e-3


def test_can_be_saved_and_loaded(sewer, tmp_path):
    garment = sewer.sew(draft("fitted-skirt"))
    garment.save(tmp_path, preview=False)
    assert np.abs(Garment.load(tmp_path).vertices - garment.vertices).max() < 1e-3


def test_other_resolutions_than_it_was_trained_at(sewer):
    assert sewer.sew(draft("t-shirt"), resolution=128).report["resolution"] == 128
    with pytest.raises(InputError, match="multiple of 8"):
        sewer.sew(draft("t-shirt"), resolution=100)


def test_model_says_how_it_wants_to_be_asked():
    model = load_model(TINY)
    assert model.conditioning.channels == ("occupancy", "prior", "body_distance")
    assert (model.resolution, model.patch_size) == (64, 8)
    chance = np.random.default_rng(0)
    given = [chance.normal(size=(3, n, 64, 64)).astype(np.float32) for n in (5, 1, 3)]
    assert np.allclose(model.network(*given), given[2])


def test_model_file_holds_no_paths():
    assert b"site-packages" not in TINY.read_bytes()
    assert b".py" not in TINY.read_bytes()


@pytest.mark.parametrize("keep", [0, 10, 1000, 0.5, 0.99])
def test_truncated_files_are_refused(tmp_path, keep):
    data = TINY.read_bytes()
    path = tmp_path / "model.onnx"
    path.write_bytes(data[: keep if isinstance(keep, int) else int(len(data) * keep)])
    with pytest.raises(InputError, match=r"model\.onnx"):
        load_model(path)


def test_foreign_and_missing_files_are_refused(tmp_path):
    text = tmp_path / "pattern.json"
    text.write_text(json.dumps({"pattern": {}}))
    with pytest.raises(InputError, match="not a network"):
        load_model(text)
    with pytest.raises(InputError, match="Cannot read"):
        load_model(tmp_path / "nothing.onnx")
    other = tmp_path / "other.onnx"
    other.write_bytes(
        TINY.read_bytes().replace(b"swifttailor garment-sewer 1", b"swifttailor garment-sewer 9")
    )
    with pytest.raises(InputError, match="garment-sewer 9"):
        load_model(other)


def test_without_weights_it_says_how_to_get_them(monkeypatch, tmp_path):
    from swifttailor.garment_sewer import sewer

    monkeypatch.setattr(sewer, "SHIPPED", tmp_path / "none.onnx")
    with pytest.raises(InputError, match="without weights"):
        GarmentSewer.load()


def test_a_network_that_predicts_no_numbers_is_refused(sewer):
    prepared = sewer.prepare(draft("fitted-skirt"))
    with pytest.raises(InputError, match="not finite"):
        sewer.decode(prepared, np.full((len(prepared.table.pixels), 3), np.nan))


@pytest.mark.needs_torch
@pytest.mark.parametrize("kind", ["TINY", "HYBRID"])
def test_both_runtimes_agree(kind, tmp_path):
    """A network with random weights, so that every layer counts."""
    import test_network
    import torch
    from safetensors.torch import save_file

    from swifttailor.garment_sewer.export_torch import compare, export, torch_model
    from swifttailor.garment_sewer.network_torch import build_network
    from swifttailor.training.sewer_config import SewerConfig, config_values

    config = SewerConfig(network=getattr(test_network, kind))
    torch.manual_seed(0)
    network = build_network(config.network, config.conditioning.count)
    torch.nn.init.normal_(network.last.weight, std=0.02)
    weights = tmp_path / "weights.safetensors"
    save_file({k: v.contiguous() for k, v in network.state_dict().items()}, weights)
    card = {"config": config_values(config)}
    exported = load_model(export(weights, card, tmp_path / "model.onnx"))
    assert compare(exported, torch_model(weights, card)).apart_cm < 1e-2
    assert exported.card == card
    small = load_model(export(weights, card, tmp_path / "half.onnx", half=True))
    assert compare(small, torch_model(weights, card, half=True)).apart_cm < 1e-2
    assert 0 < compare(small, exported).apart_cm  # rounded indeed
    sizes = [(tmp_path / name).stat().st_size for name in ("model.onnx", "half.onnx")]
    assert sizes[1] < 0.75 * sizes[0]
    random = np.random.default_rng(2)
    eight_bit = load_model(export(weights, card, tmp_path / "int8.onnx", half=True, int8=True))
    rounded = compare(eight_bit, small)
    assert 0 < rounded.apart_cm < 0.1 * rounded.reach_cm
    assert (tmp_path / "int8.onnx").stat().st_size < sizes[1]
    given = [random.normal(size=(3, n, 64, 64)).astype(np.float32) for n in (config.conditioning.count, 1, 3)]
    given[0][1] *= 100.0  # a garment in the batch must not change what another is rounded to
    alone = eight_bit.network(*(images[:1] for images in given))
    np.testing.assert_array_equal(eight_bit.network(*given)[:1], alone)
    wider = [
        np.random.default_rng(1).normal(size=(1, n, 96, 128)).astype(np.float32)
        for n in (config.conditioning.count, 1, 3)
    ]
    wider[1] = (wider[1] > 0).astype(np.float32)
    assert np.abs(exported.network(*wider) - torch_model(weights, card).network(*wider)).max() < 1e-2
    weights.write_bytes(weights.read_bytes()[:-100])
    with pytest.raises(InputError, match="cannot be used"):
        torch_model(weights, card)
