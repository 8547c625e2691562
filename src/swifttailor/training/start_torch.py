"""Beginning a training with the weights of another."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from torch import nn

from swifttailor.errors import InputError
from swifttailor.networks.graph_weights_torch import MAX_BYTES, graph_tensors, state_of
from swifttailor.networks.model_file import read_bytes

GRAPH = ".onnx"


def load_start(network: nn.Module, path: Path, optional: Sequence[tuple[str, ...]] = ()) -> list[str]:
    """Puts the weights of another run into a network.

    Args:
        network: Changed in place.
        path: Of the weights: weights.safetensors of a run, or the model file (.onnx) made of one.
        optional: Parts, each as the beginnings of the names of its weights. One of which the file lacks
            weights, or a run has others, stays as it is.

    Returns:
        The beginnings of the names of what stayed.

    Raises:
        InputError: The file is missing, damaged, or of another shape.
        MissingExtraError: The file is a graph, and onnx is not installed.
    """
    if path.suffix == GRAPH:
        values = graph_tensors(read_bytes(path, MAX_BYTES), str(path)).named
        lacking = [p for part in optional for p in part if not any(name.startswith(p) for name in values)]
        network.load_state_dict(state_of(values, network, path, keeps=lacking))
        return lacking
    from safetensors import SafetensorError
    from safetensors.torch import load_file

    try:
        loaded = load_file(path)
        own = network.state_dict()
        stayed: list[str] = []
        for part in optional:
            mine = {k: v for k, v in own.items() if k.startswith(part)}
            given = {k: v for k, v in loaded.items() if k.startswith(part)}
            if {k: v.shape for k, v in mine.items()} != {k: v.shape for k, v in given.items()}:
                loaded = {k: v for k, v in loaded.items() if k not in given} | mine
                stayed += part
        network.load_state_dict(loaded)
    except (SafetensorError, OSError, RuntimeError) as error:
        lines = str(error).strip().splitlines()
        raise InputError(
            f"The weights '{path}' to start with cannot be used: {' '.join(lines[:2])[:300]}. Give the "
            "weights.safetensors of a run of the same network."
        ) from error
    return stayed
