"""The weights of a network out of the model file made of it. Import where needed: it loads torch."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import torch
from torch import Tensor, nn

from swifttailor.errors import InputError, MissingExtraError
from swifttailor.networks.folded_norms_torch import foldable

MAX_BYTES = 2**31


def graph_weights(path: Path, network: nn.Module) -> dict[str, Tensor]:
    """Reads weights for a network from the ONNX graph that an export has made of one of its shape.

    An export keeps names, except that it turns the matrices of linear layers, which lose their names thereby,
    and folds norms over the batch into the convolutions before them. A matrix is found again by the bias that
    is added to its product. Folded norms come back as ones that change nothing but add the bias that the
    convolution has in the file; `settle_norms` makes norms of them that can be trained.

    Args:
        path: The .onnx file.
        network: Tells names and shapes; not changed.

    Returns:
        A state for the network with which it computes what the graph does.

    Raises:
        InputError: The file is missing, damaged or too large, or of a network of another shape.
        MissingExtraError: onnx is not installed.
    """
    values = _read(path)
    own = network.state_dict()
    # A weight with the name of an input or output has another in the graph.
    found = {name: name if name in values else f"{name}.weight" for name in own}
    state = {name: values[there] for name, there in found.items() if there in values}
    for convolution, norm, width, eps in foldable(network):
        bias = values.get(f"{convolution}.bias")
        if bias is None:
            continue
        state[f"{norm}.weight"] = torch.ones(width)
        state[f"{norm}.bias"] = bias
        state[f"{norm}.running_mean"] = torch.zeros(width)
        state[f"{norm}.running_var"] = torch.full((width,), 1 - eps)
    for name, value in own.items():
        if name.endswith("num_batches_tracked"):
            state[name] = torch.zeros_like(value)
    wrong = sorted(name for name in own if name not in state or state[name].shape != own[name].shape)
    if wrong:
        raise InputError(
            f"The model file '{path}' is of another network: {len(wrong)} of {len(own)} weights are missing "
            f"or have another shape, '{wrong[0]}' first. Set network.* as its card says."
        )
    return {name: state[name].to(value.dtype) for name, value in own.items()}


def _read(path: Path) -> dict[str, Tensor]:
    """The named tensors of a graph, matrices by the names of the linear layers' weights."""
    try:
        import onnx
        from onnx import numpy_helper
    except ImportError as error:
        raise MissingExtraError("onnx", "train", "Reading the weights of a model file") from error
    try:
        if path.stat().st_size > MAX_BYTES:
            raise InputError(f"'{path}' is larger than 2 GB; model files are smaller.")
        model: Any = onnx.load_from_string(path.read_bytes())
    except OSError as error:
        raise InputError(f"Cannot read the weights '{path}': {error.strerror or error}.") from error
    except Exception as error:  # protobuf's DecodeError is not public
        if isinstance(error, InputError):
            raise
        raise InputError(f"'{path}' is no ONNX file, or is damaged. Copy it again.") from error
    arrays = {t.name: numpy_helper.to_array(t) for t in model.graph.initializer}
    for node in model.graph.node:  # stored in half, see `half_storage`
        if node.op_type == "Cast" and node.input[0] in arrays:
            arrays[node.output[0]] = arrays[node.input[0]]
    products = {n.output[0]: n.input[1] for n in model.graph.node if n.op_type == "MatMul"}
    for node in model.graph.node:
        if node.op_type != "Add":
            continue
        for product, bias in (node.input, reversed(node.input)):
            matrix = arrays.get(products.get(product, ""))
            if matrix is not None and bias in arrays and bias.endswith(".bias"):
                arrays[f"{bias.removesuffix('bias')}weight"] = matrix.T
    return {
        name: torch.from_numpy(np.array(value, dtype=np.float32, order="C"))
        for name, value in arrays.items()
        if value.dtype in (np.float16, np.float32)
    }
