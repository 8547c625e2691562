"""Flat panels with sewing springs, for simulation in Blender and programs like it."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from swifttailor.atomic_files import write_bytes
from swifttailor.garment.obj import obj_text
from swifttailor.garment.seam_names import seam_name
from swifttailor.garment.triangle_mesh import TriangleMesh
from swifttailor.garment.units import to_metres
from swifttailor.making.sewn_pattern import require_sewable
from swifttailor.panel_mesh import mesh_pattern
from swifttailor.panel_mesh.edge_sampling import stitched_pairs
from swifttailor.panel_mesh.uv_layout import lay_out_uv
from swifttailor.pattern import Pattern


def flat_panels(pattern: Pattern, edge_length: float = 2.0) -> TriangleMesh:
    """The panels as placed around the body, not sewn, with a line for each pair of vertices to be sewn.

    The two edges of a seam have equally many vertices; line k of a seam joins vertex k of one edge with
    the vertex that it meets. All lines of a seam have the seam's name.

    Args:
        pattern: A pattern placed around a body.
        edge_length: Of the mesh, cm.

    Raises:
        PatternError: It cannot be sewn.
        GeometryError: A panel cannot be meshed.
    """
    require_sewable(pattern)  # by the numbers that its file has
    pattern = pattern.canonical()
    mesh = mesh_pattern(pattern, edge_length)
    vertices = np.zeros((len(mesh.flat_vertices), 3))
    for k, panel in enumerate(pattern.panels):
        own = mesh.flat_panel == k
        vertices[own] = panel.to_world(mesh.flat_vertices[own])
    lines, names = [], []
    for number, stitch in enumerate(pattern.stitches):
        first, second = (
            mesh.edge_vertices[pattern.panel_index(side.panel)][side.edge].astype(np.int64)
            for side in stitch.sides
        )
        pairs = stitched_pairs(first, second, stitch.right_wrong)
        pairs = pairs[pairs[:, 0] != pairs[:, 1]]  # the point of a dart is sewn already
        lines += list(pairs)
        names += [seam_name(number, stitch)] * len(pairs)
    return TriangleMesh(
        vertices,
        mesh.flat_faces,
        lay_out_uv(mesh)[0],
        mesh.flat_faces,
        tuple(panel.name for panel in pattern.panels),
        mesh.face_panel,
        tuple(lines),
        line_names=tuple(names),
    )


def panels_obj(pattern: Pattern, edge_length: float = 2.0, *, metres: bool = True) -> str:
    """`flat_panels` as OBJ; in metres, as Blender's cloth expects it, or in centimetres."""
    from dataclasses import replace

    mesh = flat_panels(pattern, edge_length)
    text = obj_text(replace(mesh, vertices=to_metres(mesh.vertices)) if metres else mesh)
    notes = [
        "# swifttailor panels: flat, placed around the body, with sewing springs",
        f"# units: {'metres' if metres else 'centimetres'}, Y up, the wearer faces +Z",
        "# l: pairs of vertices to be sewn, one group per seam; seam_NUMBER:PANEL.EDGE+PANEL.EDGE",
    ]
    return "\n".join([*notes, *text.splitlines()[3:]]) + "\n"


def write_panels(
    pattern: Pattern, path: Path | str, *, edge_length: float = 2.0, overwrite: bool = False
) -> Path:
    """Writes `panels_obj` in metres.

    Raises:
        PatternError: The pattern cannot be sewn.
        InputError: The file cannot be written.
    """
    return write_bytes(path, panels_obj(pattern, edge_length).encode(), overwrite=overwrite)
