"""Binary glTF (.glb): one node per panel, smooth across seams, in metres."""

from __future__ import annotations

import json
import struct
from pathlib import Path
from typing import Any

import numpy as np

from swifttailor.arrays import Array
from swifttailor.atomic_files import write_bytes
from swifttailor.garment.triangle_mesh import TriangleMesh
from swifttailor.garment.units import to_metres
from swifttailor.render.color import BODY, to_linear

_FLOAT, _UINT = 5126, 5125
_VERTICES, _INDICES = 34962, 34963
_LINE_STRIP, _TRIANGLES = 3, 4
_REPEAT, _LINEAR, _MIPMAPS = 10497, 9729, 9987
_ROUGHNESS = 0.85
_SEAM_SHARE = 0.28
"""How light a seam is beside its cloth."""


def write_glb(mesh: TriangleMesh, path: Path | str, *, overwrite: bool = False) -> Path:
    """Writes a mesh as binary glTF.

    Panels become nodes of their names under one root. Vertices on seams are repeated in every panel, with
    the same position and normal, so that no seam shows as a crease; the attribute ``_WELD`` numbers the
    vertices of the stitched mesh, so that readers can join them again. Seams are lines, each a node of its
    name (`seam_names`) under the node ``seams``. A print is a texture whose coordinates count its repeats,
    so that it has its true size on the cloth; the panels' places in the unit square are then
    ``TEXCOORD_1``. Parts that look otherwise have materials of their own, of which sheer ones are blended by
    their opacity. The wearer is the node ``body``; pockets, buttons and the like are nodes under ``trims``.
    """
    return write_bytes(path, glb_bytes(mesh), overwrite=overwrite)


def glb_bytes(mesh: TriangleMesh) -> bytes:
    """The content of the file that `write_glb` writes."""
    buffer = _Buffer()
    flat = mesh.flat
    positions = to_metres(mesh.vertices).astype(np.float32)
    normals = mesh.vertex_normals.astype(np.float32)
    names = mesh.groups or ("mesh",)
    face_group = np.zeros(len(mesh.faces), np.int32) if mesh.face_group is None else mesh.face_group
    nodes: list[dict[str, Any]] = []
    meshes: list[dict[str, Any]] = []
    looks = list(dict.fromkeys([look for look in mesh.looks if look is not None]))
    for k, name in enumerate(names):
        of_panel = flat.group == k
        faces = flat.faces[face_group == k]
        if not len(faces):
            nodes.append({"name": name})
            continue
        weld = flat.weld[of_panel]
        look = mesh.looks[k] if mesh.looks else None
        attributes = {
            "POSITION": buffer.add(positions[weld], bounds=True),
            "NORMAL": buffer.add(normals[weld]),
        }
        if flat.uv is not None:
            # glTF counts v from the top of the texture.
            places = [flat.uv] if flat.repeats is None else [flat.repeats, flat.uv]
            for number, uv in enumerate(places):
                attributes[f"TEXCOORD_{number}"] = buffer.add(uv[of_panel] * (1.0, -1.0) + (0.0, 1.0))
        attributes["_WELD"] = buffer.add(weld.astype(np.float32))
        primitive = {
            "attributes": attributes,
            "indices": buffer.add_indices(faces - np.flatnonzero(of_panel)[0]),
            "material": 0 if look is None else 2 + looks.index(look),
            "mode": _TRIANGLES,
        }
        nodes.append({"name": name, "mesh": len(meshes)})
        meshes.append({"name": name, "primitives": [primitive]})
    panels = list(range(1, len(nodes) + 1))
    children = panels.copy()
    seams = [k for k, line in enumerate(mesh.lines) if len(line) > 1]
    if seams:
        first = len(nodes) + 2
        children.append(first - 1)
        nodes.append({"name": "seams", "children": list(range(first, first + len(seams)))})
    for k in seams:
        name = mesh.line_names[k] if mesh.line_names else f"seam_{k:03d}"
        line = mesh.lines[k]
        attributes = {
            "POSITION": buffer.add(positions[line], bounds=True),
            "_WELD": buffer.add(line.astype(np.float32)),
        }
        primitive = {"attributes": attributes, "material": 1, "mode": _LINE_STRIP}
        nodes.append({"name": name, "mesh": len(meshes), "extras": {"seam": name}})
        meshes.append({"name": name, "primitives": [primitive]})
    materials = [
        _material("cloth", to_linear(mesh.color), mesh.roughness),
        _material("seam", _SEAM_SHARE * to_linear(mesh.color), _ROUGHNESS),
    ]
    pictures: list[tuple[str, bytes]] = []
    for k, look in enumerate(looks):
        materials.append(_material(f"cloth {k + 2}", to_linear(look.color), mesh.roughness, look.opacity))
        if look.picture is not None:
            surface = materials[-1]["pbrMetallicRoughness"]
            surface["baseColorFactor"] = [1.0, 1.0, 1.0, 1.0]
            at = 0 if flat.repeats is None else 1
            surface["baseColorTexture"] = {"index": len(pictures), "texCoord": at}
            pictures.append((f"cloth {k + 2}", look.picture))
    if mesh.wearer is not None:
        nodes.append({"name": "body", "mesh": len(meshes), "extras": {"role": "body"}})
        children.append(len(nodes))
        meshes.append(
            {"name": "body", "primitives": [_smooth(buffer, *mesh.wearer) | {"material": len(materials)}]}
        )
        materials.append(_material("body", to_linear(BODY), _ROUGHNESS))
    if mesh.trims:
        first = len(nodes) + 2
        children.append(first - 1)
        nodes.append({"name": "trims", "children": list(range(first, first + len(mesh.trims)))})
    for part in mesh.trims:
        nodes.append({"name": part.name, "mesh": len(meshes), "extras": {"role": "trim"}})
        primitive = _smooth(buffer, part.vertices, part.faces) | {"material": len(materials)}
        meshes.append({"name": part.name, "primitives": [primitive]})
        materials.append(_material(part.name, to_linear(part.color), _ROUGHNESS, part.opacity))
    if mesh.print is not None:
        surface = materials[0]["pbrMetallicRoughness"]
        surface["baseColorFactor"] = [1.0, 1.0, 1.0, 1.0]
        surface["baseColorTexture"] = {"index": len(pictures), "texCoord": 0}
        pictures.append(("print", mesh.print.png))
    textures: dict[str, Any] = {}
    if pictures:
        views = [(name, buffer.add_file(png)) for name, png in pictures]
        textures = {
            "images": [{"bufferView": view, "mimeType": "image/png", "name": name} for name, view in views],
            "samplers": [{"wrapS": _REPEAT, "wrapT": _REPEAT, "magFilter": _LINEAR, "minFilter": _MIPMAPS}],
            "textures": [{"source": k, "sampler": 0} for k in range(len(pictures))],
        }
    root = {"name": "garment", "children": children}
    document = {
        "asset": {"version": "2.0", "generator": "swifttailor"},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [root, *nodes],
        "meshes": meshes,
        "materials": materials,
        **textures,
        "accessors": buffer.accessors,
        "bufferViews": buffer.views,
        "buffers": [{"byteLength": len(buffer.data)}] if buffer.data else [],
    }
    # Empty arrays are not allowed in glTF.
    return _container({key: value for key, value in document.items() if value != []}, bytes(buffer.data))


class _Buffer:
    """Collects arrays and describes where they lie."""

    def __init__(self) -> None:
        self.data = bytearray()
        self.views: list[dict[str, Any]] = []
        self.accessors: list[dict[str, Any]] = []

    def add(self, values: Array, *, bounds: bool = False) -> int:
        """Adds float32 vertex data (n,) or (n, c) and returns its accessor."""
        values = np.ascontiguousarray(values, np.float32)
        kind = "SCALAR" if values.ndim == 1 else f"VEC{values.shape[1]}"
        accessor = self._add(values, _FLOAT, kind, _VERTICES)
        if bounds:
            self.accessors[accessor]["min"] = values.min(axis=0).tolist()
            self.accessors[accessor]["max"] = values.max(axis=0).tolist()
        return accessor

    def add_indices(self, values: Array) -> int:
        """Adds vertex indices of any shape and returns their accessor."""
        return self._add(np.ascontiguousarray(values.ravel(), np.uint32), _UINT, "SCALAR", _INDICES)

    def add_file(self, content: bytes) -> int:
        """Adds a file and returns its buffer view."""
        self.views.append({"buffer": 0, "byteOffset": len(self.data), "byteLength": len(content)})
        self.data += content + b"\0" * (-len(content) % 4)
        return len(self.views) - 1

    def _add(self, values: Array, component: int, kind: str, target: int) -> int:
        content = values.tobytes()
        self.views.append(
            {"buffer": 0, "byteOffset": len(self.data), "byteLength": len(content), "target": target}
        )
        self.data += content
        self.accessors.append(
            {
                "bufferView": len(self.views) - 1,
                "componentType": component,
                "count": len(values),
                "type": kind,
            }
        )
        return len(self.accessors) - 1


def _smooth(buffer: _Buffer, vertices: Array, faces: Array) -> dict[str, Any]:
    """A mesh as one smooth primitive without texture."""
    mesh = TriangleMesh(vertices, faces)
    attributes = {
        "POSITION": buffer.add(to_metres(mesh.vertices).astype(np.float32), bounds=True),
        "NORMAL": buffer.add(mesh.vertex_normals.astype(np.float32)),
    }
    indices = buffer.add_indices(mesh.faces)
    return {"attributes": attributes, "indices": indices, "mode": _TRIANGLES}


def _material(name: str, color: Array, roughness: float, opacity: float = 1.0) -> dict[str, Any]:
    surface = {
        "baseColorFactor": [*np.round(color, 4).tolist(), round(opacity, 4)],
        "metallicFactor": 0.0,
        "roughnessFactor": roughness,
    }
    blended = {} if opacity >= 1.0 else {"alphaMode": "BLEND"}
    return {"name": name, "pbrMetallicRoughness": surface, "doubleSided": True, **blended}


def _container(document: dict[str, Any], binary: bytes) -> bytes:
    text = json.dumps(document, separators=(",", ":"), allow_nan=False).encode()
    text += b" " * (-len(text) % 4)
    binary += b"\0" * (-len(binary) % 4)
    chunks = struct.pack("<II", len(text), 0x4E4F534A) + text
    if binary:
        chunks += struct.pack("<II", len(binary), 0x004E4942) + binary
    return struct.pack("<III", 0x46546C67, 2, 12 + len(chunks)) + chunks
