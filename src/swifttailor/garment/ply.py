"""Stanford PLY (binary): one stitched mesh, the panel and texture coordinates on the faces, centimetres."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from swifttailor.atomic_files import write_bytes
from swifttailor.garment.obj import safe_names
from swifttailor.garment.triangle_mesh import TriangleMesh

PANEL_COMMENT = "comment panel "


def write_ply(mesh: TriangleMesh, path: Path | str, *, overwrite: bool = False) -> Path:
    """Writes a mesh as binary little-endian PLY.

    Vertices are those of the stitched mesh, with normals. Every face has its panel's number (names are in
    the header's comments) and, where the mesh has them, texture coordinates of its corners (``texcoord``).
    """
    return write_bytes(path, ply_bytes(mesh), overwrite=overwrite)


def ply_bytes(mesh: TriangleMesh) -> bytes:
    """The content of the file that `write_ply` writes."""
    header = [
        "ply",
        "format binary_little_endian 1.0",
        "comment swifttailor garment",
        "comment units: centimetres, Y up, the wearer faces +Z",
        *(f'{PANEL_COMMENT}{k} "{name}"' for k, name in enumerate(safe_names(mesh.groups))),
        f"element vertex {len(mesh.vertices)}",
        *(f"property float {name}" for name in ("x", "y", "z", "nx", "ny", "nz")),
        f"element face {len(mesh.faces)}",
        "property list uchar int vertex_indices",
    ]
    columns: list[Any] = [("count", "u1"), ("index", "<i4", 3)]
    if mesh.uv is not None:
        header.append("property list uchar float texcoord")
        columns += [("uv_count", "u1"), ("uv", "<f4", 6)]
    if mesh.face_group is not None:
        header.append("property int panel")
        columns.append(("panel", "<i4"))
    header.append("end_header")

    faces = np.zeros(len(mesh.faces), columns)
    faces["count"], faces["index"] = 3, mesh.faces
    if mesh.uv is not None and mesh.uv_faces is not None:
        faces["uv_count"], faces["uv"] = 6, mesh.uv[mesh.uv_faces].reshape(-1, 6)
    if mesh.face_group is not None:
        faces["panel"] = mesh.face_group
    vertices = np.concatenate([mesh.vertices, mesh.vertex_normals], axis=1).astype("<f4")
    text = "\n".join(header) + "\n"
    return text.encode("ascii", "replace") + vertices.tobytes() + faces.tobytes()
