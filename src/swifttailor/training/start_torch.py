"""Beginning a training with the weights of another."""

from __future__ import annotations

from pathlib import Path

from torch import nn

from swifttailor.errors import InputError


def load_start(network: nn.Module, path: Path, optional: tuple[str, ...] = ()) -> None:
    """Puts the weights of another run into a network.

    Args:
        network: Changed in place.
        path: Of the weights.
        optional: Beginnings of the names of weights that stay as they are where the file lacks them.

    Raises:
        InputError: The file is missing, damaged, or of another shape.
    """
    from safetensors import SafetensorError
    from safetensors.torch import load_file

    try:
        loaded = load_file(path)
        own = {k: v for k, v in network.state_dict().items() if k.startswith(optional)} if optional else {}
        network.load_state_dict(own | loaded)
    except (SafetensorError, OSError, RuntimeError) as error:
        lines = str(error).strip().splitlines()
        raise InputError(
            f"The weights '{path}' to start with cannot be used: {' '.join(lines[:2])[:300]}. Give the "
            "weights.safetensors of a run of the same network."
        ) from error
