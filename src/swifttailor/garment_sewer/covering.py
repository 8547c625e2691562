"""Cloth that bridges hollows of the body: between vertices outside it an edge may still pass through it.

In the cleft of the seat a seam would lie in the hollow, and the skin beside it would show through the cloth.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from swifttailor.arrays import Bools, Floats, Ints
from swifttailor.body import Body
from swifttailor.garment_sewer.pixels.body_distance import BodyDistance
from swifttailor.panel_mesh.pattern_mesh import PatternMesh

CLEARANCE_CM = 0.12
"""Distance of the middles of edges from the body."""
ROUNDS = 10
CLEFT_CM, _BESIDE_CLEFT_CM = 0.6, 0.3
"""The same in the cleft of the seat, which the body's distances know too coarsely, and beside it."""
_CLEFT_HALF_CM = 3.0
_ABOVE_HIPS_CM, _BELOW_HIPS_CM = 8.0, 14.0
"""From where to where the cleft reaches."""


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
    return _covered(vertices, _edges(mesh), body, ignores_arms, CLEARANCE_CM)


def cover_cleft(mesh: PatternMesh, vertices: Floats, body: Body) -> Floats:
    """Moves cloth that has sunk into the cleft of the seat out of it, or the skin beside it shows.

    Args:
        mesh: Of the garment.
        vertices: (v, 3) welded, cm.
        body: What it is worn by.

    Returns:
        (v, 3) cm; the vertices themselves where nothing lies there.
    """
    hips = body.measurements.hips_level
    x, y, z = vertices.T
    near = (np.abs(x) < _CLEFT_HALF_CM) & (z < 0)
    near &= (y < hips + _ABOVE_HIPS_CM) & (y > hips - _BELOW_HIPS_CM)
    faces = mesh.faces[near[mesh.faces].all(axis=1)]
    if not len(faces):
        return vertices
    edges = _unique_edges(faces, mesh.vertex_count)
    aside = np.abs(x[edges].mean(axis=1)) / _CLEFT_HALF_CM
    clearance = CLEFT_CM + (_BESIDE_CLEFT_CM - CLEFT_CM) * aside
    ignores_arms = np.ones(len(vertices), bool)
    return _covered(vertices, edges, BodyDistance.of(body), ignores_arms, clearance)


def _covered(
    vertices: Floats,
    edges: NDArray[np.int64],
    body: BodyDistance,
    ignores_arms: Bools,
    clearance: Floats | float,
) -> Floats:
    """Moved until the middles of edges (e, 2) are as far from the body as `clearance` says, cm."""
    vertices = vertices.copy()
    wanted = np.broadcast_to(clearance, len(edges))
    for _ in range(ROUNDS):
        ignores = ignores_arms[edges[:, 0]] | ignores_arms[edges[:, 1]]
        distance, direction = body.sample(vertices[edges].mean(axis=1), ignores)
        inside = np.flatnonzero(distance < wanted)
        if not len(inside):
            break
        push = direction[inside] * (wanted - distance)[inside, None]
        ends = edges[inside].ravel()
        moved, at = np.unique(ends, return_inverse=True)
        total = np.zeros((len(moved), 3))
        np.add.at(total, at, np.repeat(push, 2, axis=0))
        vertices[moved] += total / np.bincount(at)[:, None]
        touched = np.zeros(len(vertices), bool)
        touched[moved] = True
        again = touched[edges].any(axis=1)  # no others have moved
        edges, wanted = edges[again], wanted[again]
    return vertices


def _edges(mesh: PatternMesh) -> NDArray[np.int64]:
    """(e, 2) of the welded mesh, each once."""
    return _unique_edges(mesh.faces, mesh.vertex_count)


def _unique_edges(faces: Ints, count: int) -> NDArray[np.int64]:
    """(e, 2) of faces, each once."""
    sides = np.sort(faces[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1).astype(np.int64)
    keys = np.unique(sides[:, 0] * count + sides[:, 1])
    return np.stack([keys // count, keys % count], axis=1)
