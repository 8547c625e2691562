"""Damage to bytes whose meaning is not known."""

from __future__ import annotations

import struct
from random import Random

_ODD_BYTES = (0x00, 0x01, 0x7F, 0x80, 0xFF, 0x20, 0x0A, 0x22, 0x2D, 0x39)
_ODD_NUMBERS = (0, 1, 2, 0x7F, 0x80, 0xFF, 0x100, 0x7FFF, 0x8000, 0xFFFF, 0x7FFFFFFF, 0x80000000, 0xFFFFFFFF)
_ODD_LONG = (0, 1, 2**31, 2**32, 2**40, 2**62, 2**63 - 1, 2**63, 2**64 - 1)
_ODD_FLOATS = (float("nan"), float("inf"), float("-inf"), 0.0, -0.0, 1e30, -1e30, 1e-40)
_LONGEST = 1 << 20


def mutate_bytes(data: bytes, random: Random, most: int = 6) -> bytes:
    """`data` with one to `most` pieces of damage."""
    for _ in range(random.randint(1, most)):
        data = random.choice(_WAYS)(data, random)
    return data[:_LONGEST]


def _change(data: bytes, random: Random) -> bytes:
    return _written(
        data, random, bytes([random.choice(_ODD_BYTES) if random.random() < 0.5 else _any(random)])
    )


def _flip(data: bytes, random: Random) -> bytes:
    if not data:
        return data
    at = random.randrange(len(data))
    return data[:at] + bytes([data[at] ^ (1 << random.randrange(8))]) + data[at + 1 :]


def _number(data: bytes, random: Random) -> bytes:
    order = random.choice("<>")
    kind = random.randrange(4)
    if kind == 0:
        return _written(data, random, struct.pack(f"{order}H", random.choice(_ODD_NUMBERS) & 0xFFFF))
    if kind == 1:
        return _written(data, random, struct.pack(f"{order}I", random.choice(_ODD_NUMBERS)))
    if kind == 2:
        return _written(data, random, struct.pack(f"{order}Q", random.choice(_ODD_LONG)))
    return _written(data, random, struct.pack(f"{order}f", random.choice(_ODD_FLOATS)))


def _cut(data: bytes, random: Random) -> bytes:
    return data[: random.randrange(len(data) + 1)]


def _without(data: bytes, random: Random) -> bytes:
    start, end = _span(data, random)
    return data[:start] + data[end:]


def _again(data: bytes, random: Random) -> bytes:
    start, end = _span(data, random)
    return data[:end] + data[start:end] * random.choice((1, 1, 2, 20)) + data[end:]


def _moved(data: bytes, random: Random) -> bytes:
    start, end = _span(data, random)
    rest = data[:start] + data[end:]
    at = _place(rest, random)
    return rest[:at] + data[start:end] + rest[at:]


def _noise(data: bytes, random: Random) -> bytes:
    at = _place(data, random)
    return data[:at] + random.randbytes(random.choice((1, 2, 4, 16, 64))) + data[at:]


def _zeros(data: bytes, random: Random) -> bytes:
    start, end = _span(data, random)
    return data[:start] + bytes([random.choice(_ODD_BYTES)]) * (end - start) + data[end:]


def _written(data: bytes, random: Random, new: bytes) -> bytes:
    at = _place(data, random)
    return data[:at] + new + data[at + len(new) :]


def _place(data: bytes, random: Random) -> int:
    """Anywhere; half of the time near the front, where headers are."""
    return random.randint(0, min(len(data), 200) if random.random() < 0.5 else len(data))


def _span(data: bytes, random: Random) -> tuple[int, int]:
    start = _place(data, random)
    return start, min(len(data), start + random.choice((1, 2, 4, 8, 32, 256, len(data))))


def _any(random: Random) -> int:
    return random.randrange(256)


_WAYS = (_change, _change, _flip, _flip, _number, _number, _cut, _without, _again, _moved, _noise, _zeros)
