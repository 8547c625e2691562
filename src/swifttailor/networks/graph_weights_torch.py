"""The weights of a network out of the model file made of it. Import where needed: it loads torch."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import torch
from torch import Tensor, nn

from swifttailor.errors import InputError, MissingExtraError
from swifttailor.networks.byte_storage import SCALE
from swifttailor.networks.byte_storage import STORED as STORED_IN_BYTES
from swifttailor.networks.folded_norms_torch import foldable
from swifttailor.networks.model_file import read_bytes
from swifttailor.networks.onnx_contents import keeps_values_elsewhere
from swifttailor.networks.row_products import WHOLE

MAX_BYTES = 2**31
STORED = (".half", SCALE)
"""What `half_storage` and `byte_storage` add to names."""


@dataclass(frozen=True, eq=False)
class GraphTensors:
    """The weights in a graph."""

    named: dict[str, Tensor]
    """By their names in the network; matrices of linear layers without bias are not among them."""
    matrices: tuple[Tensor, ...]
    """What products are made with, in their order, as linear layers keep them: (out, in)."""


def graph_weights(path: Path, network: nn.Module) -> dict[str, Tensor]:
    """Reads weights for a network from the ONNX graph that an export has made of one of its shape.

    Args:
        path: The .onnx file.
        network: Tells names and shapes; not changed.

    Returns:
        A state for the network with which it computes what the graph does; see `state_of`.

    Raises:
        InputError: The file is missing, damaged or too large, or of a network of another shape.
        MissingExtraError: onnx is not installed.
    """
    return state_of(graph_tensors(read_bytes(path, MAX_BYTES), str(path)).named, network, path)


def state_of(
    values: Mapping[str, Tensor], network: nn.Module, path: Path, *, keeps: Sequence[str] = ()
) -> dict[str, Tensor]:
    """A state for a network with the weights of a model file.

    Folded norms come back as ones that change nothing but add the bias that the convolution has in the file;
    `settle_norms` makes norms of them that can be trained.

    Args:
        values: By name.
        network: Tells names and shapes; not changed.
        path: Of the file, for messages.
        keeps: Beginnings of names of weights that the file lacks and the network keeps.

    Raises:
        InputError: The file is of a network of another shape.
    """
    own = network.state_dict()
    # A weight with the name of an input or output has another in the graph.
    found = {name: name if name in values else f"{name}.weight" for name in own}
    state = {name: values[there] for name, there in found.items() if there in values}
    state |= {name: value for name, value in own.items() if name.startswith(tuple(keeps))}
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
    wrong = [name for name in own if name not in state or state[name].shape != own[name].shape]
    known = {*own, *found.values(), *(f"{convolution}.bias" for convolution, _, _, _ in foldable(network))}
    parts = {name.split(".")[0] for name in own}
    wrong += [n for n in values if n.split(".")[0] in parts and n not in known and not n.endswith(STORED)]
    if wrong:
        raise InputError(
            f"The model file '{path}' is of another network: {len(wrong)} weights are missing, have another "
            f"shape or are not known, '{min(wrong)}' for one. Set network.* as its card says."
        )
    return {name: state[name].to(value.dtype) for name, value in own.items()}


def graph_tensors(data: bytes, source: str) -> GraphTensors:
    """The weights in a graph.

    An export keeps names, except that it turns the matrices of linear layers, which lose their names thereby,
    and folds norms over the batch into the convolutions before them. A matrix is found again by the bias that
    is added to its product.

    Args:
        data: The content of an .onnx file.
        source: Where it comes from, for messages.

    Raises:
        InputError: It is no graph.
        MissingExtraError: onnx is not installed.
    """
    try:
        import onnx
        from onnx import numpy_helper
    except ImportError as error:
        raise MissingExtraError("onnx", "train", "Reading the weights of a model file") from error
    try:
        elsewhere = keeps_values_elsewhere(data)  # onnx would read these files
        model: Any = onnx.load_from_string(data)
        arrays = {} if elsewhere else {t.name: numpy_helper.to_array(t) for t in model.graph.initializer}
    except Exception as error:  # protobuf's DecodeError is not public
        raise InputError(f"'{source}' is not an ONNX file, or is damaged. Copy it again.") from error
    if elsewhere:
        raise InputError(
            f"'{source}' keeps weights in other files (ONNX external data), which are never read. Give a "
            "file that holds them all: export it again without external data."
        )
    for node in model.graph.node:  # stored in half or in bytes, see `half_storage` and `byte_storage`
        if node.op_type == "Cast" and node.input[0] in arrays:
            arrays[node.output[0]] = arrays[node.input[0]]
        elif node.op_type == "Mul" and node.input[1].endswith(SCALE) and set(node.input) <= arrays.keys():
            whole, scale = (arrays[name].astype(np.float32) for name in node.input)
            arrays[node.output[0]] = whole * scale
    products = {
        n.output[0]: arrays[n.input[1]].T
        for n in model.graph.node
        if n.op_type == "MatMul" and n.input[1] in arrays
    }
    for node in model.graph.node:  # in integers, see `row_products`
        if node.op_type == "MatMulInteger" and node.output[0].endswith(WHOLE):
            matrix = node.input[1]
            scales = arrays[matrix.removesuffix(STORED_IN_BYTES) + SCALE]
            made = arrays[matrix].astype(np.float32) * scales
            products[node.output[0].removesuffix(WHOLE)] = made.T
    for node in model.graph.node:
        if node.op_type != "Add":
            continue
        for product, bias in (node.input, reversed(node.input)):
            if product in products and bias in arrays and bias.endswith(".bias"):
                arrays[f"{bias.removesuffix('bias')}weight"] = products[product]
    named = {k: _tensor(v) for k, v in arrays.items() if v.dtype in (np.float16, np.float32)}
    return GraphTensors(named, tuple(_tensor(matrix) for matrix in products.values()))


def _tensor(value: np.ndarray) -> Tensor:
    return torch.from_numpy(np.array(value, dtype=np.float32, order="C"))
