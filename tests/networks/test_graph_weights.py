"""What an export has turned into a graph can be trained on."""

from __future__ import annotations

from dataclasses import replace

import pytest

from swifttailor.errors import InputError
from swifttailor.garment_sewer.network_config import NetworkConfig
from swifttailor.garment_sewer.sewer import SHIPPED as WEIGHTS

torch = pytest.importorskip("torch")
pytestmark = pytest.mark.needs_torch


@pytest.fixture(scope="module")
def model():
    from swifttailor.garment_sewer.model_file import load_model

    return load_model(WEIGHTS)


def network_of(model, **changes):
    from swifttailor.garment_sewer.network_torch import build_network

    values = {k: tuple(v) if isinstance(v, list) else v for k, v in model.card["config"]["network"].items()}
    return build_network(replace(NetworkConfig(**values), **changes), model.conditioning.count)


def examples(model, count, seed=0):
    generator = torch.Generator().manual_seed(seed)
    shape = (model.resolution, model.resolution)
    occupancy = (torch.rand((count, 1, *shape), generator=generator) < 0.6).float()
    conditioning = torch.randn((count, model.conditioning.count, *shape), generator=generator) * occupancy
    return conditioning, occupancy, torch.randn((count, 3, *shape), generator=generator) * 50 * occupancy


def test_the_packages_weights_compute_in_torch_what_they_do_in_onnxruntime(model):
    from swifttailor.networks.graph_weights_torch import graph_weights
    from swifttailor.networks.settled_norms_torch import settle_norms

    network = network_of(model).eval()
    network.load_state_dict(graph_weights(WEIGHTS, network))
    given = examples(model, 2)
    expected = torch.as_tensor(model.network(*(a.numpy() for a in given)))
    with torch.no_grad():
        assert float((network(*given) - expected).abs().max()) < 0.01  # cm
        settle_norms(network, lambda: [network(*examples(model, 2, k)) for k in range(3)])
        assert not network.training
        assert float((network(*given) - expected).abs().max()) < 0.01
        # By the batch as in training, the same, if the batch is what was shown.
        shown = [torch.cat(parts) for parts in zip(*(examples(model, 2, k) for k in range(3)), strict=True)]
        answered = network(*shown)
        network.train()
        network.token_norm.eval()  # was never folded, and knows garments, which these are not
        assert float((network(*shown) - answered).abs().max()) < 0.05


def test_other_networks_and_other_files_are_refused(model, tmp_path):
    from swifttailor.networks.graph_weights_torch import graph_weights

    for layers in (3, 5):
        with pytest.raises(InputError, match="is of another network"):
            graph_weights(WEIGHTS, network_of(model, layers=layers))
    with pytest.raises(InputError, match="is of another network"):
        graph_weights(WEIGHTS, network_of(model, hidden_size=128))
    broken = tmp_path / "weights.onnx"
    broken.write_bytes(WEIGHTS.read_bytes()[:5000])
    with pytest.raises(InputError, match="is not an ONNX file, or is damaged"):
        graph_weights(broken, network_of(model))
    with pytest.raises(InputError, match="Cannot read"):
        graph_weights(tmp_path / "none.onnx", network_of(model))


def test_the_packages_pattern_maker_computes_in_torch_what_it_does_in_onnxruntime():
    from swifttailor.pattern_maker.maker import SHIPPED
    from swifttailor.pattern_maker.network.building_torch import build_network
    from swifttailor.pattern_maker.network.export_torch import compare
    from swifttailor.pattern_maker.network.file_weights_torch import file_weights
    from swifttailor.pattern_maker.network.model_file import load_model, network_of
    from swifttailor.pattern_maker.network.runtime_torch import TorchRuntime

    model = load_model(SHIPPED)
    shape = network_of(model.card)
    network = build_network(shape, model.text.size)
    before = network.state_dict()["token_head.weight"].clone()
    network.load_state_dict(file_weights(SHIPPED, network))
    assert not torch.equal(before, network.state_dict()["token_head.weight"])
    runtime = TorchRuntime(network.eval())
    assert compare(model.runtime, runtime, model.text.size, image_size=model.image_size) < 1e-3
    for changes in ({"layers": 5}, {"vision_layers": 5}, {"intermediate_size": 512}):
        with pytest.raises(InputError, match="is of another network"):
            file_weights(SHIPPED, build_network(replace(shape, **changes), model.text.size))
