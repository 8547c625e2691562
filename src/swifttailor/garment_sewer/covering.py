"""Cloth that bridges hollows of the body: between vertices outside it an edge may still pass through it.

In the cleft of the seat a seam would lie in the hollow, and the skin beside it would show through the cloth.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from swifttailor.arrays import Bools, Floats
from swifttailor.garment_sewer.pixels.body_distance import BodyDistance
from swifttailor.panel_mesh.pattern_mesh import PatternMesh

CLEARANCE_CM = 0.12
"""Distance of the middles of edges from the body."""
ROUNDS = 10


def cover_body(mesh: PatternMesh, vertices: Floats, body: BodyDistance, ignores_arms: Bools) -> Floats:
    """Moves vertices until the middles of edges are outside the body, too.

    Each takes the mean of what the edges at it need. Of the two sides of a hollow what points sideways is
    opposite, so that a seam in it comes out.

    Args:
        mesh: Of the garment.
        vertices: (v, 3) welded, outside the body, cm.
        body: Kept out of.
        ignores_arms: (v,) whether each vertex passes through the arms.

    Returns:
        (v, 3) cm.
    """
    vertices, edges = vertices.copy(), _edges(mesh)
    for _ in range(ROUNDS):
        ignores = ignores_arms[edges[:, 0]] | ignores_arms[edges[:, 1]]
        distance, direction = body.sample(vertices[edges].mean(axis=1), ignores)
        inside = np.flatnonzero(distance < CLEARANCE_CM)
        if not len(inside):
            break
        push = direction[inside] * (CLEARANCE_CM - distance[inside])[:, None]
        ends = edges[inside].ravel()
        moved, at = np.unique(ends, return_inverse=True)
        total = np.zeros((len(moved), 3))
        np.add.at(total, at, np.repeat(push, 2, axis=0))
        vertices[moved] += total / np.bincount(at)[:, None]
        touched = np.zeros(len(vertices), bool)
        touched[moved] = True
        edges = edges[touched[edges].any(axis=1)]  # no others have moved
    return vertices


def _edges(mesh: PatternMesh) -> NDArray[np.int64]:
    """(e, 2) of the welded mesh, each once."""
    sides = np.sort(mesh.faces[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1).astype(np.int64)
    keys = np.unique(sides[:, 0] * mesh.vertex_count + sides[:, 1])
    return np.stack([keys // mesh.vertex_count, keys % mesh.vertex_count], axis=1)
