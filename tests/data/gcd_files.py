"""Writes folders in the layout of GarmentCodeData and GCD-MM, with the traps that the real ones have."""

from __future__ import annotations

import json
import pickle
from pathlib import Path

import numpy as np

from swifttailor.panel_mesh.pattern_mesh import PatternMesh
from swifttailor.pattern import Pattern, to_specification

BODY_SAMPLE = "00042"


class Bomb:
    """Leaves a mark when somebody unpickles it."""

    def __init__(self, mark: str) -> None:
        self.mark = mark

    def __reduce__(self):
        return open, (self.mark, "w")


def specification_of(pattern: Pattern) -> dict:
    """As GarmentCode writes it: the object of panels is in no order, `panel_order` is the order."""
    specification = to_specification(pattern)
    panels = specification["pattern"]["panels"]
    specification["pattern"]["panels"] = {name: panels[name] for name in sorted(panels, reverse=True)}
    return specification


def write_sample(
    folder: Path,
    mesh: PatternMesh,
    vertices: np.ndarray,
    *,
    random_body: bool = False,
    uv_scale: tuple[float, float] | None = None,
    lost_vertex: bool = False,
    encoding: str = "binary",
) -> Path:
    """Writes one garment.

    Args:
        folder: Its folder; the name is the garment's.
        mesh: Simulated, in the order of the pattern's panels.
        vertices: (v, 3) welded vertices, cm.
        random_body: Whether the measurements name a random body.
        uv_scale: Of the texture coordinates; when None width and height of the texture, as in GarmentCode.
        lost_vertex: Whether the OBJ had a vertex without faces, which the PLY has lost.
        encoding: Of the PLY.
    """
    import trimesh

    folder.mkdir(parents=True)
    name = folder.name

    def file(ending: str) -> Path:
        return folder / f"{name}_{ending}"

    file("specification.json").write_text(json.dumps(specification_of(mesh.pattern)))
    order, lines = _seams_first(mesh)
    if lost_vertex:
        lines.insert(len(lines) // 2, mesh.pattern.panels[0].name)
    uv = _islands(mesh, uv_scale)
    rank = np.argsort(order)
    faces = rank[mesh.faces]
    for kind, moved in (("sim", 0.0), ("boxmesh", 30.0)):
        obj = folder / "temporary.obj"
        text = [f"v {x:.6f} {y:.6f} {z:.6f}" for x, y, z in vertices[order] + moved]
        text += [f"vt {u:.9f} {v:.9f}" for u, v in uv]
        text += [
            "f " + " ".join(f"{v + 1}/{t + 1}" for v, t in zip(*corner, strict=True))
            for corner in zip(faces.tolist(), mesh.flat_faces.tolist(), strict=True)
        ]
        obj.write_text("\n".join(text) + "\n")
        trimesh.load_mesh(obj).export(file(f"{kind}.ply"), encoding=encoding)
        obj.unlink()
    file("sim_segmentation.txt").write_text("\n".join(lines) + "\n")
    file("orig_lens.pickle").write_bytes(pickle.dumps(Bomb(str(folder / "mark"))))
    file("design_params.yaml").write_text("design:\n  skirt:\n    length:\n      v: 0.4\n      type: float\n")
    measured = "body:\n  height: 171.99\n  waist: 84.33\n"
    if random_body:
        measured += f"  body_sample: '{BODY_SAMPLE}'\n"
    file("body_measurements.yaml").write_text(measured)
    (folder / "sim_props.yaml").write_text("sim:\n  config: {}\n")
    for side in ("front", "back"):
        file(f"render_{side}.png").write_bytes(b"\x89PNG\r\n\x1a\n")
    return folder


def write_failures(path: Path, **kinds: list[str]) -> None:
    """Writes dataset_properties_*.yaml."""
    lines = ["sim:", "  stats:", "    fails:"]
    for kind, names in kinds.items():
        lines += (
            [f"      {kind}:", *(f"      - {name}" for name in names)] if names else [f"      {kind}: []"]
        )
    path.write_text("\n".join(lines) + "\n")


def _seams_first(mesh: PatternMesh) -> tuple[np.ndarray, list[str]]:
    """Old index of each vertex in GarmentCode's order, and the segmentation."""
    on_seam: dict[int, list[int]] = {}
    for seam in mesh.seams:
        for vertex in seam.vertices.tolist():
            on_seam.setdefault(vertex, []).append(seam.stitch)
    order, lines = list(on_seam), [",".join(f"stitch_{k}" for k in on_seam[v]) for v in on_seam]
    for k, panel in enumerate(mesh.pattern.panels):
        own = [v for v in dict.fromkeys(mesh.weld[mesh.flat_panel == k].tolist()) if v not in on_seam]
        order += own
        lines += [panel.name] * len(own)
    return np.array(order), lines


def _islands(mesh: PatternMesh, scale: tuple[float, float] | None) -> np.ndarray:
    """(m, 2) texture coordinates: panels in columns with 3 cm between them, each axis scaled by itself."""
    uv = mesh.flat_vertices.copy()
    rows = max(1, int(len(mesh.pattern.panels) ** 0.5))
    x = y = widest = 0.0
    for k in range(len(mesh.pattern.panels)):
        own = mesh.flat_panel == k
        if k % rows == 0:
            x, y, widest = x + widest + 3.0, 3.0, 0.0
        low, high = uv[own].min(axis=0), uv[own].max(axis=0)
        uv[own] += np.array([x, y]) - low
        widest, y = max(widest, high[0] - low[0]), y + high[1] - low[1] + 3.0
    return uv / (uv.max(axis=0) + 3.0 if scale is None else np.array(scale))
