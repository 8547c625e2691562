"""PNG files of drawn pictures; other pictures are read and written by Pillow, which takes longer to load."""

from __future__ import annotations

import struct
import zlib

import numpy as np

from swifttailor.arrays import Array

_SIGNATURE = b"\x89PNG\r\n\x1a\n"
_TRUECOLOR, _WITH_OPACITY, _UP = 2, 6, 2
_LEVEL = 4
"""Of compression: a tenth larger than at 6, in half the time."""


def encode_png(picture: Array) -> bytes:
    """The content of a PNG file (W3C, third edition) of a picture, row 0 at the top.

    Args:
        picture: (h, w, 3) uint8 sRGB, or (h, w, 4) with opacity.
    """
    height, width, channels = picture.shape
    rows = picture.reshape(height, channels * width)
    filtered = np.zeros((height, 1 + channels * width), np.uint8)
    filtered[:, 0] = _UP
    filtered[0, 1:] = rows[0]
    np.subtract(rows[1:], rows[:-1], out=filtered[1:, 1:])
    header = struct.pack(
        ">IIBBBBB", width, height, 8, _TRUECOLOR if channels == 3 else _WITH_OPACITY, 0, 0, 0
    )
    chunks = ((b"IHDR", header), (b"IDAT", zlib.compress(filtered.tobytes(), _LEVEL)), (b"IEND", b""))
    return _SIGNATURE + b"".join(
        struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
        for kind, data in chunks
    )
