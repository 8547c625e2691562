"""Networks with the weights of a run, to be used or exported. Import this where needed: it loads torch."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TypeVar

from torch import nn

from swifttailor.errors import InputError
from swifttailor.networks.byte_storage import round_to_bytes
from swifttailor.networks.folded_norms_torch import fold_norms
from swifttailor.networks.half_storage import round_to_half

Network = TypeVar("Network", bound=nn.Module)


def trained_network(
    build: Callable[[], Network], weights: Path, *, half: bool = False, eight_bits: bool = False
) -> Network:
    """A trained network in evaluation mode, its norms folded.

    Args:
        build: Makes the network that a card describes; it may fail with a KeyError or TypeError.
        weights: weights.safetensors of a run.
        half: Whether its weights are rounded to what float16 holds.
        eight_bits: Whether its matrices are rounded to what bytes hold (`round_to_bytes`).

    Raises:
        InputError: The file is missing, damaged, or of another network.
    """
    from safetensors import SafetensorError
    from safetensors.torch import load_file

    try:
        network = build()
        network.load_state_dict(load_file(weights))
    except (SafetensorError, OSError, RuntimeError, KeyError, TypeError) as error:
        lines = str(error).strip().splitlines()
        raise InputError(
            f"The weights '{weights}' cannot be used: {lines[0][:200] if lines else type(error).__name__}. "
            "Copy the folder of the run again."
        ) from error
    fold_norms(network.eval())
    if half:
        round_to_half(network)
    if eight_bits:
        round_to_bytes(network)
    return network
