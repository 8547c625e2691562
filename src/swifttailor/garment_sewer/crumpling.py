"""Cloth that the network predicts crumpled, and how it is smoothed to be let grow.

How the folds of a wide skirt fall is chance, and a network that is to be near all the drapes there might be
predicts their mean: cloth that is nowhere folded and everywhere shorter than it is, and that passes through
itself where the mean of two folds lies. Smoothed, it is a plain cone that does not cross itself; from there
its lengths grow to those that were cut, and it folds without passing through itself (`relaxing.py`).
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import csc_array, diags_array

from swifttailor.arrays import Floats, Ints
from swifttailor.garment_sewer.pixels.rest_shape import flat_gradients, rest_shape
from swifttailor.garment_sewer.pixels.sewn_prior import factorized
from swifttailor.panel_mesh.pattern_mesh import PatternMesh

SHORT = 0.7
"""A face is crumpled where it is shorter than this share of the flat cloth in some direction."""
CRUMPLED = 0.05
"""Share of crumpled cloth from which a garment is taken for crumpled (docs/garment-sewer.md)."""
REACH_CM = 8.0
"""Waves of 2 pi times this are damped to a half."""
_AROUND_CM, _FADE_CM = 8.0, 6.0
"""Around crumpled faces so much is smoothed as well, and over so much more it fades out."""
_KEPT = 50.0
"""How stiffly vertices are held that are not to be smoothed, beside one edge."""


def crumpled_share(mesh: PatternMesh, flat_positions: Floats) -> float:
    """Share of the cloth, by area, that is shorter than `SHORT` in some direction.

    Args:
        mesh: The panels' mesh.
        flat_positions: (m, 3) position of each flat vertex, cm.

    Raises:
        GeometryError: The shape of the positions does not fit the mesh.
    """
    area = rest_shape(mesh).area
    return float(area[is_crumpled(mesh, flat_positions)].sum() / area.sum())


def smoothed_where_crumpled(mesh: PatternMesh, vertices: Floats, held: NDArray[np.bool_]) -> Floats:
    """A garment with its crumpled cloth smoothed; the rest stays where it is.

    Args:
        mesh: The garment's mesh.
        vertices: (v, 3) cm.
        held: (v,) whether each stays, such as those that the garment hangs from: smooth cloth is shorter.

    Returns:
        (v, 3) cm.
    """
    count = len(vertices)
    size = float(
        np.median(np.linalg.norm(np.diff(mesh.flat_vertices[mesh.flat_faces[:, :2]], axis=1), axis=2))
    )
    laplacian, links = _graph(mesh.faces, count)
    near = np.zeros(count)
    corners = rest_shape(mesh).corners[is_crumpled(mesh, vertices[mesh.weld])]
    near[mesh.weld[corners]] = 1.0
    for _ in range(max(1, round(_AROUND_CM / size))):
        near = np.where(links @ near > 0, 1.0, near)
    identity = diags_array(np.ones(count))
    faded = factorized(csc_array(identity + (_FADE_CM / size) ** 2 * laplacian))(near)
    kept = _KEPT * (1.0 - np.clip(1.5 * faded - 0.25, 0.0, 1.0))
    kept[held] = _KEPT
    if (kept == _KEPT).all():
        return vertices.copy()
    own = (size / REACH_CM) ** 2 + kept
    smooth = factorized(csc_array(diags_array(own) + laplacian))(own[:, None] * vertices)
    return np.where((kept == _KEPT)[:, None], vertices, smooth)


def is_crumpled(mesh: PatternMesh, flat_positions: Floats) -> NDArray[np.bool_]:
    """(f,) whether each face that has an area is shorter than `SHORT` in some direction."""
    first, second = np.moveaxis(flat_gradients(mesh, rest_shape(mesh), flat_positions), 1, 0)
    a, b, c = (first * first).sum(1), (first * second).sum(1), (second * second).sum(1)
    # The smaller eigenvalue of [a b; b c] is the square of the smaller stretch.
    least = 0.5 * (a + c - np.hypot(a - c, 2 * b))
    return np.asarray(least < SHORT**2)


def _graph(faces: Ints, count: int) -> tuple[csc_array, csc_array]:
    """(v, v) Laplacian of the edges as a graph, and its neighbours."""
    sides = np.stack([faces, np.roll(faces, -1, axis=1)], axis=-1).reshape(-1, 2)
    rows, columns = np.concatenate([sides, sides[:, ::-1]]).T
    links = csc_array((np.ones(len(rows)), (rows, columns)), shape=(count, count))
    links.data[:] = 1.0
    return csc_array(diags_array(links.sum(axis=1)) - links), links
