"""Muon: steps with like singular values for matrices, AdamW's for the rest."""

import math
from copy import deepcopy

import pytest

torch = pytest.importorskip("torch")

from torch import nn  # noqa: E402

from swifttailor.training.master_weights_torch import MasterWeights, parameter_groups  # noqa: E402
from swifttailor.training.muon_torch import MOMENTUM, SHARE, Muon, inner_matrices, orthogonal  # noqa: E402


class _Network(nn.Module):
    def __init__(self) -> None:
        super().__init__()
        self.words = nn.Embedding(40, 24)
        self.inner = nn.Linear(24, 32)
        self.convolution = nn.Conv2d(32, 48, 3)
        self.up = nn.ConvTranspose2d(48, 20, 2, stride=2)
        self.norm = nn.LayerNorm(24)
        self.head = nn.Linear(24, 3)
        self.tied = nn.Linear(24, 40, bias=False)
        self.tied.weight = self.words.weight
        self.place = nn.Parameter(torch.randn(24, 24))


@pytest.fixture
def network():
    torch.manual_seed(0)
    return _Network()


def _optimizer(network, kind, decay=0.1):
    groups = parameter_groups(MasterWeights(network), decay, lambda name: 1.0, inner_matrices(network))
    return kind(groups, lr=1e-2, betas=(0.9, 0.99))


def _with_gradients(network):
    torch.manual_seed(1)
    for parameter in network.parameters():
        parameter.grad = torch.randn_like(parameter)
    return network


def test_tables_heads_and_loose_weights_are_left_to_adamw(network):
    assert inner_matrices(network) == {"inner.weight", "convolution.weight", "up.weight"}


@pytest.mark.parametrize("shape", [(32, 32), (20, 200), (200, 20)])
def test_an_orthogonal_matrix_has_the_singular_vectors_and_values_near_one(shape):
    torch.manual_seed(0)
    left, _ = torch.linalg.qr(torch.randn(shape[0], min(shape)))
    right, _ = torch.linalg.qr(torch.randn(shape[1], min(shape)))
    matrix = left * torch.logspace(0, -1.5, min(shape)) @ right.T

    turned = left.T @ orthogonal(matrix, torch.float32) @ right

    values = turned.diagonal()
    assert values.min() > 0.6
    assert values.max() < 1.3
    assert (turned - values.diag()).abs().max() < 1e-3
    rounded = orthogonal(matrix)
    assert rounded.dtype == matrix.dtype
    assert torch.linalg.norm(rounded - orthogonal(matrix, torch.float32)) < 0.1 * math.sqrt(min(shape))


def test_a_zero_gradient_takes_no_step_and_makes_no_nan():
    assert (orthogonal(torch.zeros(20, 30)) == 0).all()


def test_what_is_no_inner_matrix_takes_adamws_steps(network):
    other = _Network()
    other.load_state_dict(network.state_dict())
    one, two = _optimizer(_with_gradients(network), Muon), _optimizer(_with_gradients(other), torch.optim.AdamW)
    for _ in range(3):
        one.step()
        two.step()

    inner = inner_matrices(network)
    for (name, a), b in zip(network.named_parameters(), other.parameters(), strict=True):
        assert torch.equal(a, b) == (name not in inner), name


def test_a_convolution_steps_as_the_matrix_of_its_filters(network):
    network = network.to(memory_format=torch.channels_last)
    before = network.convolution.weight.detach().clone()
    optimizer = _optimizer(_with_gradients(network), Muon)
    gradient = network.convolution.weight.grad.clone()

    optimizer.step()

    ahead = gradient * (1 - MOMENTUM) * (1 + MOMENTUM)  # beyond the scale, which orthogonal drops
    step = orthogonal(ahead.reshape(48, -1)).reshape(before.shape) * SHARE * math.sqrt(32 * 9)
    expected = before * (1 - 1e-2 * 0.1) - 1e-2 * step
    # Adding up in another order turns the last bits of bfloat16.
    assert (network.convolution.weight - expected).abs().max() < 0.02 * (1e-2 * step).abs().max()


def test_its_steps_are_as_long_as_adamws(network):
    before = {name: p.detach().clone() for name, p in network.named_parameters()}
    _optimizer(_with_gradients(network), Muon, decay=0.0).step()

    moved = (network.convolution.weight.detach() - before["convolution.weight"]).square().mean().sqrt()
    assert float(moved) == pytest.approx(SHARE * 1e-2, rel=0.3)


def test_it_goes_on_where_it_stood(network):
    optimizer = _optimizer(_with_gradients(network), Muon)
    optimizer.step()
    other = _Network()
    other.load_state_dict(network.state_dict())
    again = _optimizer(_with_gradients(other), Muon)
    again.load_state_dict(deepcopy(optimizer.state_dict()))
    _with_gradients(network)

    optimizer.step()
    again.step()

    for a, b in zip(network.parameters(), other.parameters(), strict=True):
        assert torch.equal(a, b)
