"""Muon: steps with like singular values for matrices, AdamW's for the rest."""

import math
from copy import deepcopy

import pytest

torch = pytest.importorskip("torch")
# Together only where torch is there.
muon = pytest.importorskip("swifttailor.training.muon_torch")
master_weights = pytest.importorskip("swifttailor.training.master_weights_torch")
pytestmark = pytest.mark.needs_torch


def built():
    torch.manual_seed(0)
    parts = {
        "words": torch.nn.Embedding(40, 24),
        "inner": torch.nn.Linear(24, 32),
        "convolution": torch.nn.Conv2d(32, 48, 3),
        "up": torch.nn.ConvTranspose2d(48, 20, 2, stride=2),
        "norm": torch.nn.LayerNorm(24),
        "head": torch.nn.Linear(24, 3),
        "tied": torch.nn.Linear(24, 40, bias=False),
    }
    network = torch.nn.ModuleDict(parts)
    network.tied.weight = network.words.weight
    network.register_parameter("place", torch.nn.Parameter(torch.randn(24, 24)))
    return network


@pytest.fixture
def network():
    return built()


def optimizer_of(network, kind, decay=0.1):
    weights = master_weights.MasterWeights(network)
    matrices = muon.inner_matrices(network)
    groups = master_weights.parameter_groups(weights, decay, lambda name: 1.0, matrices)
    return kind(groups, lr=1e-2, betas=(0.9, 0.99))


def with_gradients(network):
    torch.manual_seed(1)
    for parameter in network.parameters():
        parameter.grad = torch.randn_like(parameter)
    return network


def test_tables_heads_and_loose_weights_are_left_to_adamw(network):
    assert muon.inner_matrices(network) == {"inner.weight", "convolution.weight", "up.weight"}


@pytest.mark.parametrize("shape", [(32, 32), (20, 200), (200, 20)])
def test_an_orthogonal_matrix_has_the_singular_vectors_and_values_near_one(shape):
    torch.manual_seed(0)
    left, _ = torch.linalg.qr(torch.randn(shape[0], min(shape)))
    right, _ = torch.linalg.qr(torch.randn(shape[1], min(shape)))
    matrix = left * torch.logspace(0, -1.5, min(shape)) @ right.T

    turned = left.T @ muon.orthogonal(matrix, torch.float32) @ right

    values = turned.diagonal()
    assert values.min() > 0.6
    assert values.max() < 1.3
    assert (turned - values.diag()).abs().max() < 1e-3
    rounded = muon.orthogonal(matrix)
    assert rounded.dtype == matrix.dtype
    assert torch.linalg.norm(rounded - muon.orthogonal(matrix, torch.float32)) < 0.1 * math.sqrt(min(shape))


def test_a_zero_gradient_takes_no_step_and_makes_no_nan():
    assert (muon.orthogonal(torch.zeros(20, 30)) == 0).all()


def test_what_is_no_inner_matrix_takes_adamws_steps(network):
    other = built()
    other.load_state_dict(network.state_dict())
    one = optimizer_of(with_gradients(network), muon.Muon)
    two = optimizer_of(with_gradients(other), torch.optim.AdamW)
    for _ in range(3):
        one.step()
        two.step()

    inner = muon.inner_matrices(network)
    for (name, a), b in zip(network.named_parameters(), other.parameters(), strict=True):
        assert torch.equal(a, b) == (name not in inner), name


def test_a_convolution_steps_as_the_matrix_of_its_filters(network):
    network = network.to(memory_format=torch.channels_last)
    before = network.convolution.weight.detach().clone()
    optimizer = optimizer_of(with_gradients(network), muon.Muon)
    gradient = network.convolution.weight.grad.clone()

    optimizer.step()

    ahead = gradient * (1 - muon.MOMENTUM) * (1 + muon.MOMENTUM)  # beyond the scale, which orthogonal drops
    step = muon.orthogonal(ahead.reshape(48, -1)).reshape(before.shape) * muon.SHARE * math.sqrt(32 * 9)
    expected = before * (1 - 1e-2 * 0.1) - 1e-2 * step
    # Adding up in another order turns the last bits of bfloat16.
    assert (network.convolution.weight - expected).abs().max() < 0.02 * (1e-2 * step).abs().max()


def test_its_steps_are_as_long_as_adamws(network):
    before = {name: p.detach().clone() for name, p in network.named_parameters()}
    optimizer_of(with_gradients(network), muon.Muon, decay=0.0).step()

    moved = (network.convolution.weight.detach() - before["convolution.weight"]).square().mean().sqrt()
    assert float(moved) == pytest.approx(muon.SHARE * 1e-2, rel=0.3)


def test_it_goes_on_where_it_stood(network):
    optimizer = optimizer_of(with_gradients(network), muon.Muon)
    optimizer.step()
    other = built()
    other.load_state_dict(network.state_dict())
    again = optimizer_of(with_gradients(other), muon.Muon)
    again.load_state_dict(deepcopy(optimizer.state_dict()))
    with_gradients(network)

    optimizer.step()
    again.step()

    for a, b in zip(network.parameters(), other.parameters(), strict=True):
        assert torch.equal(a, b)
