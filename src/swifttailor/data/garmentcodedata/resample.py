"""Carries a simulated garment over to the panel mesh that a pattern has here."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import KDTree

from swifttailor.arrays import Floats
from swifttailor.data.garmentcodedata.panels import PanelCoordinates
from swifttailor.data.garmentcodedata.split_mesh import SplitMesh
from swifttailor.errors import InputError
from swifttailor.panel_mesh.pattern_mesh import PatternMesh

_NEAR = 24
"""Triangles that are looked at for each point."""
_OUTSIDE_CM = 0.6
"""By how much a point of a panel may lie outside its simulated triangles, as beside a coarse curve."""


def resample(mesh: PatternMesh, simulated: SplitMesh, at: PanelCoordinates) -> tuple[Floats, float]:
    """Positions of the vertices of a panel mesh in a simulated garment.

    Args:
        mesh: The panel mesh of the garment's pattern.
        simulated: The garment.
        at: Where its vertices lie on the panels.

    Returns:
        (v, 3) welded vertices, cm: the mean over the panels that meet there; and the largest distance of a
        panel's own position from that mean, cm.

    Raises:
        InputError: The simulated mesh leaves parts of a panel uncovered.
    """
    flat = np.zeros((len(mesh.flat_vertices), 3))
    face_panel = at.panel[simulated.faces[:, 0]]
    for k, panel in enumerate(mesh.pattern.panels):
        wanted = np.flatnonzero(mesh.flat_panel == k)
        faces = simulated.faces[face_panel == k]
        corners = at.local[faces]
        face, weights, outside = _find(mesh.flat_vertices[wanted], corners)
        if outside > _OUTSIDE_CM:
            raise InputError(
                f"The simulated mesh leaves a part of the panel '{panel.name}' uncovered ({outside:.1f} cm "
                "from the nearest triangle). Do mesh and pattern belong to one garment?"
            )
        flat[wanted] = np.einsum("ij,ijk->ik", weights, simulated.vertices[faces[face]])
    vertices = mesh.welded_mean(flat)
    spread = float(np.linalg.norm(flat - vertices[mesh.weld], axis=1).max())
    return vertices, spread


def _find(points: Floats, corners: Floats) -> tuple[NDArray[np.int64], Floats, float]:
    """Triangle (n,) and barycentric weights (n, 3) of points; the largest distance to a triangle, cm."""
    near = min(_NEAR, len(corners))
    _, candidates = KDTree(corners.mean(axis=1)).query(points, k=near)
    candidates = np.asarray(candidates).reshape(len(points), near)
    a, b, c = (corners[candidates, k] for k in range(3))
    u, v, w = b - a, c - a, points[:, None] - a
    area = _cross(u, v)
    area = np.where(np.abs(area) > 1e-12, area, np.inf)
    second, third = _cross(w, v) / area, _cross(u, w) / area
    shares = np.stack([1 - second - third, second, third], axis=-1)
    inside = np.clip(shares, 0, None)
    inside /= inside.sum(axis=-1, keepdims=True)
    there = np.einsum("nkj,nkjd->nkd", inside, corners[candidates])
    away = np.linalg.norm(there - points[:, None], axis=-1)
    best = away.argmin(axis=1)
    row = np.arange(len(points))
    return candidates[row, best], inside[row, best], float(away[row, best].max(initial=0.0))


def _cross(u: Floats, v: Floats) -> Floats:
    return u[..., 0] * v[..., 1] - u[..., 1] * v[..., 0]
