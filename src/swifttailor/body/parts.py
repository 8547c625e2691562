"""The parts of a body: torso, head, arms and legs."""

from __future__ import annotations

from collections.abc import Collection
from enum import IntEnum

import numpy as np

from swifttailor.arrays import Array


class BodyPart(IntEnum):
    """Label of a body vertex; left and right are the wearer's."""

    TORSO = 0
    HEAD = 1
    LEFT_ARM = 2
    RIGHT_ARM = 3
    LEFT_LEG = 4
    RIGHT_LEG = 5


ARMS = frozenset({BodyPart.LEFT_ARM, BodyPart.RIGHT_ARM})
"""What skirts and trousers must not touch."""


def face_parts(faces: Array, vertex_part: Array) -> Array:
    """Part of each face: that of at least two of its corners, else the smallest label.

    Args:
        faces: (M, 3) vertex indices.
        vertex_part: (N,) uint8 `BodyPart` of each vertex.

    Returns:
        (M,) uint8.
    """
    labels = np.sort(np.asarray(vertex_part)[faces], axis=1)
    distinct = (labels[:, 0] != labels[:, 1]) & (labels[:, 1] != labels[:, 2])
    return np.where(distinct, labels[:, 0], labels[:, 1]).astype(np.uint8)


def transfer_parts(vertices: Array, reference_vertices: Array, reference_part: Array) -> Array:
    """Labels a mesh by the nearest vertices of a reference body scaled to the same height.

    Both must stand on the floor, on the Y axis, in a similar pose: an arm held very differently from the
    reference's is labelled wrongly.

    Args:
        vertices: (N, 3) positions to label, cm.
        reference_vertices: (R, 3) positions of the labelled body, cm.
        reference_part: (R,) uint8 labels.

    Returns:
        (N,) uint8 `BodyPart` of each vertex.
    """
    from scipy.spatial import KDTree

    scale = vertices[:, 1].max() / reference_vertices[:, 1].max()
    _, nearest = KDTree(reference_vertices * scale).query(vertices)
    return np.asarray(reference_part, np.uint8)[nearest]


def surface_without(
    vertices: Array, faces: Array, vertex_part: Array, without: Collection[BodyPart]
) -> tuple[Array, Array]:
    """The surface with some parts cut off and the cuts closed.

    Every hole that the cut opens is filled (see `fill_holes`), so the rest still has an inside.

    Args:
        vertices: (N, 3) positions, cm.
        faces: (M, 3) vertex indices.
        vertex_part: (N,) uint8 labels.
        without: Parts to cut off.

    Returns:
        Vertices (N + loops, 3) and faces (K, 3) of what remains.
    """
    if not without:
        return vertices, faces
    kept = faces[~np.isin(face_parts(faces, vertex_part), [int(part) for part in without])]
    return fill_holes(vertices, kept, faces)


def fill_holes(vertices: Array, faces: Array, whole: Array | None = None) -> tuple[Array, Array]:
    """Fills every hole with a fan of triangles about the middle of its rim.

    Args:
        vertices: (N, 3) positions.
        faces: (M, 3) vertex indices.
        whole: (K, 3) faces of a surface that `faces` are part of; its own holes stay open.

    Returns:
        Vertices (N + holes, 3), the middles last, and faces (M + rim edges, 3).
    """
    loops = _rims(faces, faces[:0] if whole is None else whole)
    if not loops:
        return vertices, faces
    middles = [vertices[rim[:, 0]].mean(axis=0) for rim in loops]
    fans = [
        np.stack([rim[:, 1], rim[:, 0], np.full(len(rim), len(vertices) + number)], axis=1)
        for number, rim in enumerate(loops)
    ]
    return np.concatenate([vertices, middles]), np.concatenate([faces, *fans]).astype(np.int32)


def _rims(faces: Array, whole: Array) -> list[Array]:
    """Directed edges (E, 2) of each connected boundary of `faces` that is no boundary of `whole`."""
    from scipy.sparse import coo_array
    from scipy.sparse.csgraph import connected_components

    already = {tuple(edge) for edge in _open_edges(whole).tolist()}
    edges = np.array([edge for edge in _open_edges(faces).tolist() if tuple(edge) not in already], np.int64)
    if not len(edges):
        return []
    ids, ends = np.unique(edges, return_inverse=True)
    ends = ends.reshape(-1, 2)
    graph = coo_array((np.ones(len(ends)), (ends[:, 0], ends[:, 1])), shape=(len(ids), len(ids)))
    count, label = connected_components(graph, directed=False)
    return [edges[label[ends[:, 0]] == number] for number in range(count)]


def _open_edges(faces: Array) -> Array:
    """Directed edges (E, 2) that no neighbouring face runs through the other way."""
    edges = np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]]).astype(np.int64)
    base = int(faces.max(initial=0)) + 1
    forward = edges[:, 0] * base + edges[:, 1]
    backward = edges[:, 1] * base + edges[:, 0]
    return edges[~np.isin(forward, backward)]
