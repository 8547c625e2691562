"""Half the bytes for weights of an ONNX graph: stored as float16, computed as float32."""

from __future__ import annotations

from typing import Any

import numpy as np

FEWEST = 256
"""Smaller tensors are left alone."""


def store_in_half(model: Any) -> int:
    """Stores in float16 what float16 holds exactly; a Cast gives the graph its float32 again.

    Nothing is rounded here: tensors with values that float16 lacks stay as they are. Round the weights before
    (`round_to_half`). onnxruntime casts once, when it opens the graph.

    Args:
        model: onnx.ModelProto, changed in place.

    Returns:
        How many tensors are stored so.
    """
    from onnx import TensorProto, helper, numpy_helper

    casts = []
    for tensor in model.graph.initializer:
        if tensor.data_type != TensorProto.FLOAT:
            continue
        values = numpy_helper.to_array(tensor)
        with np.errstate(over="ignore"):
            half = values.astype(np.float16)
        if values.size < FEWEST or not np.array_equal(half.astype(np.float32), values):
            continue
        name = tensor.name
        tensor.CopyFrom(numpy_helper.from_array(half, f"{name}.half"))
        casts.append(helper.make_node("Cast", [f"{name}.half"], [name], to=TensorProto.FLOAT))
    nodes = [*casts, *model.graph.node]
    del model.graph.node[:]
    model.graph.node.extend(nodes)
    return len(casts)


def round_to_half(network: Any) -> None:
    """Rounds all weights of a torch network to float16, in place; those too large for it are left alone."""
    import torch

    with torch.no_grad():
        for weight in network.parameters():
            half = weight.half().float()
            weight.copy_(torch.where(torch.isfinite(half), half, weight))
