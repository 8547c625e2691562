"""What a binary glTF file of a garment holds besides triangles: seams by name, second texture coordinates."""

from __future__ import annotations

import struct
from pathlib import Path
from typing import Any

import numpy as np

from swifttailor.arrays import Array
from swifttailor.garment.seam_names import read_seam_name

_FLOAT = 5126
_COLUMNS = {"SCALAR": 1, "VEC2": 2}
_MOST_SEAMS = 100_000


def read_seams(path: Path, document: dict[str, Any], weld: Array) -> tuple[tuple[str, Array], ...]:
    """The seams of a file, each with its vertices among the joined ones.

    Args:
        path: The file.
        document: Its JSON part.
        weld: (n,) numbers of the stitched mesh's vertices, of all panels' vertices.

    Returns:
        Names and vertex indices; none where the file does not hold what it says.
    """
    numbers = np.unique(weld)
    seams = []
    for node in _dicts(document.get("nodes"))[:_MOST_SEAMS]:
        extras = node.get("extras")
        name = extras.get("seam") if isinstance(extras, dict) else None
        if not isinstance(name, str) or read_seam_name(name) is None:
            continue
        values = _attribute(path, document, node.get("mesh"), "_WELD")
        if values is None or len(values) < 2 or not np.isin(values[:, 0], numbers).all():
            continue
        seams.append((name, np.searchsorted(numbers, values[:, 0])))
    return tuple(seams)


def second_coordinates(path: Path, document: dict[str, Any]) -> dict[str, Array]:
    """By mesh name, places in the unit square, where the first coordinates are those of a print."""
    found = {}
    for k, mesh in enumerate(_dicts(document.get("meshes"))):
        values = _attribute(path, document, k, "TEXCOORD_1")
        if values is not None and values.shape[1] == 2:
            found[str(mesh.get("name"))] = values * (1.0, -1.0) + (0.0, 1.0)
    return found


def _attribute(path: Path, document: dict[str, Any], mesh: object, name: str) -> Array | None:
    """An attribute (n, c) of a mesh's only primitive; None where there is none that can be read."""
    try:
        primitives = document["meshes"][mesh]["primitives"]
        accessor = document["accessors"][primitives[0]["attributes"][name]]
        view = document["bufferViews"][accessor["bufferView"]]
        columns, count = _COLUMNS[accessor["type"]], accessor["count"]
        start = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
        if accessor["componentType"] != _FLOAT or view.get("byteStride", 4 * columns) != 4 * columns:
            return None
        content = _binary(path, int(start), 4 * columns * int(count))
        return np.frombuffer(content, np.float32).reshape(-1, columns).astype(np.float64)
    except (KeyError, IndexError, TypeError, ValueError, AttributeError, struct.error, OSError):
        return None


def _binary(path: Path, start: int, length: int) -> bytes:
    with path.open("rb") as file:
        file.seek(12)
        (text,) = struct.unpack("<I4x", file.read(8))
        file.seek(20 + text)
        (size,) = struct.unpack("<I4x", file.read(8))
        if not 0 <= start <= start + length <= size:
            raise ValueError("outside the file")
        file.seek(start, 1)
        return file.read(length)


def _dicts(value: object) -> list[dict[str, Any]]:
    return [item for item in value if isinstance(item, dict)] if isinstance(value, list) else []
