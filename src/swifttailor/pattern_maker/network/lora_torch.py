"""Small trained changes to large frozen matrices (LoRA, Hu et al. 2022)."""

from __future__ import annotations

import math

import torch
import torch.nn.functional as F
from torch import Tensor, nn


class LoraLinear(nn.Module):
    """A frozen linear layer plus a trained one of low rank, which is zero at first."""

    def __init__(self, base: nn.Linear, rank: int) -> None:
        super().__init__()
        self.base = base.requires_grad_(False)
        self.down = nn.Parameter(torch.zeros(rank, base.in_features))
        self.up = nn.Parameter(torch.zeros(base.out_features, rank))
        nn.init.kaiming_uniform_(self.down, a=math.sqrt(5))

    def forward(self, x: Tensor) -> Tensor:
        """(..., out) of (..., in)."""
        return self.base(x) + F.linear(F.linear(x, self.down), self.up)

    @property
    def weight(self) -> Tensor:
        """(out, in) of both together."""
        return self.base.weight + self.up @ self.down

    @property
    def bias(self) -> Tensor | None:
        """(out,) of the frozen layer."""
        return self.base.bias


def add_lora(module: nn.Module, rank: int) -> None:
    """Replaces all linear layers in a module, at any depth."""
    for name, child in module.named_children():
        if isinstance(child, nn.Linear):
            setattr(module, name, LoraLinear(child, rank))
        else:
            add_lora(child, rank)
