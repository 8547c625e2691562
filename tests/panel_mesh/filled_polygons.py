"""What is asked of triangulated polygons."""

from __future__ import annotations

import numpy as np
import shapely
from scipy.spatial import Delaunay

from swifttailor.panel_mesh.topology import topology
from swifttailor.panel_mesh.triangulate import _BULGE


def areas(points, faces):
    a, b, c = (points[faces[:, k]] for k in range(3))
    u, w = b - a, c - a
    return (u[:, 0] * w[:, 1] - u[:, 1] * w[:, 0]) / 2


def assert_fills(boundary, points, faces):
    """The triangles tile the polygon, keep its boundary and are wound like it.

    A triangle flatter than outlines are bent to be triangulated (`triangulate._BULGE`) may be turned.
    """
    polygon = shapely.Polygon(boundary)
    direction = 1 if shapely.LinearRing(boundary).is_ccw else -1
    signed = areas(points, faces) * direction
    sides = points[np.roll(faces, -1, axis=1)] - points[faces]
    longest = (sides**2).sum(axis=2).max(axis=1)
    assert (signed > -_BULGE * longest).all() and (signed > 0).mean() > 0.99
    assert np.isclose(signed.sum(), polygon.area, rtol=1e-9)
    assert np.array_equal(points[: len(boundary)], boundary)
    measured = topology(faces, len(points))
    assert (measured.components, measured.boundary_loops, measured.euler_characteristic) == (1, 1, 1)
    assert measured.nonmanifold_edges == measured.inconsistent_edges == 0
    halves = {(int(f[k]), int(f[(k + 1) % 3])) for f in faces for k in range(3)}
    count = len(boundary)
    assert all((k, (k + 1) % count) in halves for k in range(count))


def delaunay(points):
    found = Delaunay(points)
    faces, neighbors = found.simplices.astype(np.int64), found.neighbors.astype(np.int64)
    turned = areas(points, faces) < 0
    faces[turned], neighbors[turned] = faces[turned][:, ::-1], neighbors[turned][:, ::-1]
    return faces, neighbors
