"""Straps under the feet as small meshes, from the ends of the legs as they hang."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from swifttailor.garment.trim_pieces import TrimMesh
from swifttailor.pattern.trims.shapes import Stirrup

if TYPE_CHECKING:
    from swifttailor.garment.garment import Garment

_UNDER_CM = 0.25
"""How far under the floor, which bare feet stand on, a strap runs."""
_BESIDE_FOOT, _OUT_CM, _ABOVE_CM = 0.75, 1.2, 1.0
"""How far down beside the foot it is widest, as a part of its way, by how much, and how far it overlaps
the leg, cm."""
_LONGEST_CM = 30.0


def stirrup_mesh(garment: Garment, stirrup: Stirrup) -> TrimMesh | None:
    """A strap from the outside of a leg's end under the foot to its inside; None where the leg ends high up.

    Args:
        garment: What it is on, as it stands on the floor at height 0.
        stirrup: Its edges and width.
    """
    mesh = garment.mesh
    flat = [mesh.edge_vertices[mesh.pattern.panel_index(r.panel)][r.edge] for r in stirrup.edges]
    ring = garment.vertices[np.unique(mesh.weld[np.concatenate(flat)])]
    if float(ring[:, 1].mean()) > _LONGEST_CM:
        return None
    outer, inner = ring[np.argmax(ring[:, 0])], ring[np.argmin(ring[:, 0])]
    depth = float(ring[:, 2].mean())
    down = np.array([-_ABOVE_CM / max(float(outer[1]), 1.0), 0.3, _BESIDE_FOOT, 0.97])
    line = []
    for end, sign in ((outer, 1.0), (inner, -1.0)):
        out = np.interp(down, [0.0, _BESIDE_FOOT, 1.0], [0.1, 1.0, 0.4]) * _OUT_CM
        xs = end[0] + sign * np.maximum(out, 0.15)
        ys = end[1] * (1 - down)
        side = np.stack([xs, ys, np.full(4, depth)], axis=1)
        line.append(side if sign > 0 else side[::-1])
    middle = (line[0][-1] + line[1][0]) / 2
    path = np.concatenate([line[0], [[middle[0], -_UNDER_CM, depth]], line[1]])
    half = np.array([0.0, 0.0, stirrup.width / 2])
    vertices = np.stack([path - half, path + half], axis=1).reshape(-1, 3)
    k = 2 * np.arange(len(path) - 1)
    faces = np.concatenate([np.stack([k, k + 2, k + 3], axis=1), np.stack([k, k + 3, k + 1], axis=1)])
    edges = np.concatenate([np.stack([k, k + 2], axis=1), np.stack([k + 1, k + 3], axis=1)])
    return TrimMesh(stirrup.trim, "cloth", vertices, faces.astype(np.int32), edges.astype(np.int32))
