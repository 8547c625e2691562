"""Damage to picture files part by part, checksums made right again, so that it gets past the first look."""

from __future__ import annotations

import struct
import zlib
from random import Random

from fuzzing.mutation.byte_mutations import mutate_bytes

_SIZES = (0, 1, 2, 7, 255, 65535, 65536, 100_000, 2**31 - 1, 2**31, 2**32 - 1)
_PNG_KINDS = (
    b"IHDR",
    b"PLTE",
    b"IDAT",
    b"IEND",
    b"tRNS",
    b"zTXt",
    b"iTXt",
    b"iCCP",
    b"eXIf",
    b"acTL",
    b"fcTL",
    b"gAMA",
)
_BOMB = zlib.compress(bytes(20_000_000), 9)


def mutate_picture(data: bytes, random: Random) -> bytes:
    """A damaged picture of the same format."""
    if random.random() < 0.3:
        return mutate_bytes(data, random)
    if data.startswith(b"\x89PNG"):
        return _mutate_png(data, random)
    if data.startswith(b"\xff\xd8"):
        return _mutate_jpeg(data, random)
    if data.startswith(b"RIFF"):
        return _mutate_webp(data, random)
    return mutate_bytes(data, random, 12)


def _mutate_png(data: bytes, random: Random) -> bytes:
    chunks, at = [], 8
    while at + 8 <= len(data):
        (size,) = struct.unpack(">I", data[at : at + 4])
        chunks.append((data[at + 4 : at + 8], data[at + 8 : at + 8 + size]))
        at += 12 + size
    for _ in range(random.randint(1, 3)):
        k = random.randrange(len(chunks))
        kind, body = chunks[k]
        way = random.randrange(8)
        if way == 0:
            chunks[k] = (kind, mutate_bytes(body, random, 2))
        elif way == 1 and len(chunks) > 1:
            del chunks[k]
        elif way == 2:
            chunks.insert(random.randrange(len(chunks) + 1), chunks[k])
        elif way == 3:
            chunks[k] = (random.choice(_PNG_KINDS), body)
        elif way == 4:
            chunks[0] = (chunks[0][0], _png_header(random))
        elif way == 5:
            chunks.insert(1, (random.choice((b"zTXt", b"iCCP")), b"a\x00\x00" + _BOMB))
        elif way == 6:
            chunks = [(c, _other_pixels(b, random) if c == b"IDAT" else b) for c, b in chunks]
        else:
            chunks.insert(1, (random.choice(_PNG_KINDS), random.randbytes(random.choice((0, 1, 26, 768)))))
    out = data[:8]
    for kind, body in chunks:
        crc = zlib.crc32(kind + body) if random.random() < 0.98 else 0
        out += struct.pack(">I", len(body)) + kind + body + struct.pack(">I", crc)
    return out


def _png_header(random: Random) -> bytes:
    width, height = (random.choice((*_SIZES, 8, 16, 24)) for _ in range(2))
    return struct.pack(
        ">IIBBBBB",
        width,
        height,
        random.choice((1, 2, 4, 8, 16, 3)),
        random.choice((0, 2, 3, 4, 6, 5)),
        random.choice((0, 0, 0, 1)),
        random.choice((0, 0, 0, 7)),
        random.choice((0, 1, 2)),
    )


def _other_pixels(body: bytes, random: Random) -> bytes:
    try:
        pixels = zlib.decompress(body)
    except zlib.error:
        return body
    return zlib.compress(mutate_bytes(pixels, random, 4))


def _mutate_jpeg(data: bytes, random: Random) -> bytes:
    segments, at = [], 2
    while at + 4 <= len(data) and data[at] == 0xFF and data[at + 1] != 0xDA:
        (size,) = struct.unpack(">H", data[at + 2 : at + 4])
        segments.append((data[at + 1], data[at + 4 : at + 2 + size]))
        at += 2 + size
    scan = data[at:]
    for _ in range(random.randint(1, 3)):
        if not segments:
            break
        k = random.randrange(len(segments))
        marker, body = segments[k]
        way = random.randrange(7)
        if way == 0:
            segments[k] = (marker, mutate_bytes(body, random, 2))
        elif way == 1:
            del segments[k]
        elif way == 2:
            segments.insert(random.randrange(len(segments) + 1), segments[k])
        elif way == 3:
            segments[k] = (random.randrange(0xC0, 0x100), body)
        elif way == 4 and 0xC0 <= marker <= 0xC2:
            height, width = (random.choice(_SIZES[:6]) for _ in range(2))
            segments[k] = (marker, body[:1] + struct.pack(">HH", height, width) + body[5:])
        elif way == 5:
            exif = b"Exif\x00\x00II*\x00\x08\x00\x00\x00" + random.randbytes(random.choice((0, 14, 60)))
            segments.insert(0, (0xE1, exif))
        else:
            scan = mutate_bytes(scan, random, 4)
    out = data[:2]
    for marker, body in segments:
        out += struct.pack(">BBH", 0xFF, marker, min(len(body) + 2, 65535)) + body
    return out + scan


def _mutate_webp(data: bytes, random: Random) -> bytes:
    chunks, at = [], 12
    while at + 8 <= len(data):
        (size,) = struct.unpack("<I", data[at + 4 : at + 8])
        chunks.append((data[at : at + 4], data[at + 8 : at + 8 + size]))
        at += 8 + size + size % 2
    for _ in range(random.randint(1, 3)):
        k = random.randrange(len(chunks))
        kind, body = chunks[k]
        way = random.randrange(4)
        if way == 0:
            chunks[k] = (kind, mutate_bytes(body, random, 3))
        elif way == 1:
            chunks.insert(random.randrange(len(chunks) + 1), chunks[k])
        elif way == 2:
            chunks[k] = (
                random.choice((b"VP8 ", b"VP8L", b"VP8X", b"ALPH", b"ANIM", b"ANMF", b"EXIF", b"ICCP")),
                body,
            )
        else:
            sides = b"".join(
                (random.choice((0, 15, 16383, 2**24 - 1))).to_bytes(3, "little") for _ in range(2)
            )
            chunks.insert(0, (b"VP8X", bytes([random.randrange(256), 0, 0, 0]) + sides))
    body = b"".join(k + struct.pack("<I", len(b)) + b + b"\0" * (len(b) % 2) for k, b in chunks)
    return b"RIFF" + struct.pack("<I", (len(body) + 4) & 0xFFFFFFFF) + b"WEBP" + body
