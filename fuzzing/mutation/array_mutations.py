"""Damage to arrays in numpy's format: what the header announces, and the values."""

from __future__ import annotations

import io
import struct
from random import Random

import numpy as np

from fuzzing.mutation.byte_mutations import mutate_bytes

_KINDS = (
    "|b1",
    "|u1",
    "<i2",
    "<u2",
    "<i4",
    "<i8",
    "<f4",
    "<f8",
    ">f8",
    "|O",
    "<U8",
    "|S4",
    "<c16",
    "<M8[s]",
    "V3",
)
_LENGTHS = (0, 1, 2, -1, 7, 64, 10**6, 10**12, 2**31, 2**63)
_VALUES = (0, 1, -1, 255, 32767, 2**31 - 1, -(2**31), float("nan"), float("inf"), 1e30, -1e30, 1e-30)


def mutate_array(data: bytes, random: Random) -> bytes:
    """A damaged .npy file."""
    way = random.randrange(5)
    if way == 0:
        return mutate_bytes(data, random, 3)
    array = np.lib.format.read_array(io.BytesIO(data), allow_pickle=False)
    if way == 1:
        return _header(array, random) + array.tobytes()
    return array_file(_changed(array, random))


def _header(array: np.ndarray, random: Random) -> bytes:
    shape = [*array.shape] or [1]
    shape[random.randrange(len(shape))] = random.choice(_LENGTHS)
    if random.random() < 0.3:
        shape.append(random.choice(_LENGTHS))
    kind = random.choice(_KINDS) if random.random() < 0.5 else array.dtype.str
    text = f"{{'descr': '{kind}', 'fortran_order': {random.random() < 0.1}, 'shape': {tuple(shape)}, }}"
    if random.random() < 0.1:
        text = random.choice(("[" * 200, "{}", "__import__('os')", "{'descr': [('a', '<i4')]}", text * 3))
    raw = text.encode("latin-1") + b"\n"
    return b"\x93NUMPY\x01\x00" + struct.pack("<H", len(raw)) + raw


def _changed(array: np.ndarray, random: Random) -> np.ndarray:
    array = array.copy()
    way = random.randrange(6)
    if way == 0 and array.size:
        with np.errstate(all="ignore"):
            value = np.asarray(random.choice(_VALUES)).astype(array.dtype)
        start = random.randrange(array.size)
        array.reshape(-1)[start : start + random.choice((1, 1, 5, array.size))] = value
    elif way == 1:
        return array.astype(random.choice(("<i4", "<f8", "<f4", "|b1", "<u2")))
    elif way == 2:
        return array[: random.randrange(len(array) + 1)] if array.ndim else array
    elif way == 3:
        return np.concatenate([array, array[: random.randint(0, 3)]]) if array.ndim else array
    elif way == 4 and array.size:
        moved = np.roll(array, random.randint(-5, 5))
        return moved
    elif array.size:
        raw = bytearray(array.tobytes())
        for _ in range(random.randint(1, 8)):
            raw[random.randrange(len(raw))] = random.randrange(256)
        return np.frombuffer(bytes(raw), array.dtype).reshape(array.shape)
    return array


def array_file(array: np.ndarray) -> bytes:
    """The .npy file of an array."""
    out = io.BytesIO()
    np.lib.format.write_array(out, array, allow_pickle=False)
    return out.getvalue()
