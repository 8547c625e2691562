"""Norms folded into convolutions change nothing but who computes them."""

from __future__ import annotations

import pytest

torch = pytest.importorskip("torch")
pytestmark = pytest.mark.needs_torch


def network():
    from torch import nn

    torch.manual_seed(0)
    inner = nn.Sequential(nn.Conv2d(4, 4, 3, padding=1), nn.BatchNorm2d(4), nn.GELU())
    made = nn.Sequential(nn.Conv2d(3, 4, 3, bias=False), nn.BatchNorm2d(4), inner, nn.BatchNorm2d(4))
    for module in made.modules():
        if isinstance(module, nn.BatchNorm2d):
            nn.init.uniform_(module.weight, 0.5, 2.0)
            nn.init.normal_(module.bias)
    made.train()
    for _ in range(5):
        made(torch.randn(4, 3, 9, 9) * 3 + 1)
    return made.eval()


def test_predictions_stay_and_norms_go():
    from swifttailor.networks.folded_norms_torch import fold_norms

    made, given = network(), torch.randn(2, 3, 9, 9)
    with torch.no_grad():
        before = made(given)
        assert fold_norms(made) == 2
        assert torch.allclose(made(given), before, atol=1e-5)
    left = [m for m in made.modules() if isinstance(m, torch.nn.BatchNorm2d)]
    assert len(left) == 1  # the one that follows no convolution
    assert fold_norms(made) == 0
