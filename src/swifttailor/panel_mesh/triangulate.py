"""Triangulation of one panel: exact boundary, near-equilateral inside."""

from __future__ import annotations

import math

import numpy as np
import shapely
from numpy.typing import NDArray
from scipy.spatial import Delaunay, QhullError

from swifttailor.errors import GeometryError
from swifttailor.panel_mesh.constrained_edges import interior_triangles, recover_edges

Floats = NDArray[np.float64]
Ints = NDArray[np.int32]

_CLEARANCE = 0.62
"""Interior points keep this share of the edge length from the outline, so that no sliver fits between."""
_SMOOTHING_ROUNDS = 3
_BULGE = 1e-4


def triangulate_polygon(boundary: Floats, edge_length: float) -> tuple[Floats, Ints]:
    """Fills a simple polygon with triangles of about the given edge length.

    The boundary is kept exactly: no point is added to it or moved. Inside, a triangular lattice is
    smoothed and connected by a Delaunay triangulation in which missing boundary edges are recovered.

    Args:
        boundary: (n, 2) corners of the closed polygon in cm, in either direction, first not repeated.
        edge_length: Target length of inner edges, cm.

    Returns:
        Points (n + k, 2), the boundary first, and faces (f, 3) wound like the boundary.

    Raises:
        GeometryError: The polygon crosses itself or is too thin to triangulate.
    """
    area = _signed_area(boundary)
    forward = boundary if area >= 0 else boundary[::-1]
    inner = _lattice(forward, edge_length)
    if len(inner):
        inner = _smooth(forward, inner, edge_length)
    faces = _conforming_delaunay(np.concatenate([_bulged(forward), inner]), len(forward))
    points = np.concatenate([forward, inner])
    if area < 0:
        count = len(boundary)
        renumber = np.arange(len(points), dtype=np.int32)
        renumber[:count] = count - 1 - renumber[:count]
        points = np.concatenate([boundary, inner])
        faces = renumber[faces][:, ::-1]
    return points, np.ascontiguousarray(faces, dtype=np.int32)


def _signed_area(points: Floats) -> float:
    x, y = (points - points.mean(axis=0)).T
    return float(x @ np.roll(y, -1) - np.roll(x, -1) @ y) / 2


def _bulged(boundary: Floats) -> Floats:
    """The outline (counter-clockwise) with every straight run bent outwards by a ten-thousandth.

    Exactly straight rows of points leave Delaunay with triangles of no area, whose winding is chance.
    """
    ahead = np.roll(boundary, -1, axis=0) - boundary
    length = np.linalg.norm(ahead, axis=1)
    unit = ahead / np.maximum(length, 1e-12)[:, None]
    behind = np.roll(unit, 1, axis=0)
    turn = behind[:, 0] * unit[:, 1] - behind[:, 1] * unit[:, 0]
    corners = np.flatnonzero((np.abs(turn) > 1e-5) | ((behind * unit).sum(axis=1) < 0))
    if len(corners) < 2:
        return boundary
    bulged = boundary.copy()
    for first, last in zip(corners, np.roll(corners, -1), strict=True):
        count = (last - first) % len(boundary)
        if count < 2:
            continue
        run = (first + np.arange(count)) % len(boundary)
        way = np.concatenate([[0.0], np.cumsum(length[run])])
        t = way[1:-1] / way[-1]
        outward = np.array([unit[first, 1], -unit[first, 0]])
        bulged[run[1:]] += (_BULGE * way[-1] * 4 * t * (1 - t))[:, None] * outward
    return bulged


def _lattice(boundary: Floats, edge_length: float) -> Floats:
    """Points of a triangular lattice that lie well inside the polygon, (k, 2)."""
    polygon = shapely.Polygon(boundary)
    low, high = boundary.min(axis=0), boundary.max(axis=0)
    rows = np.arange(low[1], high[1], edge_length * math.sqrt(3) / 2)
    columns = np.arange(low[0], high[0] + edge_length, edge_length)
    x, y = np.meshgrid(columns, rows)
    x[1::2] -= edge_length / 2
    points = np.stack([x.ravel(), y.ravel()], axis=1)
    if not len(points):
        return np.zeros((0, 2))
    core = polygon.buffer(-_CLEARANCE * edge_length, quad_segs=4)
    shapely.prepare(core)
    points = points[shapely.contains_xy(core, points[:, 0], points[:, 1])]
    # A trace of noise keeps lattice points off common circles, where Delaunay is not unique.
    return points + np.random.default_rng(0).normal(0.0, 1e-4 * edge_length, points.shape)


def _smooth(boundary: Floats, inner: Floats, edge_length: float) -> Floats:
    """Moves inner points towards their neighbours' mean; points that end too near the outline go."""
    count = len(boundary)
    points = np.concatenate([boundary, inner])
    polygon = shapely.Polygon(boundary)
    shapely.prepare(polygon)
    for _ in range(_SMOOTHING_ROUNDS):
        faces = _delaunay(points)
        centers = points[faces].mean(axis=1)
        faces = faces[shapely.contains_xy(polygon, centers[:, 0], centers[:, 1])]
        total, weight = np.zeros_like(points), np.zeros(len(points))
        for k in range(3):
            for step in (1, 2):
                np.add.at(total, faces[:, k], points[faces[:, (k + step) % 3]])
            np.add.at(weight, faces[:, k], 2)
        moved = weight > 0
        moved[:count] = False
        points[moved] = total[moved] / weight[moved, None]
    inner = points[count:]
    core = polygon.buffer(-0.35 * edge_length, quad_segs=4)
    return inner[shapely.contains_xy(core, inner[:, 0], inner[:, 1])]


def _delaunay(points: Floats) -> NDArray[np.int64]:
    scale = np.ptp(points, axis=0).max()
    try:
        return Delaunay((points - points.mean(axis=0)) / max(scale, 1e-9)).simplices.astype(np.int64)
    except (QhullError, ValueError) as error:
        raise GeometryError(
            f"A panel outline of {len(points)} points is too thin or degenerate to triangulate. "
            "Run: swifttailor check PATTERN"
        ) from error


def _conforming_delaunay(points: Floats, boundary_count: int) -> NDArray[np.int64]:
    faces = _delaunay(points)
    corners = points[faces]
    u, w = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    clockwise = u[:, 0] * w[:, 1] - u[:, 1] * w[:, 0] < 0
    faces[clockwise] = faces[clockwise][:, ::-1]
    start = np.arange(boundary_count)
    boundary = np.stack([start, (start + 1) % boundary_count], axis=1)
    return interior_triangles(recover_edges(points, faces, boundary), boundary)
