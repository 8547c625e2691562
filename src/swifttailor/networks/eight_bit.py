"""Matrix products of an ONNX graph in 8 bits: half the time on a CPU, a quarter of the bytes."""

from __future__ import annotations

import tempfile
from pathlib import Path
from typing import Any

from swifttailor.networks.half_storage import FEWEST


def with_eight_bit_products(model: Any) -> Any:
    """Replaces products with constant matrices by products of integers.

    Each column of a matrix keeps a scale of its own and 7 bits, so that processors without instructions for
    dot products of bytes do not overflow. The other factor is rounded to 8 bits as it comes, by the range of
    its values *in the whole batch*: what one example gives depends on the others, a little.

    Args:
        model: onnx.ModelProto with its weights in float32.

    Returns:
        A new model.
    """
    import onnx
    from onnxruntime.quantization import QuantType, quantize_dynamic
    from onnxruntime.quantization.quant_utils import add_pre_process_metadata

    large = {t.name for t in model.graph.initializer if _size(t) >= FEWEST}
    left_alone = [
        node.name for node in model.graph.node if node.op_type == "MatMul" and node.input[1] not in large
    ]
    add_pre_process_metadata(model)  # says that shapes are known; there would be a warning without it
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "graph.onnx"
        quantize_dynamic(
            model,
            path,
            op_types_to_quantize=["MatMul"],
            nodes_to_exclude=left_alone,
            per_channel=True,
            reduce_range=True,
            weight_type=QuantType.QInt8,
            extra_options={"MatMulConstBOnly": True},
        )
        made = onnx.load(path)
    del made.metadata_props[:]
    return made


def _size(tensor: Any) -> int:
    size = 1
    for length in tensor.dims:
        size *= length
    return size
