"""STL (binary): bare triangles in centimetres."""

from __future__ import annotations

import struct
from pathlib import Path

import numpy as np

from swifttailor.atomic_files import write_bytes
from swifttailor.garment.triangle_mesh import TriangleMesh


def write_stl(mesh: TriangleMesh, path: Path | str, *, overwrite: bool = False) -> Path:
    """Writes a mesh as binary STL, which keeps neither seams nor panels nor texture coordinates."""
    return write_bytes(path, stl_bytes(mesh), overwrite=overwrite)


def stl_bytes(mesh: TriangleMesh) -> bytes:
    """The content of the file that `write_stl` writes."""
    corners = mesh.vertices[mesh.faces]
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    norm = np.linalg.norm(normal, axis=1, keepdims=True)
    rows = np.zeros(len(corners), [("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])
    rows["normal"] = np.divide(normal, norm, out=np.zeros_like(normal), where=norm > 0)
    rows["corners"] = corners
    header = b"swifttailor garment, centimetres".ljust(80)
    return header + struct.pack("<I", len(rows)) + rows.tobytes()
