"""Layers that are compiled compute what they computed before."""

from __future__ import annotations

import pytest

from swifttailor.errors import InputError

torch = pytest.importorskip("torch")
compilation = pytest.importorskip("swifttailor.training.compilation_torch")
pytestmark = pytest.mark.needs_torch

CPU = torch.device("cpu")


def a_layer():
    torch.manual_seed(0)
    return torch.nn.Sequential(torch.nn.Linear(8, 16), torch.nn.GELU(), torch.nn.Linear(16, 8))


@pytest.mark.filterwarnings("ignore")
def test_a_compiled_layer_has_the_same_values_gradients_and_weights():
    plain, compiled = a_layer(), a_layer()
    compilation.compile_layers([compiled], CPU)
    assert list(compiled.state_dict()) == list(plain.state_dict())
    for length in (5, 9, 7):
        given = torch.randn(2, length, 8, generator=torch.Generator().manual_seed(length))
        for layer in (plain, compiled):
            layer.zero_grad()
            layer(given).square().sum().backward()
        assert torch.allclose(compiled(given), plain(given), atol=1e-5)
        assert torch.allclose(compiled[0].weight.grad, plain[0].weight.grad, atol=1e-4)
    with compilation.not_compiled():
        assert torch.equal(compiled(given), plain(given))


def test_without_a_compiler_it_is_refused(monkeypatch):
    monkeypatch.setattr(compilation.shutil, "which", lambda name: None)
    with pytest.raises(InputError, match="needs a C\\+\\+ compiler"):
        compilation.compile_layers([a_layer()], CPU)
