"""Topology of triangle meshes: edges, components, boundary loops, Euler characteristic."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components

from swifttailor.arrays import Ints

_KEY_BITS = 32


@dataclass(frozen=True)
class Topology:
    """Counts that stay the same however a surface is bent."""

    components: int
    boundary_loops: int
    euler_characteristic: int
    nonmanifold_edges: int
    """Edges with more than two faces."""
    inconsistent_edges: int
    """Inner edges whose two faces are wound against each other."""


def edge_faces(faces: Ints) -> tuple[Ints, Ints]:
    """Unique edges (e, 2), ascending, and the number of faces at each (e,)."""
    halves = np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]])
    keys, count = np.unique(edge_keys(halves), return_counts=True)
    return edges_of_keys(keys), count.astype(np.int32)


def edge_keys(halves: Ints) -> NDArray[np.int64]:
    """(h,) a number for each edge (h, 2), whichever way it runs; they ascend as the edges do.

    `numpy.unique` sorts numbers several times as fast as rows.
    """
    first, second = halves.min(axis=1), halves.max(axis=1)
    return (first.astype(np.int64) << _KEY_BITS) | second


def edges_of_keys(keys: NDArray[np.int64]) -> NDArray[np.int32]:
    """(e, 2) the edges that have these `edge_keys` (e,), lower vertex first."""
    return np.stack([keys >> _KEY_BITS, keys & ((1 << _KEY_BITS) - 1)], axis=1).astype(np.int32)


def component_count(faces: Ints, vertex_count: int) -> int:
    """Number of connected pieces; a vertex without faces counts as a piece."""
    links = np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]]])
    graph = coo_array(
        (np.ones(len(links), np.int8), (links[:, 0], links[:, 1])), shape=(vertex_count, vertex_count)
    )
    return int(connected_components(graph, directed=False)[0])


def topology(faces: Ints, vertex_count: int) -> Topology:
    """Measures a mesh of faces (f, 3) over `vertex_count` vertices."""
    edges, count = edge_faces(faces)
    boundary = edges[count == 1]
    loops = 0
    if len(boundary):
        on_boundary, local = np.unique(boundary, return_inverse=True)
        loops = component_count(
            np.concatenate([local.reshape(-1, 2), local.reshape(-1, 2)[:, :1]], axis=1), len(on_boundary)
        )
    halves = np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]])
    directed = np.unique((halves[:, 0].astype(np.int64) << _KEY_BITS) | halves[:, 1], return_counts=True)[1]
    return Topology(
        components=component_count(faces, vertex_count),
        boundary_loops=loops,
        euler_characteristic=vertex_count - len(edges) + len(faces),
        nonmanifold_edges=int((count > 2).sum()),
        inconsistent_edges=int((directed > 1).sum()),
    )
