"""Weights kept in bytes are the weights that were rounded."""

from __future__ import annotations

import io

import numpy as np
import pytest

torch = pytest.importorskip("torch")
pytestmark = pytest.mark.needs_torch


def a_network(seed=0):
    torch.manual_seed(seed)
    network = torch.nn.Sequential(
        torch.nn.Conv2d(3, 16, 3, padding=1),
        torch.nn.ReLU(),
        torch.nn.Conv2d(16, 16, 7, padding=3, groups=16),
        torch.nn.AdaptiveAvgPool2d(4),
        torch.nn.Flatten(),
        torch.nn.Linear(256, 30),
        torch.nn.Linear(30, 4),
    )
    with torch.no_grad():
        network[2].weight[3] = 0.0  # a row with no scale
    return network.eval()


def test_rows_are_rounded_by_half_a_step_at_most():
    from swifttailor.networks.byte_storage import round_to_bytes

    before, after = a_network(), a_network()
    round_to_bytes(after)
    for old, new in zip(before.parameters(), after.parameters(), strict=True):
        if old.ndim < 2 or old.numel() < 256:
            assert torch.equal(old, new)
            continue
        rows = old.flatten(1).abs().amax(dim=1, keepdim=True)
        assert ((old - new).flatten(1).abs() <= rows / 254 * 1.001).all()
        assert not torch.equal(old, new)


def test_a_graph_of_rounded_weights_is_a_quarter_and_computes_the_same():
    from swifttailor.networks.byte_storage import round_to_bytes
    from swifttailor.networks.graph_weights_torch import graph_tensors
    from swifttailor.networks.onnx_export_torch import export_graph
    from swifttailor.networks.onnx_session import open_session

    network, picture = a_network(), torch.rand(1, 3, 24, 24)
    whole = export_graph(network, (picture,), (None,), ["picture"], ["answer"])
    round_to_bytes(network)
    graph = export_graph(network, (picture,), (None,), ["picture"], ["answer"])
    assert len(graph) < len(whole) - 2.5 * (16 * 27 + 16 * 49 + 256 * 30)
    session = open_session(graph, "a graph", "network", threads=1)
    (found,) = session.run(["answer"], {"picture": picture.numpy()})
    with torch.no_grad():
        np.testing.assert_allclose(found, network(picture).numpy(), atol=1e-6)
    named = graph_tensors(graph, "a graph").named
    for name in ("0.weight", "2.weight", "5.weight"):
        torch.testing.assert_close(named[name], network.state_dict()[name], atol=1e-7, rtol=1e-5)


def test_weights_that_nobody_rounded_stay_as_they_are():
    import onnx

    from swifttailor.networks.byte_storage import store_in_bytes
    from swifttailor.networks.onnx_export_torch import export_graph

    graph = export_graph(a_network(), (torch.rand(1, 3, 24, 24),), (None,), ["picture"], ["answer"])
    model = onnx.load(io.BytesIO(graph))
    assert store_in_bytes(model) == 0
