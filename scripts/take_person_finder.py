"""The networks that find people in photographs: BlazePose's detector and cutter, of MediaPipe (Apache-2.0).

``pip download --no-deps mediapipe==0.10.14 && unzip mediapipe-*.whl``
``pip install tflite``
``python scripts/take_person_finder.py mediapipe/modules``

Writes src/swifttailor/picture_reader/person_finder.zip (--out): both graphs in ONNX, with the same weights.
Of the second network the mask, the certainty that somebody is there and the places of joints in the picture
are kept. Needs the extra ``train``.
"""

from __future__ import annotations

import argparse
import hashlib
import io
from collections.abc import Callable
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
import onnx  # noqa: TID253  this script is about nothing else
import tflite
from numpy.typing import NDArray
from onnx import TensorProto, helper, numpy_helper  # noqa: TID253

from swifttailor.networks.half_storage import store_in_half
from swifttailor.networks.model_file import write_archive
from swifttailor.picture_reader.person_finder import CUT, CUTTER, DETECT, DETECTOR, KIND, SHIPPED

FILES = {
    DETECTOR: ("pose_detection/pose_detection.tflite", DETECT, ("Identity", "Identity_1")),
    CUTTER: ("pose_landmark/pose_landmark_full.tflite", CUT, ("Identity_2", "Identity_1", "Identity")),
}
"""Of each graph its file, and which of its outputs become those of the graph."""
OPSET = 18
_TYPES = {0: np.float32, 1: np.float16, 2: np.int32}
_NAMES = {value: name for name, value in vars(tflite.BuiltinOperator).items() if isinstance(value, int)}
_ACTIVATIONS = {1: "Relu", 3: "Relu6"}
Values = NDArray[Any]


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("modules", type=Path, help="folder mediapipe/modules of the package")
    parser.add_argument("--out", type=Path, default=SHIPPED)
    options = parser.parse_args()
    members, sources = {}, {}
    for name, (file, signature, outputs) in FILES.items():
        data = (options.modules / file).read_bytes()
        members[f"{name}.onnx"] = Graph(data).converted(
            signature[0][0], dict(zip(outputs, signature[1], strict=True))
        )
        sources[name] = {"file": file, "sha256": hashlib.sha256(data).hexdigest()}
    card = {
        "model": "BlazePose, detector and full landmark network (Bazarevsky et al. 2020)",
        "from": "mediapipe 0.10.14 (PyPI), Google, Apache-2.0",
        "command": "python scripts/take_person_finder.py mediapipe/modules",
        "sources": sources,
        "training": "none of ours; the same weights",
    }
    write_archive(options.out, KIND, members, card, overwrite=True)
    print(f"{options.out}: {options.out.stat().st_size / 1e6:.1f} MB")


class Graph:
    """A TensorFlow Lite graph of pictures (1, h, w, c), to be written as an ONNX graph of (1, c, h, w)."""

    def __init__(self, data: bytes) -> None:
        self.model = tflite.Model.GetRootAsModel(data, 0)
        self.graph = self.model.Subgraphs(0)
        self.constants: dict[int, Values] = {}
        self.nodes: list[Any] = []
        self.weights: list[Any] = []

    def converted(self, given: str, made: dict[str, str]) -> bytes:
        """The content of an .onnx file.

        Args:
            given: What its input is called.
            made: Of the outputs that are kept, what they are called.
        """
        source = self.graph.Inputs(0)
        height, width = self.graph.Tensors(source).ShapeAsNumpy()[1:3]
        self.names = {source: given}
        for k in range(self.graph.OperatorsLength()):
            self._operator(self.graph.Operators(k), f"n{k}")
        outputs = []
        for k in range(self.graph.OutputsLength()):
            tensor = self.graph.Outputs(k)
            name = made.get(self.graph.Tensors(tensor).Name().decode())
            if name is not None:
                self.nodes.append(helper.make_node("Identity", [self.names[tensor]], [name]))
                outputs.append(helper.make_tensor_value_info(name, TensorProto.FLOAT, None))
        outputs.sort(key=lambda value: list(made.values()).index(value.name))
        shape = [1, 3, int(height), int(width)]
        inputs = [helper.make_tensor_value_info(given, TensorProto.FLOAT, shape)]
        graph = helper.make_graph(self.nodes, "graph", inputs, outputs, self.weights)
        model = helper.make_model(graph, opset_imports=[helper.make_opsetid("", OPSET)], ir_version=10)
        _keep_needed(model)
        model = onnx.shape_inference.infer_shapes(model)
        del model.graph.value_info[:]
        onnx.checker.check_model(model)
        store_in_half(model)
        buffer = io.BytesIO()
        onnx.save_model(model, buffer)
        return buffer.getvalue()

    def _operator(self, operator: Any, name: str) -> None:
        code = self.model.OperatorCodes(operator.OpcodeIndex())
        kind = _NAMES[max(code.BuiltinCode(), code.DeprecatedBuiltinCode())]
        given = [operator.Inputs(k) for k in range(operator.InputsLength())]
        out = operator.Outputs(0)
        if kind in ("DENSIFY", "DEQUANTIZE"):
            self.constants[out] = self._constant(given[0]).astype(np.float32)
            return
        handler: Callable[..., str] = getattr(self, f"_{kind.lower()}")
        self.names[out] = handler(operator, given, name)

    def _constant(self, tensor: int) -> Values:
        if tensor not in self.constants:
            found = self.graph.Tensors(tensor)
            data = self.model.Buffers(found.Buffer()).DataAsNumpy()
            values = np.frombuffer(data.tobytes(), _TYPES[found.Type()])
            sparsity = found.Sparsity()
            shape = tuple(int(n) for n in found.ShapeAsNumpy())
            self.constants[tensor] = (
                values.reshape(shape) if sparsity is None else dense(values, shape, sparsity)
            )
        return self.constants[tensor]

    def _value(self, tensor: int) -> str:
        """The name of a tensor, which becomes a weight, channels first, where it is a constant."""
        if tensor in self.names:
            return self.names[tensor]
        values = self._constant(tensor)
        return self._weight(np.moveaxis(values, -1, 1) if values.ndim == 4 else values, f"w{tensor}")

    def _weight(self, values: Values, name: str) -> str:
        if name not in {one.name for one in self.weights}:
            self.weights.append(numpy_helper.from_array(np.ascontiguousarray(values), name))
        return name

    def _node(self, kind: str, inputs: list[str], name: str, **more: Any) -> str:
        self.nodes.append(helper.make_node(kind, inputs, [name], **more))
        return name

    def _activated(self, which: int, name: str) -> str:
        if which == 0:
            return name
        if _ACTIVATIONS[which] == "Relu":
            return self._node("Relu", [name], f"{name}.relu")
        bounds = [self._weight(np.float32(v), f"bound{v}") for v in (0, 6)]
        return self._node("Clip", [name, *bounds], f"{name}.relu6")

    def _conv_2d(self, operator: Any, given: list[int], name: str) -> str:
        options = _options(operator, tflite.Conv2DOptions)
        kernel = self._constant(given[1]).transpose(0, 3, 1, 2)
        return self._convolved(options, given, kernel, 1, name)

    def _depthwise_conv_2d(self, operator: Any, given: list[int], name: str) -> str:
        options = _options(operator, tflite.DepthwiseConv2DOptions)
        kernel = self._constant(given[1]).transpose(3, 0, 1, 2)
        return self._convolved(options, given, kernel, len(kernel), name)

    def _convolved(self, options: Any, given: list[int], kernel: Values, groups: int, name: str) -> str:
        assert options.DilationHFactor() == options.DilationWFactor() == 1
        weight = self._weight(kernel, f"w{given[1]}")
        bias = self._weight(self._constant(given[2]), f"w{given[2]}")
        made = self._node(
            "Conv",
            [self._value(given[0]), weight, bias],
            name,
            group=groups,
            strides=[options.StrideH(), options.StrideW()],
            auto_pad="SAME_UPPER" if options.Padding() == tflite.Padding.SAME else "VALID",
        )
        return self._activated(options.FusedActivationFunction(), made)

    def _add(self, operator: Any, given: list[int], name: str) -> str:
        made = self._node("Add", [self._value(one) for one in given], name)
        return self._activated(_options(operator, tflite.AddOptions).FusedActivationFunction(), made)

    def _max_pool_2d(self, operator: Any, given: list[int], name: str) -> str:
        options = _options(operator, tflite.Pool2DOptions)
        return self._node(
            "MaxPool",
            [self._value(given[0])],
            name,
            kernel_shape=[options.FilterHeight(), options.FilterWidth()],
            strides=[options.StrideH(), options.StrideW()],
            auto_pad="SAME_UPPER" if options.Padding() == tflite.Padding.SAME else "VALID",
        )

    def _pad(self, operator: Any, given: list[int], name: str) -> str:
        around = self._constant(given[1])[[0, 3, 1, 2]]
        pads = self._weight(np.concatenate([around[:, 0], around[:, 1]]).astype(np.int64), f"{name}.pads")
        return self._node("Pad", [self._value(given[0]), pads], name)

    def _resize_bilinear(self, operator: Any, given: list[int], name: str) -> str:
        options = _options(operator, tflite.ResizeBilinearOptions)
        way = (
            "half_pixel"
            if options.HalfPixelCenters()
            else "align_corners"
            if options.AlignCorners()
            else "asymmetric"
        )
        height, width = self._constant(given[1])
        channels = int(self.graph.Tensors(given[0]).ShapeAsNumpy()[3])
        sizes = self._weight(np.array([1, channels, height, width], np.int64), f"{name}.sizes")
        inputs = [self._value(given[0]), "", "", sizes]
        return self._node("Resize", inputs, name, mode="linear", coordinate_transformation_mode=way)

    def _depth_to_space(self, operator: Any, given: list[int], name: str) -> str:
        size = _options(operator, tflite.DepthToSpaceOptions).BlockSize()
        return self._node("DepthToSpace", [self._value(given[0])], name, blocksize=size, mode="DCR")

    def _reshape(self, operator: Any, given: list[int], name: str) -> str:
        turned = self._node("Transpose", [self._value(given[0])], f"{name}.last", perm=[0, 2, 3, 1])
        shape = self.graph.Tensors(operator.Outputs(0)).ShapeAsNumpy().astype(np.int64)
        return self._node("Reshape", [turned, self._weight(shape, f"{name}.shape")], name)

    def _concatenation(self, operator: Any, given: list[int], name: str) -> str:
        axis = _options(operator, tflite.ConcatenationOptions).Axis()
        assert len(self.graph.Tensors(given[0]).ShapeAsNumpy()) == 3, "only what was reshaped is joined"
        return self._node("Concat", [self._value(one) for one in given], name, axis=axis)

    def _logistic(self, operator: Any, given: list[int], name: str) -> str:
        return self._node("Sigmoid", [self._value(given[0])], name)


def dense(values: Values, shape: tuple[int, ...], sparsity: Any) -> Values:
    """All values of a tensor of which the file keeps those that are not zero (TensorFlow Lite's format).

    Args:
        values: That are kept, in the order of the levels.
        shape: Of the tensor.
        sparsity: Of each axis whether all of its places are there, or a list of those that are kept.
    """
    assert not sparsity.BlockMapLength(), "no file has blocks"
    assert list(sparsity.TraversalOrderAsNumpy()) == list(range(len(shape)))
    places: list[tuple[int, ...]] = [()]
    for k in range(sparsity.DimMetadataLength()):
        level = sparsity.DimMetadata(k)
        if level.Format() == tflite.DimensionType.DENSE:
            places = [(*place, index) for place in places for index in range(level.DenseSize())]
        else:
            starts = _listed(level.ArraySegmentsType(), level.ArraySegments())
            kept = _listed(level.ArrayIndicesType(), level.ArrayIndices())
            runs = zip(places, pairwise(starts), strict=True)
            places = [(*place, int(index)) for place, (a, b) in runs for index in kept[a:b]]
    found = np.zeros(shape, values.dtype)
    found[tuple(np.array(places).T)] = values
    return found


def _listed(kind: int, table: Any) -> Values:
    vector = (tflite.Int32Vector, tflite.Uint16Vector, tflite.Uint8Vector)[kind - 1]()
    vector.Init(table.Bytes, table.Pos)
    return vector.ValuesAsNumpy()


def _options(operator: Any, kind: Any) -> Any:
    options = kind()
    table = operator.BuiltinOptions()
    options.Init(table.Bytes, table.Pos)
    return options


def _keep_needed(model: Any) -> None:
    """Takes out what no output needs."""
    needed = {one.name for one in model.graph.output}
    kept = []
    for node in reversed(model.graph.node):
        if needed & set(node.output):
            kept.append(node)
            needed.update(node.input)
    weights = [one for one in model.graph.initializer if one.name in needed]
    del model.graph.node[:], model.graph.initializer[:]
    model.graph.node.extend(reversed(kept))
    model.graph.initializer.extend(weights)


if __name__ == "__main__":
    main()
