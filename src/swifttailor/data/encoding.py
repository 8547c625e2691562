"""How a sample becomes few bytes: positions in hundredths of a centimetre, other facts as packed JSON."""

from __future__ import annotations

import hashlib
import json
import lzma
from dataclasses import dataclass
from typing import Any

import numpy as np

from swifttailor.arrays import Floats
from swifttailor.errors import InputError
from swifttailor.panel_mesh.pattern_mesh import PatternMesh

STEP_CM = 0.01
"""Positions are whole multiples of this above the garment's own corner: at most 0.005 cm off per axis."""
_LEVELS = 2**16 - 1
_FILTERS = [{"id": lzma.FILTER_LZMA1, "preset": 9 | lzma.PRESET_EXTREME, "dict_size": 1 << 20}]
_MOST_BYTES, _MOST_MEMORY = 2**26, 2**27
"""What a part of a sample may unpack to, a thousand times what garments need, and what unpacking may take."""
_GRID_CM = 1e-3
_OFF_GRID_CM = 2.718e-4


@dataclass(frozen=True)
class EncodedPositions:
    """Vertices of a garment as 16-bit numbers, compressed."""

    data: bytes
    origin: tuple[float, float, float]
    """Lowest x, y and z, cm."""
    step: float
    """Centimetres per unit; `STEP_CM` unless the garment is larger than 655 cm."""
    count: int


def encode_positions(vertices: Floats) -> EncodedPositions:
    """Packs vertices; see `STEP_CM` for what is lost.

    Consecutive vertices of a panel mesh are neighbours, so their differences are small; low and high bytes
    are stored apart because the high ones are nearly all alike.

    Args:
        vertices: (v, 3) positions, cm, finite.
    """
    origin = vertices.min(axis=0)
    step = max(STEP_CM, float(np.ptp(vertices, axis=0).max()) / _LEVELS)
    levels = np.round((vertices - origin) / step).astype(np.int32)
    differences = np.diff(levels, axis=0, prepend=0).astype(np.uint16)  # modulo 2^16
    planes = np.ascontiguousarray(differences.T, dtype="<u2").view(np.uint8).reshape(-1, 2).T
    x, y, z = (float(value) for value in origin)
    return EncodedPositions(pack(planes.tobytes()), (x, y, z), step, len(vertices))


def decode_positions(encoded: EncodedPositions) -> Floats:
    """(v, 3) positions, cm.

    Raises:
        InputError: The data are damaged.
    """
    planes = np.frombuffer(_unpack(encoded.data), dtype=np.uint8)
    if len(planes) != 6 * encoded.count:
        raise InputError(f"The positions are damaged: {len(planes)} bytes for {encoded.count} vertices.")
    differences = np.ascontiguousarray(planes.reshape(2, -1).T).view("<u2").reshape(3, -1)
    levels = np.cumsum(differences, axis=1, dtype=np.uint16)
    return levels.T * encoded.step + np.array(encoded.origin)


def encode_document(document: dict[str, Any]) -> bytes:
    """Packs JSON values; floats keep all their digits."""
    return pack(json.dumps(document, separators=(",", ":"), allow_nan=False).encode())


def decode_document(data: bytes) -> dict[str, Any]:
    """What `encode_document` packed.

    Raises:
        InputError: The data are damaged.
    """
    try:
        value = json.loads(_unpack(data))
    except (ValueError, RecursionError) as error:
        raise InputError(f"The facts of a sample are damaged: {error}.") from error
    if not isinstance(value, dict):
        raise InputError("The facts of a sample are damaged: they are no object.")
    return value


def mesh_checksum(mesh: PatternMesh) -> str:
    """Identifies a panel mesh: its triangles, its weld and its flat vertices to a thousandth of a cm.

    Coordinates are compared on a grid that is shifted by an odd amount, so that lengths which people choose
    never lie on the border between two of its cells, where the last digit would decide.
    """
    cells = np.floor((mesh.flat_vertices + _OFF_GRID_CM) / _GRID_CM).astype("<i8")
    digest = hashlib.sha256()
    for array in (cells, mesh.flat_panel, mesh.flat_faces, mesh.weld):
        digest.update(np.ascontiguousarray(array, dtype="<i8").tobytes() + b"|")
    return digest.hexdigest()[:32]


def pack(data: bytes) -> bytes:
    """Bytes as they lie in a shard."""
    return lzma.compress(data, format=lzma.FORMAT_ALONE, filters=_FILTERS)


def _unpack(data: bytes) -> bytes:
    press = lzma.LZMADecompressor(lzma.FORMAT_ALONE, memlimit=_MOST_MEMORY)
    try:
        found = press.decompress(data, _MOST_BYTES)
    except (lzma.LZMAError, EOFError) as error:
        raise InputError(f"A sample is damaged: {error}.") from error
    if not press.eof:
        raise InputError(
            f"A sample is damaged: it is cut short, or unpacks to more than {_MOST_BYTES} bytes."
        )
    return found
