"""Turning the faces of a surface so that all of them look outward."""

from __future__ import annotations

import numpy as np

from swifttailor.arrays import Array


def oriented_outward(vertices: Array, faces: Array) -> Array:
    """Turns faces so that neighbours agree and every connected piece encloses a positive volume.

    Each face appears twice in a graph, as it is and turned; neighbours that agree link like to like, others
    link crosswise. What is linked to the first face of a piece is then consistent with it. A piece that
    cannot be oriented (a Möbius strip) is left as it is.

    Args:
        vertices: (N, 3) positions, cm.
        faces: (M, 3) vertex indices.

    Returns:
        (M, 3) faces in the same order, some of them turned.
    """
    from scipy.sparse import coo_array
    from scipy.sparse.csgraph import connected_components

    count = len(faces)
    one, two, agree = _neighbours(faces)
    start = np.concatenate([one, one + count])
    end = np.concatenate([np.where(agree, two, two + count), np.where(agree, two + count, two)])
    graph = coo_array((np.ones(len(start), np.int8), (start, end)), shape=(2 * count, 2 * count))
    _, label = connected_components(graph, directed=False)
    as_is, turned = label[:count], label[count:]
    piece = np.unique(np.minimum(as_is, turned), return_inverse=True)[1]
    _, first = np.unique(piece, return_index=True)
    turn = (as_is != as_is[first][piece]) & (as_is != turned)
    faces = np.where(turn[:, None], faces[:, ::-1], faces)

    corners = vertices[faces]
    size = np.bincount(piece)[:, None]
    middle = np.stack([np.bincount(piece, corners[:, :, k].mean(axis=1)) for k in range(3)], axis=1) / size
    a, b, c = (corners[:, k] - middle[piece] for k in range(3))
    volume = np.bincount(piece, np.einsum("ij,ij->i", a, np.cross(b, c)))
    return np.where((volume < 0)[piece][:, None], faces[:, ::-1], faces)


def _neighbours(faces: Array) -> tuple[Array, Array, Array]:
    """Pairs of faces that share an edge of exactly two faces, and whether they run through it oppositely."""
    edges = np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]]).astype(np.int64)
    face = np.tile(np.arange(len(faces)), 3)
    low, high = edges.min(axis=1), edges.max(axis=1)
    order = np.lexsort((high, low))
    low, high, face, forward = low[order], high[order], face[order], (edges[:, 0] < edges[:, 1])[order]
    same = (low[1:] == low[:-1]) & (high[1:] == high[:-1])
    alone = np.concatenate([[True], ~same, [True]])  # a group of equal edges starts here
    pair = np.flatnonzero(alone[:-2] & same & alone[2:]) if len(same) else np.zeros(0, np.int64)
    return face[pair], face[pair + 1], forward[pair] != forward[pair + 1]
