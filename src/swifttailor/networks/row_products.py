"""Matrix products of an ONNX graph in 8 bits, exact in the matrices: half the time on a CPU.

`eight_bit` rounds all rows of the other factor by one range. A sentence encoder is read worse so: a few of
its values are ten times as large as the rest, in some words and not in others. Here each row, which is a word
of a text, has a scale of its own, and what a text gives depends on nothing that is read beside it.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from swifttailor.networks.byte_storage import SCALE, STORED, matrix_in_bytes

WHOLE = ".integers"
"""Added to the name of a product for that of the integers before they are scaled."""
_ZERO, _LARGEST = 128, 127
"""Of a factor that is as often below zero as above: what stands for zero, and its reach above it."""
_ZERO_OF_BENT, _LARGEST_OF_BENT = 32, 223
"""Of one that is hardly below zero, as a GELU gives it: the least is -0.17, and rows mostly reach 1.2."""


def with_row_products(model: Any) -> Any:
    """Replaces products with matrices that bytes hold exactly by products of integers.

    Nothing of a matrix is rounded here: others stay as they are. Round them before (`round_to_bytes`).

    Args:
        model: onnx.ModelProto with its weights in float32, changed in place.

    Returns:
        The same model.
    """
    from onnx import numpy_helper

    graph = model.graph
    found = {t.name: matrix_in_bytes(numpy_helper.to_array(t)) for t in graph.initializer if len(t.dims) == 2}
    uses = [name for node in graph.node for name in node.input]
    exact = {
        node.input[1]: both
        for node in graph.node
        if node.op_type == "MatMul" and uses.count(node.input[1]) == 1
        if (both := found.get(node.input[1])) is not None
    }
    bent = {node.output[0] for node in graph.node if node.op_type == "Gelu"}
    nodes: list[Any] = []
    rounded: set[str] = set()
    for node in graph.node:
        if node.op_type != "MatMul" or node.input[1] not in exact:
            nodes.append(node)
            continue
        factor, matrix = node.input
        which = _BENT if factor in bent else _EVEN
        if factor not in rounded:
            rounded.add(factor)
            nodes += _rounding(factor, which)
        nodes += _product(factor, matrix, node.output[0], which)
    stored = [_tensor(name + end, part) for name, both in exact.items() for end, part in _parts(both)]
    kept = [tensor for tensor in graph.initializer if tensor.name not in exact]
    for part, content in ((graph.node, nodes), (graph.initializer, [*kept, *stored, *_constants()])):
        del part[:]
        part.extend(content)
    return model


_EVEN, _BENT = "rows.even", "rows.bent"
_ONE, _AXIS = "rows.one", "rows.axis"


def _constants() -> list[Any]:
    return [
        _tensor(f"{_EVEN}.zero", np.array(_ZERO, np.uint8)),
        _tensor(f"{_EVEN}.step", np.array(1 / _LARGEST, np.float32)),
        _tensor(f"{_BENT}.zero", np.array(_ZERO_OF_BENT, np.uint8)),
        _tensor(f"{_BENT}.step", np.array(1 / _LARGEST_OF_BENT, np.float32)),
        _tensor(_ONE, np.array(1, np.float32)),
        _tensor(_AXIS, np.array([-1], np.int64)),
    ]


def _rounding(factor: str, which: str) -> list[Any]:
    """Rounds each row of a factor by its largest value; a row of zeros gives zeros, times a scale of zero."""
    from onnx import helper

    size, most, scale, steps = (f"{factor}.{each}" for each in ("size", "most", "scale", "steps"))
    return [
        helper.make_node("Abs", [factor], [size]),
        helper.make_node("ReduceMax", [size, _AXIS], [most], keepdims=1),
        helper.make_node("Mul", [most, f"{which}.step"], [scale]),
        helper.make_node("Div", [factor, scale], [steps]),
        helper.make_node("QuantizeLinear", [steps, _ONE, f"{which}.zero"], [f"{factor}.rounded"]),
    ]


def _product(factor: str, matrix: str, made: str, which: str) -> list[Any]:
    from onnx import TensorProto, helper

    counted, columns = f"{made}.counted", f"{made}.columns"
    given = [f"{factor}.rounded", matrix + STORED, f"{which}.zero"]
    return [
        helper.make_node("MatMulInteger", given, [made + WHOLE]),
        helper.make_node("Cast", [made + WHOLE], [counted], to=TensorProto.FLOAT),
        helper.make_node("Mul", [counted, matrix + SCALE], [columns]),
        helper.make_node("Mul", [columns, f"{factor}.scale"], [made]),
    ]


def _parts(both: tuple[NDArray[np.int8], NDArray[np.float32]]) -> list[tuple[str, NDArray[Any]]]:
    return [(STORED, both[0]), (SCALE, both[1])]


def _tensor(name: str, values: NDArray[Any]) -> Any:
    from onnx import numpy_helper

    return numpy_helper.from_array(values, name)
