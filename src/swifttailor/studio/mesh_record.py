"""A garment as the server keeps it: the bytes that clients fetch, and what it was built from."""

from __future__ import annotations

import hashlib
import json
import struct
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np

from swifttailor.arrays import Array

if TYPE_CHECKING:
    from swifttailor.garment.cloth_print import ClothPrint
    from swifttailor.garment.part_looks import PartLook

MAGIC = b"STMESH01"
_START = struct.Struct("<8sI")
_TYPES = {"f32": np.dtype("<f4"), "u32": np.dtype("<u4")}


@dataclass(frozen=True, eq=False)
class MeshRecord:
    """One mesh."""

    name: str
    """Hash of `data`, 32 hexadecimal digits."""
    data: bytes
    """The mesh file: studio-ui/API.md describes it."""
    pattern: str = ""
    """Specification that the garment was sewn from, as JSON; empty for bodies."""
    edge_length: float = 2.0
    """Of the mesh, cm."""
    report: dict[str, Any] = field(default_factory=dict)
    """What made it: JSON values."""
    color: str | None = None
    looks: tuple[PartLook, ...] = ()
    """Of parts that look otherwise than the rest."""
    print: ClothPrint | None = None
    """On all that has no look of its own."""

    @property
    def size(self) -> int:
        """Bytes that keeping it takes, about."""
        return len(self.data) + len(self.pattern)


def pack_mesh(header: dict[str, Any], blocks: dict[str, Array]) -> bytes:
    """A mesh file.

    Args:
        header: All of it but the list of blocks.
        blocks: By name; numbers with a fraction are written as float32, whole ones as uint32.
    """
    listed, parts, offset = [], [], 0
    for name, values in blocks.items():
        kind = "f32" if np.issubdtype(values.dtype, np.floating) else "u32"
        content = np.ascontiguousarray(values, dtype=_TYPES[kind]).tobytes()
        listed.append({"name": name, "type": kind, "count": int(values.size), "offset": offset})
        parts.append(content)
        offset += len(content)
    text = json.dumps(header | {"blocks": listed}, separators=(",", ":"), allow_nan=False).encode()
    text += b" " * (-(_START.size + len(text)) % 4)
    return b"".join([_START.pack(MAGIC, len(text)), text, *parts])


def unpack_mesh(data: bytes) -> tuple[dict[str, Any], dict[str, Array]]:
    """Header and blocks (flat arrays) of a mesh file that `pack_mesh` wrote."""
    magic, length = _START.unpack_from(data)
    if magic != MAGIC:
        raise ValueError("The bytes are no mesh file.")
    header = json.loads(data[_START.size : _START.size + length])
    start = _START.size + length
    blocks = {
        b["name"]: np.frombuffer(data, _TYPES[b["type"]], b["count"], start + b["offset"])
        for b in header["blocks"]
    }
    return header, blocks


def name_of(data: bytes) -> str:
    """The name that content has."""
    return hashlib.blake2b(data, digest_size=16).hexdigest()


def smooth_normals(positions: Array, faces: Array) -> Array:
    """(n, 3) unit normals, area-weighted over the faces around each vertex.

    Args:
        positions: (n, 3).
        faces: (f, 3).
    """
    corners = positions[faces]
    of_faces = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    sums = [
        sum(np.bincount(faces[:, k], of_faces[:, axis], len(positions)) for k in range(3))
        for axis in range(3)
    ]
    normals = np.stack(sums, axis=1)
    length = np.linalg.norm(normals, axis=1, keepdims=True)
    return np.divide(normals, length, out=np.tile([0.0, 1.0, 0.0], (len(normals), 1)), where=length > 1e-12)
