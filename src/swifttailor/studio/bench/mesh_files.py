"""Garments and bodies as mesh files, and back."""

from __future__ import annotations

import json
from dataclasses import replace
from typing import Any

import numpy as np

from swifttailor.arrays import Array
from swifttailor.errors import GeometryError
from swifttailor.garment.folder import plain
from swifttailor.garment.garment import Garment
from swifttailor.panel_mesh import mesh_pattern
from swifttailor.panel_mesh.pattern_mesh import PatternMesh
from swifttailor.pattern import Pattern, read_specification, to_specification
from swifttailor.studio.bench.panels_on_cloth import panels_on_cloth
from swifttailor.studio.bench.trim_blocks import trim_blocks
from swifttailor.studio.mesh_record import MeshRecord, name_of, pack_mesh, smooth_normals, unpack_mesh

_SAME_CM = 0.05
"""Vertices nearer than this are the same: meshes that ship with the package are rounded."""


def garment_record(garment: Garment, edge_length: float) -> MeshRecord:
    """A garment for the store.

    Args:
        garment: As it is.
        edge_length: Of its mesh, cm.
    """
    mesh = garment.mesh
    vertices = garment.vertices.astype(np.float32).astype(np.float64)  # as they come back from the file
    normals = smooth_normals(vertices, mesh.faces)[mesh.weld]
    edges = [
        ({"panel": panel.name, "edge": k}, mesh.edge_vertices[p][k])
        for p, panel in enumerate(mesh.pattern.panels)
        for k in range(len(panel.edges))
    ]
    seams = [_seam_sides(mesh, seam.stitch) for seam in mesh.seams]
    header: dict[str, Any] = {
        "version": 1,
        "kind": "garment",
        "vertices": len(mesh.flat_vertices),
        "triangles": len(mesh.flat_faces),
        "welded": mesh.vertex_count,
        "panels": [panel.name for panel in mesh.pattern.panels],
        "seams": [sides for sides, _ in seams],
        "edges": [place for place, _ in edges],
        "color": garment.color,
        "on_cloth": panels_on_cloth(mesh),
    }
    if garment.looks:
        header["looks"] = [look.to_json() for look in garment.looks]
    if garment.print is not None:
        header["print"] = garment.print.to_json()
    trims, of_trims = trim_blocks(replace(garment, vertices=vertices))
    if trims:
        header["trims"] = trims
    blocks = {
        "positions": vertices[mesh.weld],
        "normals": normals,
        "uv": mesh.flat_vertices,
        "panel": mesh.flat_panel,
        "weld": mesh.weld,
        "triangles": mesh.flat_faces,
        "strain": strain_of(mesh, vertices),
        **_lists("seam", [vertices for _, vertices in seams]),
        **_lists("edge", [vertices for _, vertices in edges]),
        **of_trims,
    }
    data = pack_mesh(header, blocks)
    pattern = json.dumps(to_specification(mesh.pattern), separators=(",", ":"), allow_nan=False)
    return MeshRecord(
        name_of(data),
        data,
        pattern,
        edge_length,
        plain(garment.report),
        garment.color,
        garment.looks,
        garment.print,
    )


def garment_of(record: MeshRecord) -> Garment:
    """The garment of a record, with its positions to a hundredth of a millimetre.

    Raises:
        GeometryError: It was meshed by another version, so that its vertices cannot be told.
    """
    pattern = read_specification(json.loads(record.pattern)).pattern
    mesh = mesh_pattern(pattern, record.edge_length)
    _, blocks = unpack_mesh(record.data)
    flat, uv = (blocks[name].astype(np.float64) for name in ("positions", "uv"))
    if (
        uv.size != mesh.flat_vertices.size
        or np.abs(uv - mesh.flat_vertices.ravel()).max(initial=0.0) > _SAME_CM
    ):
        raise GeometryError("The garment was meshed by another version of the program. Sew it again.")
    report = {
        "edge_length_cm": record.edge_length,
        "rotation": pattern.panels[0].placement.reading,
        "vertices": mesh.vertex_count,
        "faces": len(mesh.faces),
        "panels": len(pattern.panels),
        "stitches": len(pattern.stitches),
    }
    vertices = flat.reshape(-1, 3)[mesh.representative]
    return Garment(
        mesh, vertices, report | record.report, record.color, print=record.print, looks=record.looks
    )


def same_pattern(first: Pattern, second: Pattern) -> bool:
    """Whether two patterns make the same garment, trims and wearer too: they may have names of their own."""
    worn = first.drafted_for == second.drafted_for and first.trims == second.trims
    worn = worn and first.button_count == second.button_count
    return worn and replace(first, name="") == replace(second, name="")


def strain_of(mesh: PatternMesh, vertices: Array) -> Array:
    """(m,) how far the cloth is stretched at each flat vertex, where it is most: 0.1 is a tenth.

    Negative where it is pushed together in all directions, as gathers are.

    Args:
        mesh: Gives the flat cloth.
        vertices: (v, 3) welded positions, cm.
    """
    rest, now = mesh.flat_vertices[mesh.flat_faces], vertices[mesh.weld][mesh.flat_faces]
    a, b = rest[:, 1] - rest[:, 0], rest[:, 2] - rest[:, 0]
    twice = a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]
    safe = np.where(np.abs(twice) > 1e-9, twice, np.inf)
    p, q = now[:, 1] - now[:, 0], now[:, 2] - now[:, 0]
    along_u = (p * b[:, 1:] - q * a[:, 1:]) / safe[:, None]
    along_v = (q * a[:, :1] - p * b[:, :1]) / safe[:, None]
    uu, vv, uv = (along_u**2).sum(1), (along_v**2).sum(1), (along_u * along_v).sum(1)
    largest = np.sqrt((uu + vv) / 2 + np.sqrt(((uu - vv) / 2) ** 2 + uv**2))
    stretch, area = np.where(np.isfinite(safe), largest - 1.0, 0.0), np.abs(twice)
    count = len(mesh.flat_vertices)
    total, weight = np.zeros(count), np.zeros(count)
    for k in range(3):
        total += np.bincount(mesh.flat_faces[:, k], stretch * area, count)
        weight += np.bincount(mesh.flat_faces[:, k], area, count)
    return np.divide(total, weight, out=np.zeros(count), where=weight > 0).astype(np.float32)


def _seam_sides(mesh: PatternMesh, stitch: int) -> tuple[dict[str, Any], Array]:
    sides = mesh.pattern.stitches[stitch].sides
    vertices = [mesh.edge_vertices[mesh.pattern.panel_index(r.panel)][r.edge] for r in sides]
    names = [{"panel": r.panel, "edge": r.edge} for r in sides]
    return {"first": names[0], "second": names[1]}, np.concatenate(vertices)


def _lists(name: str, lists: list[Array]) -> dict[str, Array]:
    """Lists of vertices one after the other, and where each begins."""
    offsets = np.cumsum([0, *map(len, lists)])
    joined = np.concatenate(lists) if lists else np.zeros(0, np.int32)
    return {f"{name}_vertices": joined, f"{name}_offsets": offsets}
