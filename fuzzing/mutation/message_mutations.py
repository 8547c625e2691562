"""Damage to protocol buffers, the format of ONNX files, field by field."""

from __future__ import annotations

import struct
from random import Random

from fuzzing.mutation.byte_mutations import mutate_bytes

_NUMBERS = (0, 1, 2, 7, 127, 128, 2**31 - 1, 2**31, 2**32, 2**63 - 1, 2**64 - 1, 2**64 - 2)
Field = tuple[int, int, bytes]
"""Number, kind on the wire, and content (of kind 0 the number itself, encoded)."""


def mutate_message(data: bytes, random: Random, most: int = 3) -> bytes:
    """A message in which fields, its own or those of messages inside, are damaged."""
    for _ in range(random.randint(1, most)):
        data = _mutated(data, random, 0)
    return data


def fields_of(data: bytes) -> list[Field] | None:
    """The fields of a message, or None where the bytes are none."""
    fields: list[Field] = []
    at = 0
    while at < len(data):
        key, at = _varint(data, at)
        number, kind = key >> 3, key & 7
        if at < 0 or number == 0:
            return None
        if kind == 0:
            start = at
            _, at = _varint(data, at)
            content = data[start:at] if at > 0 else b""
        elif kind == 2:
            size, at = _varint(data, at)
            content, at = data[at : at + size], at + size if at > 0 else -1
        elif kind in (1, 5):
            size = 8 if kind == 1 else 4
            content, at = data[at : at + size], at + size
        else:
            return None
        if not 0 <= at <= len(data):
            return None
        fields.append((number, kind, content))
    return fields


def message_of(fields: list[Field]) -> bytes:
    """The bytes of a message."""
    out = []
    for number, kind, content in fields:
        out.append(encoded(number << 3 | kind) + (encoded(len(content)) if kind == 2 else b"") + content)
    return b"".join(out)


def encoded(number: int) -> bytes:
    """A number of variable length."""
    out = bytearray()
    while True:
        out.append((number & 0x7F) | (0x80 if number > 0x7F else 0))
        number >>= 7
        if not number:
            return bytes(out)


def _mutated(data: bytes, random: Random, depth: int) -> bytes:
    fields = fields_of(data)
    if not fields:
        return mutate_bytes(data, random, 2)
    k = random.randrange(len(fields))
    number, kind, content = fields[k]
    if kind == 2 and content and depth < 8 and random.random() < 0.8:
        fields[k] = (number, kind, _mutated(content, random, depth + 1))
        return message_of(fields)
    way = random.randrange(6)
    if way == 0:
        del fields[k]
    elif way == 1:
        fields.insert(random.randrange(len(fields) + 1), fields[k])
    elif way == 2:
        fields[k] = (random.randint(1, 20), kind, content)
    elif kind == 0:
        fields[k] = (number, kind, encoded(random.choice(_NUMBERS)))
    elif kind == 2:
        fields[k] = (number, kind, mutate_bytes(content, random, 2))
    else:
        odd = struct.pack("<d", random.choice((0.0, float("nan"), 1e300, -1.0)))
        fields[k] = (number, kind, odd[: len(content)])
    return message_of(fields)


def _varint(data: bytes, at: int) -> tuple[int, int]:
    value = shift = 0
    while 0 <= at < len(data) and shift < 70:
        value |= (data[at] & 0x7F) << shift
        shift += 7
        at += 1
        if data[at - 1] < 0x80:
            return value, at
    return 0, -1
