"""What is in an ONNX file, found out before anything is done with it (onnx.proto in github.com/onnx/onnx).

Only the framing of protobuf messages is read: which fields there are, not what most of them hold.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import count

BUILT_IN = frozenset({"", "ai.onnx", "ai.onnx.ml", "com.microsoft"})
"""Sets of operators that onnxruntime comes with; any other needs a library of somebody's."""
_VARINT, _EIGHT, _TEXT, _FOUR = 0, 1, 2, 5
_MODEL_OPSETS, _OPSET_DOMAIN = 8, 1
_EXTERNAL_DATA, _DATA_LOCATION = 13, 14
MAX_FIELDS = 200_000
"""Fields looked at in one file: our networks have some 5,000; damaged weights can pass for millions."""
# What can hold a tensor, message by message: the numbers of the fields, and the message that each is.
_HOLDS = {
    "model": {7: "graph", 20: "training", 25: "function"},
    "training": {1: "graph", 2: "graph"},
    "graph": {1: "node", 5: "tensor", 15: "sparse"},
    "function": {7: "node", 11: "attribute"},
    "node": {5: "attribute"},
    "attribute": {5: "tensor", 10: "tensor", 6: "graph", 11: "graph", 22: "sparse", 23: "sparse"},
    "sparse": {1: "tensor", 2: "tensor"},
    "tensor": {},
}


def foreign_operators(content: bytes) -> frozenset[str]:
    """Names of the sets of operators that a model uses and onnxruntime does not have.

    Raises:
        ValueError: It is no protobuf message, or one of more than `MAX_FIELDS` fields.
    """
    used: set[str] = set()
    counted = count(1)
    for number, part in _fields(memoryview(content), counted):
        if number == _MODEL_OPSETS:
            names = [bytes(name) for field, name in _fields(part, counted) if field == _OPSET_DOMAIN]
            used.add(names[-1].decode(errors="replace") if names else "")
    return frozenset(used) - BUILT_IN


def keeps_values_elsewhere(content: bytes) -> bool:
    """Whether any tensor of a model, wherever it stands, has its values in another file.

    Raises:
        ValueError: It is no protobuf message, or one of more than `MAX_FIELDS` fields.
    """
    waiting = [("model", memoryview(content))]
    counted = count(1)
    while waiting:
        kind, message = waiting.pop()
        for number, part in _fields(message, counted):
            if kind == "tensor" and (number == _EXTERNAL_DATA or (number == _DATA_LOCATION and any(part))):
                return True
            inner = _HOLDS[kind].get(number)
            if inner is not None:
                waiting.append((inner, part))
    return False


def _fields(message: memoryview, counted: Iterator[int]) -> Iterator[tuple[int, memoryview]]:
    """Number and content of each field: of a text or message its bytes, of a number those it is written with.

    Args:
        message: What follows the message's own tag and length.
        counted: Numbers the fields of the whole file.

    Raises:
        ValueError: The message ends in the middle of a field, or has one of an unknown kind, or there
            have been more than `MAX_FIELDS`.
    """
    place = 0
    while place < len(message):
        if next(counted) > MAX_FIELDS:
            raise ValueError(f"more than {MAX_FIELDS} fields")
        tag, place = _number(message, place)
        number, kind = tag >> 3, tag & 7
        start = place
        if kind == _VARINT:
            value, place = _number(message, place)
            yield number, memoryview(value.to_bytes(10, "little"))
            continue
        if kind == _TEXT:
            length, start = _number(message, place)
            place = start + length
        elif kind in (_EIGHT, _FOUR):
            place += 8 if kind == _EIGHT else 4
        else:
            raise ValueError(f"a field of kind {kind}")
        if place > len(message):
            raise ValueError("a field that ends behind the end")
        yield number, message[start:place]


def _number(message: memoryview, place: int) -> tuple[int, int]:
    """A number of seven bits a byte, and where it ends."""
    value = 0
    for k in range(10):
        if place + k >= len(message):
            break
        value |= (message[place + k] & 127) << 7 * k
        if message[place + k] < 128:
            return value, place + k + 1
    raise ValueError("a number without an end")
