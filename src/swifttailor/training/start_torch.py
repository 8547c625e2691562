"""Beginning a training with the weights of another."""

from __future__ import annotations

from pathlib import Path

from torch import nn

from swifttailor.errors import InputError


def load_start(network: nn.Module, path: Path) -> None:
    """Puts the weights of another run into a network.

    Raises:
        InputError: The file is missing, damaged, or of another shape.
    """
    from safetensors import SafetensorError
    from safetensors.torch import load_file

    try:
        network.load_state_dict(load_file(path))
    except (SafetensorError, OSError, RuntimeError) as error:
        lines = str(error).strip().splitlines()
        raise InputError(
            f"The weights '{path}' to start with cannot be used: {' '.join(lines[:2])[:300]}. Give the "
            "weights.safetensors of a run of the same network."
        ) from error
