"""A quarter of the bytes for weights of an ONNX graph: stored as int8 with scales, computed as float32."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from swifttailor.networks.half_storage import FEWEST

STORED, SCALE = ".byte", ".scale"
"""Added to the name of a weight for what it is stored in."""
_MOST = 127
_APART = 1e-3
"""Of a step: as far as a weight may be from a multiple of its scale."""


def store_in_bytes(model: Any) -> int:
    """Stores in int8 the weights that are whole multiples of a scale along one axis.

    Nothing is rounded here: other tensors stay as they are. Round the weights before (`round_to_bytes`). A
    Cast and a Mul give the graph its float32 again; onnxruntime computes them once, when it opens the graph.

    Args:
        model: onnx.ModelProto, changed in place.

    Returns:
        How many tensors are stored so.
    """
    from onnx import TensorProto, helper, numpy_helper

    made, scales = [], []
    for tensor in model.graph.initializer:
        if tensor.data_type != TensorProto.FLOAT:
            continue
        found = _in_bytes(numpy_helper.to_array(tensor))
        if found is None:
            continue
        name = tensor.name
        tensor.CopyFrom(numpy_helper.from_array(found[0], name + STORED))
        scales.append(numpy_helper.from_array(found[1], name + SCALE))
        whole = f"{name}.whole"
        made.append(helper.make_node("Cast", [name + STORED], [whole], to=TensorProto.FLOAT))
        made.append(helper.make_node("Mul", [whole, name + SCALE], [name]))
    nodes = [*made, *model.graph.node]
    del model.graph.node[:]
    model.graph.node.extend(nodes)
    model.graph.initializer.extend(scales)
    return len(scales)


def round_to_bytes(network: Any) -> None:
    """Rounds the matrices of a torch network to 255 steps each row, in place; small ones and vectors stay."""
    import torch

    with torch.no_grad():
        for weight in network.parameters():
            if weight.ndim < 2 or weight.numel() < FEWEST:
                continue
            scale = weight.abs().amax(dim=tuple(range(1, weight.ndim)), keepdim=True) / _MOST
            scale = torch.where(scale > 0, scale, torch.ones_like(scale))
            weight.copy_(torch.round(weight / scale) * scale)


def matrix_in_bytes(values: NDArray[Any]) -> tuple[NDArray[np.int8], NDArray[np.float32]] | None:
    """A matrix as whole numbers and a scale for each column; None where it is no such product.

    Args:
        values: (k, n).

    Returns:
        (k, n) and (n,).
    """
    found = None if values.dtype != np.float32 else _in_bytes(values, axes=(1,))
    return None if found is None else (found[0], found[1][0])


def _in_bytes(
    values: NDArray[Any], axes: Sequence[int] | None = None
) -> tuple[NDArray[np.int8], NDArray[np.float32]] | None:
    """Whole numbers and what they are multiplied with; None where no axis has such scales.

    Exports turn matrices around, so the axis may be any.
    """
    if values.ndim < 2 or values.size < FEWEST:
        return None
    for axis in range(values.ndim) if axes is None else axes:
        others = tuple(k for k in range(values.ndim) if k != axis)
        scale = np.abs(values).max(axis=others, keepdims=True).astype(np.float32) / _MOST
        steps = values / np.where(scale > 0, scale, 1)
        whole = np.round(steps)
        if np.isfinite(steps).all() and np.abs(steps - whole).max() < _APART:
            return whole.astype(np.int8), scale
    return None
