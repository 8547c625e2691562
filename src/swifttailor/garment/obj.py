"""Wavefront OBJ: one stitched mesh, a group per panel, in centimetres."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np

from swifttailor.atomic_files import write_text
from swifttailor.garment.triangle_mesh import TriangleMesh

SEAM_GROUP = "seams"


def write_obj(mesh: TriangleMesh, path: Path | str, *, overwrite: bool = False) -> Path:
    """Writes a mesh as OBJ.

    ``v`` are the vertices of the stitched mesh, shared by all panels; ``vt`` are the flat vertices of the
    panels; ``g`` and ``usemtl`` name the panel; seams are ``l`` polylines in groups of their
    names (`seam_names`), or in the group ``seams``.
    """
    return write_text(path, obj_text(mesh), overwrite=overwrite)


def obj_text(mesh: TriangleMesh) -> str:
    """The content of the file that `write_obj` writes."""
    lines = [
        "# swifttailor garment",
        "# units: centimetres, Y up, the wearer faces +Z",
        "# v: stitched vertices shared by all panels; vt: one per panel vertex, origin lower left",
        "o garment",
    ]
    lines += [f"v {x:.6f} {y:.6f} {z:.6f}" for x, y, z in (mesh.vertices + 0.0).tolist()]
    if mesh.uv is not None:
        lines += [f"vt {u:.8f} {v:.8f}" for u, v in mesh.uv.tolist()]
    lines += [f"vn {x:.5f} {y:.5f} {z:.5f}" for x, y, z in (mesh.vertex_normals + 0.0).tolist()]
    names = safe_names(mesh.groups) or ["mesh"]
    group = np.zeros(len(mesh.faces), np.int32) if mesh.face_group is None else mesh.face_group
    for k, name in enumerate(names):
        of_group = np.flatnonzero(group == k)
        lines += [f"g {name}", f"usemtl {name}"]
        faces = (mesh.faces[of_group] + 1).tolist()
        if mesh.uv_faces is None:
            lines += [f"f {a}//{a} {b}//{b} {c}//{c}" for a, b, c in faces]
        else:
            uv = (mesh.uv_faces[of_group] + 1).tolist()
            lines += [
                f"f {a}/{s}/{a} {b}/{t}/{b} {c}/{u}/{c}"
                for (a, b, c), (s, t, u) in zip(faces, uv, strict=True)
            ]
    current = ""
    for k, line in enumerate(mesh.lines):
        name = mesh.line_names[k] if mesh.line_names else SEAM_GROUP
        if len(line) > 1:
            lines += [f"g {name}"] if name != current else []
            lines.append("l " + " ".join(str(v + 1) for v in line.tolist()))
            current = name
    return "\n".join(lines) + "\n"


def safe_names(names: tuple[str, ...]) -> list[str]:
    """Unique names without blanks or control characters, as line-based formats need them."""
    taken: set[str] = set()
    safe = []
    for name in names:
        base = re.sub(r"[\s\x00-\x1f\x7f#\\]+", "_", name) or "panel"
        candidate, number = base, 2
        while candidate in taken or candidate == SEAM_GROUP:
            candidate, number = f"{base}_{number}", number + 1
        taken.add(candidate)
        safe.append(candidate)
    return safe
