"""Reads back what makes a garment from the folder that `write_files` has filled."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np

from swifttailor.arrays import Floats
from swifttailor.errors import InputError
from swifttailor.garment.folder import GLB, OBJ, PATTERN, REPORT
from swifttailor.garment.formats import read_garment_mesh
from swifttailor.garment.triangle_mesh import TriangleMesh
from swifttailor.panel_mesh import mesh_pattern
from swifttailor.panel_mesh.pattern_mesh import PatternMesh
from swifttailor.panel_mesh.uv_layout import lay_out_uv
from swifttailor.pattern import load_pattern

_MAX_REPORT_BYTES = 64 * 1024 * 1024
_UV_DIGITS = 2e-6
"""Texture coordinates are written with this many digits, or more."""


def read_folder(folder: Path | str) -> tuple[PatternMesh, Floats, dict[str, Any]]:
    """Reads a garment's pattern, mesh, positions and report.

    The panels are meshed anew from pattern.json at the edge length in report.json, which gives back what no
    mesh file holds: which vertices lie on which edge. The positions come from garment.obj, or garment.glb
    where there is none. Both must agree face by face and, flat, to the last digit that is written.

    Args:
        folder: Written by `Garment.save`, hence by every command that makes garments.

    Returns:
        Panel mesh, positions of its welded vertices in cm, and the report: what `Garment` is made of.

    Raises:
        InputError: Something is missing, unreadable, or does not belong together.
        PatternError: The pattern is broken.
    """
    folder = Path(folder)
    if not (folder / PATTERN).is_file():
        raise InputError(
            f"'{folder}' holds no {PATTERN}; it is not the folder of a garment. "
            "Make one with: swifttailor drape PATTERN --out DIR"
        )
    report = read_report(folder / REPORT)
    edge_length = report.get("edge_length_cm")
    if isinstance(edge_length, bool) or not isinstance(edge_length, int | float):
        raise InputError(
            f"'{folder / REPORT}' does not say at which edge length the garment was made: "
            f"'edge_length_cm' is {edge_length!r}, a number of cm is expected. Drape the pattern again."
        )
    reading = report.get("rotation", "intrinsic")
    if reading not in ("intrinsic", "extrinsic"):
        raise InputError(
            f"'{folder / REPORT}': 'rotation' is {reading!r}; 'intrinsic' or 'extrinsic' is accepted."
        )
    pattern = load_pattern(folder / PATTERN, rotation=reading).canonical()
    source = next((folder / name for name in (OBJ, GLB) if (folder / name).is_file()), None)
    if source is None:
        raise InputError(f"'{folder}' holds neither {OBJ} nor {GLB}. Drape the pattern again.")
    mesh = mesh_pattern(pattern, float(edge_length))
    stored = read_garment_mesh(source)
    _require_same_mesh(mesh, stored, folder, source)
    return mesh, stored.vertices, report


def _require_same_mesh(mesh: PatternMesh, stored: TriangleMesh, folder: Path, source: Path) -> None:
    faces = mesh.faces[np.argsort(mesh.face_panel, kind="stable")]  # files hold them panel by panel
    mismatch = ""
    if len(stored.vertices) != mesh.vertex_count or len(stored.faces) != len(faces):
        mismatch = (
            f"it has {len(stored.vertices)} vertices and {len(stored.faces)} faces, the pattern's mesh "
            f"{mesh.vertex_count} and {len(faces)}"
        )
    elif not np.array_equal(stored.faces, faces):
        mismatch = "its faces join other vertices than those of the pattern's mesh"
    elif stored.uv is not None and stored.uv_faces is not None:
        corners = mesh.flat_faces[np.argsort(mesh.face_panel, kind="stable")]
        layouts = [lay_out_uv(mesh, sleeves_upright=now)[0] for now in (True, False)]
        away = min(np.abs(stored.uv[stored.uv_faces] - uv[corners]).max(initial=0.0) for uv in layouts)
        if away > _UV_DIGITS:
            mismatch = f"its texture coordinates differ from the pattern's by up to {away:.2g}"
    if mismatch:
        raise InputError(
            f"'{source}' does not belong to '{folder / PATTERN}': {mismatch}. One of the files was changed, "
            "or another version of SwiftTailor has made them. Drape the pattern again: "
            f"swifttailor drape {folder / PATTERN} --out DIR"
        )


def read_report(path: Path) -> dict[str, Any]:
    """Reads the report of a garment's folder.

    Raises:
        InputError: It cannot be read, or is not a report.
    """
    try:
        if path.stat().st_size > _MAX_REPORT_BYTES:
            raise InputError(f"'{path}' is larger than any report ({_MAX_REPORT_BYTES // 2**20} MB).")
        report = json.loads(path.read_bytes())
    except OSError as error:
        raise InputError(
            f"Cannot read '{path}': {error.strerror or error}. It tells how the garment was meshed."
        ) from error
    except (ValueError, RecursionError) as error:
        raise InputError(f"'{path}' is not a JSON report: {error}. Drape the pattern again.") from error
    if not isinstance(report, dict):
        raise InputError(f"'{path}' is not a report: an object is expected. Drape the pattern again.")
    return report
