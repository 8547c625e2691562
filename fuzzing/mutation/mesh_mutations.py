"""Damage to meshes: lines of OBJ, headers and bodies of PLY and STL, JSON and buffers of GLB."""

from __future__ import annotations

import json
import struct
from random import Random

from fuzzing.mutation.byte_mutations import mutate_bytes
from fuzzing.mutation.json_mutations import mutate_json, written

_WORDS = (
    "0 -1 1 99999999 -99999999 9999999999999999999999 nan inf -inf 1e308 1e400 1/1/1 1// /1 //1 1/2 f v vt l "
    "g o a \0 float int list uchar double property vertex face element 3 4 2147483648 "
    "-2147483649 usemtl mtllib # \\ ä"
).split(" ")


def mutate_mesh(data: bytes, ending: str, random: Random) -> bytes:
    """A damaged mesh of the same format."""
    if random.random() < 0.25:
        return mutate_bytes(data, random)
    if ending == ".glb":
        return _mutate_glb(data, random)
    if ending == ".ply" or (ending == ".stl" and not data.startswith(b"solid")):
        head, mark, body = (
            data.partition(b"end_header\n") if ending == ".ply" else (data[:84], b"", data[84:])
        )
        if random.random() < 0.6 and ending == ".ply":
            return _mutate_lines(head, random) + mark + body
        return head + mark + mutate_bytes(body, random, 10)
    return _mutate_lines(data, random)


def _mutate_lines(data: bytes, random: Random) -> bytes:
    lines = data.decode("utf-8", "replace").split("\n")
    for _ in range(random.randint(1, 4)):
        k = random.randrange(len(lines))
        words = lines[k].split(" ")
        way = random.randrange(6)
        if way == 0 and len(lines) > 1:
            del lines[k]
        elif way == 1:
            lines.insert(random.randrange(len(lines)), lines[k])
        elif way == 2:
            words.insert(random.randrange(len(words) + 1), random.choice(_WORDS))
            lines[k] = " ".join(words)
        elif way == 3:
            other = random.randrange(len(lines))
            lines[k], lines[other] = lines[other], lines[k]
        elif way == 4 and len(words) > 1:
            del words[random.randrange(len(words))]
            lines[k] = " ".join(words)
        else:
            words[random.randrange(len(words))] = random.choice(_WORDS)
            lines[k] = " ".join(words)
    return "\n".join(lines).encode("utf-8", "replace")


def _mutate_glb(data: bytes, random: Random) -> bytes:
    (length,) = struct.unpack("<I", data[12:16])
    document, rest = data[20 : 20 + length], data[20 + length :]
    way = random.random()
    if way < 0.7:
        document = written(mutate_json(json.loads(document), random), random)
    if way > 0.6:
        rest = rest[:8] + mutate_bytes(rest[8:], random, 8)
    document += b" " * (-len(document) % 4)
    whole = struct.pack("<I", len(document)) + data[16:20] + document + rest
    return data[:8] + struct.pack("<I", len(whole) + 12) + whole
