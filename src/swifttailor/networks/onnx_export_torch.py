"""Writing networks of torch as ONNX graphs. Import this in the function that needs it: it loads torch."""

from __future__ import annotations

import io
import logging
import warnings
from collections.abc import Sequence
from typing import Any

import torch

from swifttailor.errors import MissingExtraError
from swifttailor.networks.byte_storage import store_in_bytes
from swifttailor.networks.eight_bit import with_eight_bit_products
from swifttailor.networks.half_storage import store_in_half
from swifttailor.networks.row_products import with_row_products

OPSET, OPSET_WITH_GELU = 18, 20


def export_graph(
    network: torch.nn.Module,
    example: tuple[torch.Tensor, ...],
    shapes: tuple[Any, ...],
    inputs: Sequence[str],
    outputs: Sequence[str],
    *,
    int8: bool = False,
    row_products: bool = False,
) -> bytes:
    """Writes a network as an ONNX graph without traces of where it was made.

    Args:
        network: In evaluation mode.
        example: Its inputs.
        shapes: Of each input, its axes whose size may change, as `torch.onnx.export` wants them.
        inputs: Names of the inputs.
        outputs: Names of the outputs.
        int8: Whether products with its matrices are of 8 bits (`with_eight_bit_products`).
        row_products: Whether products with its matrices, rounded to bytes before, are of 8 bits, each row of
            the other factor with a scale of its own (`with_row_products`).

    Returns:
        The content of an .onnx file.

    Raises:
        MissingExtraError: onnx or onnxscript is not installed.
    """
    try:
        import onnx
        import onnxscript  # noqa: F401  what torch exports with
    except ImportError as error:
        raise MissingExtraError(error.name or "onnx", "train", "Writing a model file") from None
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # of torch's own code, about itself
        for noisy in ("onnxscript", "onnx_ir", "torch.onnx"):
            logging.getLogger(noisy).setLevel(logging.ERROR)
        program = torch.onnx.export(
            network,
            example,
            dynamo=True,
            external_data=False,
            opset_version=OPSET_WITH_GELU if row_products else OPSET,
            input_names=list(inputs),
            output_names=list(outputs),
            dynamic_shapes=shapes,
            verbose=False,
        )
    assert program is not None
    model = program.model_proto
    _forget_origins(model)
    _rename_weights(model, {*inputs, *outputs})
    if int8:
        model = with_eight_bit_products(model)
    if row_products:
        model = with_row_products(model)
    store_in_bytes(model)
    store_in_half(model)
    buffer = io.BytesIO()
    onnx.save_model(model, buffer)
    return buffer.getvalue()


def _forget_origins(model: Any) -> None:
    """Takes out where in the source each part comes from: paths, and most of a small file."""
    graph = model.graph
    for part in (*graph.node, *graph.value_info, *graph.input, *graph.output, *graph.initializer, graph):
        part.ClearField("metadata_props")
        part.ClearField("doc_string")


def _rename_weights(model: Any, taken: set[str]) -> None:
    """Gives weights with the name of an input or output another one; torch keeps them apart, ONNX cannot."""
    names = {t.name: f"{t.name}.weight" for t in model.graph.initializer if t.name in taken}
    for tensor in model.graph.initializer:
        tensor.name = names.get(tensor.name, tensor.name)
    made: set[str] = set()
    for node in model.graph.node:  # in an order in which they can be computed
        for k, name in enumerate(node.input):
            if name in names and name not in made:
                node.input[k] = names[name]
        made.update(node.output)
