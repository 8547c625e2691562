"""Weights in bfloat16 to compute with, and in float32 to add small steps to (Micikevicius et al. 2018)."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable
from typing import Any

import torch
from torch import Tensor, nn

from swifttailor.training.sharding_torch import is_sharded


class MasterWeights:
    """The weights of a network as an optimiser sees them: all in float32."""

    def __init__(self, network: nn.Module, lowered: Iterable[nn.Module] = ()) -> None:
        """Keeps the weights of some parts in float32, and lets these parts compute in bfloat16.

        Args:
            network: Changed in place; its other parts are trained as they are.
            lowered: Parts whose weights become bfloat16, those of norms over the batch apart, which torch
                wants in float32.
        """
        self.network = network
        inside = {id(p) for part in lowered for p in part.parameters()}
        norms = (m for m in network.modules() if isinstance(m, (nn.BatchNorm1d, nn.BatchNorm2d)))
        inside -= {id(p) for norm in norms for p in norm.parameters()}
        self._pairs: list[tuple[nn.Parameter, nn.Parameter]] = []
        self.named: dict[str, nn.Parameter] = {}
        """What is optimised, by name."""
        for name, parameter in network.named_parameters():
            master = parameter
            if id(parameter) in inside:
                master = nn.Parameter(parameter.detach().float().clone(), parameter.requires_grad)
                parameter.data = parameter.data.bfloat16()
                self._pairs.append((parameter, master))
            self.named[name] = master

    @property
    def are_sharded(self) -> bool:
        """Whether this process holds only a part of them."""
        return is_sharded(self.named.values())

    def take_gradients(self) -> None:
        """Moves the gradients of a backward pass to where the optimiser looks for them."""
        for parameter, master in self._pairs:
            if parameter.grad is not None:
                master.grad = parameter.grad.float()
                parameter.grad = None

    @torch.no_grad()
    def give_weights(self) -> None:
        """Rounds the weights into the network."""
        for parameter, master in self._pairs:
            parameter.copy_(master)

    def state_dict(self) -> dict[str, Tensor]:
        """All weights, float32 where they are kept so."""
        own = self.network.state_dict()
        return {name: self.named.get(name, value).detach() for name, value in own.items()}

    @torch.no_grad()
    def load_state_dict(self, state: dict[str, Tensor]) -> None:
        """Puts weights into the network, and keeps their float32."""
        self.network.load_state_dict(state)
        for name, master in self.named.items():
            master.copy_(state[name])


def parameter_groups(
    weights: MasterWeights,
    weight_decay: float,
    rate_factor: Callable[[str], float],
    orthogonal: Collection[str] = (),
) -> list[dict[str, Any]]:
    """Groups for an optimiser: matrices decay, biases and norms do not; some may have a rate of their own.

    Args:
        weights: Of the network.
        weight_decay: Of the matrices.
        rate_factor: Of a weight, by its name: factor on the learning rate, kept as the group's ``factor``.
        orthogonal: Names of weights whose groups are marked as `Muon`'s.
    """
    groups: dict[tuple[bool, float, bool], list[nn.Parameter]] = {}
    for name, parameter in weights.named.items():
        if parameter.requires_grad:
            kind = (parameter.ndim > 1, rate_factor(name), name in orthogonal)
            groups.setdefault(kind, []).append(parameter)
    return [
        {
            "params": parameters,
            "weight_decay": weight_decay if decays else 0.0,
            "factor": factor,
            "orthogonal": is_orthogonal,
        }
        for (decays, factor, is_orthogonal), parameters in groups.items()
    ]


def choose_precision(wanted: str, device: torch.device) -> str:
    """``bfloat16`` or ``float32``: what is wanted, or for ``auto`` bfloat16 where the chip computes in it."""
    if wanted != "auto":
        return wanted
    if device.type == "cuda":
        return "bfloat16" if torch.cuda.is_bf16_supported() else "float32"
    # Without instructions of its own for it, a CPU is slower in bfloat16.
    return "bfloat16" if torch.ops.mkldnn._is_mkldnn_bf16_supported() else "float32"
