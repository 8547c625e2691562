"""Mesh files made small, to ship with the package: numbers rounded, normals left out, packed by gzip."""

from __future__ import annotations

import gzip
import io
import json
from typing import Any

import numpy as np

from swifttailor.arrays import Array
from swifttailor.studio.mesh_record import pack_mesh, smooth_normals, unpack_mesh

_UNIT = {
    "positions": 0.01,
    "uv": 0.01,
    "strain": 0.01,
    "color": 1 / 255,
    "trim_positions": 0.01,
    "trim_uv": 0.01,
}
"""What one step of a rounded number is: cm, shares."""
_COLUMNS = {
    "positions": 3,
    "uv": 2,
    "triangles": 3,
    "color": 3,
    "normals": 3,
    "trim_positions": 3,
    "trim_uv": 2,
    "trim_triangles": 3,
    "trim_lines": 2,
}


def shrink(data: bytes) -> bytes:
    """A mesh file (`mesh_record.pack_mesh`) in about a tenth of its bytes."""
    header, blocks = unpack_mesh(data)
    kept: dict[str, Array] = {"header": np.frombuffer(json.dumps(header).encode(), np.uint8)}
    for name, values in blocks.items():
        if name == "normals":
            continue
        whole = np.round(values / _UNIT[name]).astype(np.int64) if name in _UNIT else values.astype(np.int64)
        steps = np.diff(
            whole.reshape(-1, _COLUMNS.get(name, 1)), axis=0, prepend=0
        )  # near each other, mostly
        kept[name] = steps.T.astype(np.int16 if np.abs(steps).max(initial=0) < 2**15 else np.int32)
    content = io.BytesIO()
    np.savez(content, allow_pickle=False, **kept)
    return gzip.compress(content.getvalue(), 9, mtime=0)


def expand(content: bytes) -> bytes:
    """The mesh file that `shrink` made small, its numbers rounded."""
    with np.load(io.BytesIO(gzip.decompress(content)), allow_pickle=False) as stored:
        header: dict[str, Any] = json.loads(stored["header"].tobytes())
        blocks: dict[str, Array] = {}
        for entry in header.pop("blocks"):
            name = entry["name"]
            if name == "normals":
                blocks[name] = np.zeros(0, np.float32)  # keeps its place in the order
                continue
            whole = np.cumsum(stored[name].T.astype(np.int64), axis=0)
            blocks[name] = (
                (whole * _UNIT[name]).astype(np.float32) if name in _UNIT else whole.astype(np.uint32)
            )
    weld = blocks["weld"].ravel()
    positions, faces = blocks["positions"], weld[blocks["triangles"]].astype(np.int64)
    welded = np.zeros((int(header["welded"]), 3))
    welded[weld] = positions
    blocks["normals"] = smooth_normals(welded, faces)[weld].astype(np.float32)
    return pack_mesh(header, blocks)
