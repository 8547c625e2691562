"""Products in integers are the products, to a step of each row, and the matrices are kept as they were."""

from __future__ import annotations

import numpy as np
import pytest

torch = pytest.importorskip("torch")
pytestmark = pytest.mark.needs_torch

WIDTH = 64


class Bent(torch.nn.Module):
    """Two linear layers with a GELU between them."""

    def __init__(self) -> None:
        super().__init__()
        torch.manual_seed(0)
        self.up, self.down = torch.nn.Linear(WIDTH, 4 * WIDTH), torch.nn.Linear(4 * WIDTH, WIDTH)
        torch.nn.init.uniform_(self.up.bias, -1.0, 3.0)  # rows that reach as far as an encoder's

    def forward(self, x):
        return self.down(torch.nn.functional.gelu(self.up(x)))


@pytest.fixture(scope="module")
def rounded():
    from swifttailor.networks.byte_storage import round_to_bytes
    from swifttailor.networks.onnx_export_torch import export_graph

    network = Bent().eval()
    round_to_bytes(network)
    length = torch.export.Dim("length", min=2, max=64)
    example = (torch.rand(1, 7, WIDTH),)
    return network, export_graph(network, example, ({1: length},), ["x"], ["y"], row_products=True)


def run(graph, rows):
    from swifttailor.networks.onnx_session import open_session

    return open_session(graph, "a graph", "network").run(["y"], {"x": rows})[0]


def test_products_are_near_and_each_row_is_alone(rounded):
    network, graph = rounded
    rows = np.random.default_rng(0).normal(size=(1, 9, WIDTH)).astype(np.float32)
    rows[0, 4] *= 1000.0  # whose range would leave nothing of the others
    found = run(graph, rows)
    with torch.no_grad():
        made = network(torch.from_numpy(rows)).numpy()
    reach = np.abs(made).max(axis=-1, keepdims=True)
    assert (np.abs(found - made) < 0.03 * reach).all()
    assert not np.array_equal(found, made)
    np.testing.assert_array_equal(run(graph, rows[:, :4]), found[:, :4])


def test_a_row_of_zeros_is_the_bias(rounded):
    network, graph = rounded
    rows = np.zeros((1, 3, WIDTH), np.float32)
    with torch.no_grad():
        made = network(torch.from_numpy(rows)).numpy()
    np.testing.assert_allclose(run(graph, rows), made, atol=0.02)


def test_matrices_are_in_the_graph_as_they_were_rounded(rounded):
    import onnx

    from swifttailor.networks.graph_weights_torch import graph_tensors

    network, graph = rounded
    kinds = [node.op_type for node in onnx.load_from_string(graph).graph.node]
    assert kinds.count("MatMulInteger") == 2 and "MatMul" not in kinds
    named = graph_tensors(graph, "a graph").named
    for name in ("up.weight", "down.weight"):
        torch.testing.assert_close(named[name], network.state_dict()[name], atol=1e-7, rtol=1e-5)


def test_matrices_that_nobody_rounded_are_multiplied_as_they_are():
    import onnx

    from swifttailor.networks.onnx_export_torch import export_graph

    graph = export_graph(Bent().eval(), (torch.rand(1, 7, WIDTH),), (None,), ["x"], ["y"], row_products=True)
    kinds = [node.op_type for node in onnx.load_from_string(graph).graph.node]
    assert kinds.count("MatMul") + kinds.count("Gemm") == 2 and "MatMulInteger" not in kinds
