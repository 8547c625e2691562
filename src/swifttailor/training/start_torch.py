"""Beginning a training with the weights of another."""

from __future__ import annotations

from pathlib import Path

from torch import Tensor, nn

from swifttailor.errors import InputError


def load_start(network: nn.Module, path: Path, optional: tuple[str, ...] = ()) -> None:
    """Puts the weights of another run into a network.

    Args:
        network: Changed in place.
        path: Of the weights.
        optional: Beginnings of the names of weights that stay as they are where the file lacks them, or has
            others.

    Raises:
        InputError: The file is missing, damaged, or of another shape.
    """
    from safetensors import SafetensorError
    from safetensors.torch import load_file

    try:
        loaded = load_file(path)
        own = network.state_dict()
        if optional:
            loaded = {k: v for k, v in loaded.items() if not k.startswith(optional) or _fits(own.get(k), v)}
            loaded = {k: v for k, v in own.items() if k.startswith(optional)} | loaded
        network.load_state_dict(loaded)
    except (SafetensorError, OSError, RuntimeError) as error:
        lines = str(error).strip().splitlines()
        raise InputError(
            f"The weights '{path}' to start with cannot be used: {' '.join(lines[:2])[:300]}. Give the "
            "weights.safetensors of a run of the same network."
        ) from error


def _fits(own: Tensor | None, loaded: Tensor) -> bool:
    return own is not None and own.shape == loaded.shape
