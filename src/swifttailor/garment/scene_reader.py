"""Readers of GLB, PLY and STL, which lean on trimesh."""

from __future__ import annotations

import json
import re
import struct
from pathlib import Path
from typing import Any

import numpy as np

from swifttailor.arrays import Array
from swifttailor.garment import glb_seams
from swifttailor.garment.ply import PANEL_COMMENT
from swifttailor.garment.triangle_mesh import TriangleMesh
from swifttailor.garment.units import from_metres


def read_glb(path: Path) -> TriangleMesh:
    """Reads binary glTF: every mesh node becomes a group; what was one vertex before export is joined.

    The wearer and what is put on the cloth are left out.
    """
    import trimesh

    document = _check_glb_counts(path)
    apart = {
        str(node.get("name"))
        for node in document.get("nodes", [])
        if isinstance(node, dict)
        and isinstance(node.get("extras"), dict)
        and node["extras"].get("role") in ("body", "trim")
    }
    second_uv = glb_seams.second_coordinates(path, document)
    scene = trimesh.load_scene(path, file_type="glb", process=False)
    parts: list[tuple[str, Array, Array, Array | None, Array | None]] = []
    for node in sorted(scene.graph.nodes_geometry, key=lambda n: _order(scene, n)):
        matrix, name = scene.graph[node]
        geometry = scene.geometry[name]
        if not isinstance(geometry, trimesh.Trimesh) or not len(geometry.faces) or str(node) in apart:
            continue
        vertices = np.asarray(geometry.vertices) @ matrix[:3, :3].T + matrix[:3, 3]
        uv = second_uv.get(str(name), getattr(geometry.visual, "uv", None))
        uv = uv if uv is not None and len(uv) == len(vertices) else None
        weld = geometry.vertex_attributes.get("_WELD")
        parts.append((str(node), vertices, np.asarray(geometry.faces), uv, weld))
    if not parts:
        raise ValueError("it holds no triangle mesh")
    counts = np.cumsum([0] + [len(p[1]) for p in parts])
    vertices = from_metres(np.concatenate([p[1] for p in parts]))
    faces = np.concatenate([p[2] + start for p, start in zip(parts, counts[:-1], strict=True)])
    uv = np.concatenate([p[3] for p in parts]) if all(p[3] is not None for p in parts) else None
    welds = [p[4] for p in parts]
    numbered = [np.asarray(w).ravel() for w in welds if w is not None]
    weld = np.concatenate(numbered) if len(numbered) == len(parts) else None
    lines = () if weld is None else glb_seams.read_seams(path, document, weld)
    joined, weld = _join_vertices(vertices, weld)
    lines = tuple(line for line in lines if line[1].max() < len(joined))
    group = np.repeat(np.arange(len(parts)), [len(p[2]) for p in parts])
    return TriangleMesh(
        joined,
        weld[faces],
        uv,
        None if uv is None else faces,
        tuple(p[0] for p in parts),
        group,
        tuple(line for _, line in lines),
        line_names=tuple(name for name, _ in lines),
    )


def read_ply(path: Path) -> TriangleMesh:
    """Reads PLY, with texture coordinates and panel numbers where the faces have them."""
    import trimesh

    names = _check_ply_header(path)
    mesh: Any = trimesh.load(path, file_type="ply", process=False, fix_texture=False, skip_materials=True)
    faces = np.asarray(getattr(mesh, "faces", np.zeros((0, 3))))
    if not len(faces):
        raise ValueError("it holds no triangle mesh")
    data = mesh.metadata.get("_ply_raw", {}).get("face", {}).get("data")
    corner_uv = _face_values(data, "texcoord", len(faces))
    uv = uv_faces = None
    if corner_uv is not None and corner_uv.shape == (len(faces), 6):
        uv, index = np.unique(corner_uv.reshape(-1, 2), axis=0, return_inverse=True)
        uv_faces = index.reshape(-1, 3)
    panel = _face_values(data, "panel", len(faces))
    known = panel is not None and panel.ndim == 1 and len(names) > 0
    if known and panel is not None:
        known = bool(((panel >= 0) & (panel < len(names))).all())
    return TriangleMesh(
        np.asarray(mesh.vertices),
        faces,
        uv,
        uv_faces,
        tuple(names) if known else (),
        panel if known else None,
    )


def read_stl(path: Path) -> TriangleMesh:
    """Reads STL and joins corners at the same place."""
    import trimesh

    mesh: Any = trimesh.load(path, file_type="stl", process=False)
    if not len(getattr(mesh, "faces", ())):
        raise ValueError("it holds no triangle mesh")
    vertices, weld = _join_vertices(np.asarray(mesh.vertices), None)
    return TriangleMesh(vertices, weld[np.asarray(mesh.faces)])


def _join_vertices(vertices: Array, weld: Array | None) -> tuple[Array, Array]:
    """Joins vertices (n, 3) that were one: by the numbers in `weld` where these fit, else by position.

    Returns:
        The joined vertices and, for each given one, the index of its joined vertex.
    """
    if weld is not None and np.isfinite(weld).all() and len(weld):
        _, first, index = np.unique(weld, return_index=True, return_inverse=True)
        joined = vertices[first]
        if np.allclose(joined[index], vertices, rtol=0.0, atol=1e-3):
            return joined, index
    _, first, index = np.unique(vertices, axis=0, return_index=True, return_inverse=True)
    # Keep the file's order, not that of the coordinates.
    order = np.argsort(first)
    rank = np.zeros(len(first), np.int64)
    rank[order] = np.arange(len(first))
    return vertices[first[order]], rank[index.ravel()]


def _order(scene: Any, node: str) -> int:
    return list(scene.geometry).index(scene.graph[node][1])


def _face_values(data: Any, name: str, count: int) -> Array | None:
    """A property of the faces as trimesh keeps it: an array, or a structured one for lists."""
    try:
        values = data[name]
        values = values["f1"] if values.dtype.names else values
        return np.asarray(values) if len(values) == count else None
    except (KeyError, ValueError, TypeError, IndexError, AttributeError):
        return None


def _check_glb_counts(path: Path) -> dict[str, Any]:
    """The JSON part of a file; refuses one that announces more than the file can hold."""
    size = path.stat().st_size
    with path.open("rb") as file:
        magic, version, _ = struct.unpack("<4sII", file.read(12))
        if magic != b"glTF" or version != 2:
            raise ValueError("it is not a glTF 2.0 binary")
        length, _ = struct.unpack("<I4s", file.read(8))
        if length > size:
            raise ValueError("it is cut short")
        document = json.loads(file.read(length))
    for accessor in document.get("accessors", []):
        if not 0 <= accessor["count"] <= size:
            raise ValueError(f"it announces {accessor['count']} values, more than the file can hold")
    return document


def _check_ply_header(path: Path) -> list[str]:
    """Does the same for PLY; returns the panel names in the comments."""
    size = path.stat().st_size
    names = []
    with path.open("rb") as file:
        if not file.readline(100).lower().startswith(b"ply"):
            raise ValueError("it does not start with 'ply'")
        for _ in range(100_000):
            line = file.readline(10_000).decode("ascii", "replace").strip()
            if not line or line == "end_header":
                break
            words = line.split()
            if words[0] == "element" and not 0 <= int(words[2]) <= size:
                raise ValueError(f"it announces {words[2]} of '{words[1]}', more than the file can hold")
            named = re.fullmatch(rf'{PANEL_COMMENT}(\d+) "(.*)"', line)
            if named and int(named[1]) == len(names):
                names.append(named[2])
    return names
