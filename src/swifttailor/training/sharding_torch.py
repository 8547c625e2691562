"""A network in parts, each process holding its share of weights, gradients and optimiser state (FSDP).

For networks that do not fit into one GPU four times over: every layer is put together when it is needed and
taken apart again (Zhao et al. 2023, torch's ``fully_shard``).
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import torch
from torch import Tensor, nn
from torch.distributed.device_mesh import init_device_mesh
from torch.distributed.fsdp import MixedPrecisionPolicy, fully_shard
from torch.distributed.tensor import DTensor, distribute_tensor

from swifttailor.errors import InputError
from swifttailor.training.processes_torch import Processes

_FLOAT = (nn.BatchNorm1d, nn.BatchNorm2d)
"""Torch wants their weights in float32; they are units of their own where the rest is lowered."""


def shard(
    network: nn.Module, units: Iterable[nn.Module], lowered: nn.Module, processes: Processes, precision: str
) -> None:
    """Splits a network's weights over the processes; all of them are float32 from then on.

    Args:
        network: Changed in place; is called as before.
        units: Modules in it that are put together one at a time, inner ones first.
        lowered: The part of it that computes in `precision`; the rest does in float32.
        processes: Of the training.
        precision: ``bfloat16`` or ``float32``.

    Raises:
        InputError: There is only one process.
    """
    if processes.count == 1:
        raise InputError(
            "shard=true splits a network over several processes, and there is one. Start them with: torchrun "
            "--nproc_per_node N -m swifttailor train ..."
        )
    mesh = init_device_mesh(processes.device.type, (processes.count,))
    low = MixedPrecisionPolicy(torch.bfloat16, torch.float32) if precision == "bfloat16" else None
    inside = {m for m in lowered.modules() if not isinstance(m, _FLOAT)}
    for unit in units:
        policy = low if unit in inside else None
        fully_shard(unit, mesh=mesh, mp_policy=policy or MixedPrecisionPolicy())
    fully_shard(network, mesh=mesh)


def is_sharded(weights: Iterable[Tensor]) -> bool:
    """Whether some are split over processes."""
    return any(isinstance(w, DTensor) for w in weights)


def whole(value: Any, *, keep: bool) -> Any:
    """Puts together every tensor in nested dicts and lists; all processes have to call this.

    Args:
        value: Plain values and tensors that are not split stay as they are.
        keep: Whether this process wants the result, in the computer's memory; else what was split is empty.
    """
    if isinstance(value, dict):
        return {name: whole(item, keep=keep) for name, item in value.items()}
    if isinstance(value, list):
        return [whole(item, keep=keep) for item in value]
    if isinstance(value, DTensor):
        full = value.full_tensor()
        return full.cpu() if keep else full.new_empty(0)
    return value


def split_like(values: dict[str, Tensor], own: dict[str, Tensor]) -> dict[str, Tensor]:
    """Whole tensors, split as those of the same names are."""
    return {name: _like(value, own.get(name)) for name, value in values.items()}


def split_state(state: dict[str, Any], optimised: list[nn.Parameter]) -> dict[str, Any]:
    """An optimiser's whole state, split as the weights that it optimises are.

    Args:
        state: From `whole` of its ``state_dict``.
        optimised: Its weights in their order.
    """
    parts = {
        place: {
            name: _like(value, optimised[place]) if torch.is_tensor(value) and value.ndim else value
            for name, value in entries.items()
        }
        for place, entries in state["state"].items()
    }
    return state | {"state": parts}


def _like(value: Tensor, own: Tensor | None) -> Tensor:
    if not isinstance(own, DTensor):
        return value
    return distribute_tensor(value.to(own.device), own.device_mesh, own.placements)
