"""Steps whose singular values are all alike, for the matrices inside a network (Muon).

Jordan et al. 2024, "Muon: an optimizer for hidden layers in neural networks", with the step size of Liu et
al. 2025, "Muon is scalable for LLM training", by which a learning rate and a decay chosen for AdamW can stay.
torch's own (from 2.9) takes only matrices; most weights here belong to convolutions.
"""

from __future__ import annotations

import math
from typing import Any

import torch
from torch import Tensor, nn

MOMENTUM = 0.95
ITERATION = (3.4445, -4.7750, 2.0315)
"""Coefficients of Jordan's quintic: five rounds bring singular values of 0.001 to 1 between 0.7 and 1.2."""
ROUNDS = 5
SHARE = 0.2
"""Root mean square of AdamW's usual step, in learning rates."""
NARROW = 16
"""Weights with fewer rows or columns than this are left to AdamW."""


class Muon(torch.optim.AdamW):
    """AdamW, but for the groups marked ``orthogonal``: their momentum is made orthogonal and taken."""

    @torch.no_grad()
    def step(self, closure: Any = None) -> Any:
        """Takes one step; `closure` is not used, and nothing returned."""
        groups = self.param_groups
        self.param_groups = [group for group in groups if not group["orthogonal"]]
        try:
            super().step()
        finally:
            self.param_groups = groups
        for group in groups:
            if group["orthogonal"]:
                self._step_matrices(group)

    def _step_matrices(self, group: dict[str, Any]) -> None:
        for weight in group["params"]:
            if weight.grad is None:
                continue
            state = self.state[weight]
            if "momentum" not in state:
                state["momentum"] = torch.zeros_like(weight.grad)
                state["step"] = torch.zeros(())  # AdamW looks for it when a state is loaded
            momentum = state["momentum"].lerp_(weight.grad, 1 - MOMENTUM)
            ahead = weight.grad.lerp(momentum, MOMENTUM).flatten(1)
            size = SHARE * math.sqrt(max(ahead.shape))
            weight.mul_(1 - group["lr"] * group["weight_decay"])
            weight.sub_(orthogonal(ahead).view(weight.shape), alpha=group["lr"] * size)


def orthogonal(matrix: Tensor, dtype: torch.dtype = torch.bfloat16) -> Tensor:
    """A matrix with the same singular vectors, and singular values near 1 (Newton-Schulz).

    Args:
        matrix: (rows, columns).
        dtype: To compute in.
    """
    a, b, c = ITERATION
    x = matrix.to(dtype)
    tall = x.shape[0] > x.shape[1]
    x = x.T if tall else x
    x = x / x.norm().clamp(min=1e-7)
    for _ in range(ROUNDS):
        gram = x @ x.T
        x = torch.addmm(x, torch.addmm(gram, gram, gram, beta=b, alpha=c), x, beta=a)
    return (x.T if tall else x).to(matrix.dtype)


def inner_matrices(network: nn.Module) -> set[str]:
    """Names of the weights that Muon is for: those of linear layers and convolutions, wide on both sides.

    Embeddings are left out, and what shares its weight with one; so are heads of a few numbers.
    """
    tables = {id(m.weight) for m in network.modules() if isinstance(m, nn.Embedding)}
    return {
        f"{name}.weight"
        for name, module in network.named_modules()
        if isinstance(module, (nn.Linear, nn.Conv2d, nn.ConvTranspose2d))
        and id(module.weight) not in tables
        and min(module.weight.flatten(1).shape) >= NARROW
    }
