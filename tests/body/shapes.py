"""Small meshes and brute-force references for the tests of `swifttailor.body`."""

from __future__ import annotations

import os
from pathlib import Path

import numpy as np
import pytest


def icosphere(radius: float = 10.0, subdivisions: int = 3, centre=(0.0, 0.0, 0.0)):
    import trimesh

    mesh = trimesh.creation.icosphere(subdivisions=subdivisions, radius=radius)
    return np.asarray(mesh.vertices) + np.asarray(centre), np.asarray(mesh.faces)


def mesh_of(vertices, faces, process: bool = False):
    """The surface as a trimesh, for its checks of soundness."""
    import trimesh

    return trimesh.Trimesh(vertices, faces, process=process)


def brute_force(vertices, faces, points):
    """Signed distances by testing every triangle: distance by clamping to edges, sign by solid angles."""
    a, b, c = (vertices[faces[:, k]].astype(float) for k in range(3))
    out = np.zeros(len(points))
    for n, p in enumerate(points):
        best = np.full(len(faces), np.inf)
        for s, e in ((a, b), (b, c), (c, a)):
            t = np.clip(((p - s) * (e - s)).sum(1) / np.maximum(((e - s) ** 2).sum(1), 1e-300), 0, 1)
            best = np.minimum(best, np.linalg.norm(s + t[:, None] * (e - s) - p, axis=1))
        normal = np.cross(b - a, c - a)
        length = np.maximum(np.linalg.norm(normal, axis=1), 1e-300)
        height = ((p - a) * normal).sum(1) / length
        foot = p - height[:, None] * normal / length[:, None]
        within = np.ones(len(faces), bool)
        for s, e in ((a, b), (b, c), (c, a)):
            within &= (np.cross(e - s, foot - s) * normal).sum(1) >= 0
        best = np.where(within, np.minimum(best, np.abs(height)), best)
        out[n] = best.min() * (-1 if winding(a - p, b - p, c - p) > 0.5 else 1)
    return out


def winding(a, b, c):
    """Winding number about the origin of the triangles a, b, c."""
    la, lb, lc = (np.linalg.norm(x, axis=1) for x in (a, b, c))
    triple = (a * np.cross(b, c)).sum(1)
    rest = la * lb * lc + (a * b).sum(1) * lc + (b * c).sum(1) * la + (c * a).sum(1) * lb
    return 2 * np.arctan2(triple, rest).sum() / (4 * np.pi)


def write_obj(path: Path, vertices, faces) -> Path:
    lines = [f"v {x:.6f} {y:.6f} {z:.6f}" for x, y, z in vertices]
    lines += [f"f {a + 1} {b + 1} {c + 1}" for a, b, c in faces]
    path.write_text("\n".join(lines) + "\n")
    return path


def garmentcode_folder() -> Path:
    """GarmentCode's data, or a skip."""
    chosen = os.environ.get("SWIFTTAILOR_GARMENTCODE")
    root = Path(__file__).resolve().parents[2]
    folder = Path(chosen) if chosen else root.parent / "shared" / "garmentcode"
    if not (folder / "body" / "mean_all.obj").is_file():
        pytest.skip(
            f"GarmentCode's mean body is not at '{folder}'; set SWIFTTAILOR_GARMENTCODE to its folder"
        )
    return folder
