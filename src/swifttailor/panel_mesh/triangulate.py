"""Triangulation of panels: exact boundary, near-equilateral inside."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
import shapely
from scipy.spatial import Delaunay, QhullError

from swifttailor.arrays import Bools, Floats, Ints, Longs
from swifttailor.errors import GeometryError
from swifttailor.panel_mesh.constrained_edges import interior_triangles, recover_edges
from swifttailor.panel_mesh.smoothing import smooth

_CLEARANCE = 0.62
"""Inner points start this share of the edge length or more from the outline: no sliver fits between."""
_BULGE = 1e-4
_SHARP, _MANY_CORNERS = 0.3, 200
"""Turns, rad, and how many of them no panel for clothes has."""
_MOST_LATTICE_POINTS = 5_000_000
"""In the box around a panel, where a mesh begins: some 250 MB."""


def triangulate_polygon(boundary: Floats, edge_length: float) -> tuple[Floats, Ints]:
    """Fills a simple polygon with triangles of about the given edge length.

    The boundary is kept exactly: no point is added to it or moved. Inside, a triangular lattice is
    connected by a Delaunay triangulation in which missing boundary edges are recovered, then smoothed.

    Args:
        boundary: (n, 2) corners of the closed polygon in cm, in either direction, first not repeated.
        edge_length: Target length of inner edges, cm.

    Returns:
        Points (n + k, 2), the boundary first, and faces (f, 3) wound like the boundary.

    Raises:
        GeometryError: The polygon crosses itself or is too thin to triangulate.
    """
    points, faces, _ = triangulate_polygons([boundary], edge_length, [""])
    return points, faces


def triangulate_polygons(
    boundaries: Sequence[Floats], edge_length: float, names: Sequence[str]
) -> tuple[Floats, Ints, Longs]:
    """Fills several polygons as `triangulate_polygon` does one; the steps they share run on all at once.

    Args:
        boundaries: Closed polygons (n, 2), cm.
        edge_length: Target length of inner edges, cm.
        names: What errors call the polygons; an empty name is left out.

    Returns:
        Points of all polygons one after the other, each polygon's boundary first; faces (f, 3) wound like
        their boundary, in the order of the polygons; and where each polygon's points start (p + 1,).
    """
    counts = np.array([len(b) for b in boundaries], np.int64)
    clockwise = [signed_area(b) < 0 for b in boundaries]
    forward = [b[::-1] if turned else b for b, turned in zip(boundaries, clockwise, strict=True)]
    bulged = np.split(_bulged(np.concatenate(forward), counts), np.cumsum(counts)[:-1])
    pieces, faces, neighbors, following, starts, triangles = [], [], [], [], [0], 0
    for k, boundary in enumerate(forward):
        try:
            inner = _lattice(boundary, edge_length)
            found = _conforming_delaunay(np.concatenate([bulged[k], inner]), len(boundary))
        except GeometryError as error:
            raise GeometryError(f"Panel '{names[k]}': {error}" if names[k] else str(error)) from error
        pieces += [boundary, inner]
        for gathered, own, offset in zip(
            (faces, neighbors, following), found, (starts[-1], triangles, starts[-1]), strict=True
        ):
            gathered.append(np.where(own < 0, -1, own + offset))
        starts.append(starts[-1] + len(boundary) + len(inner))
        triangles += len(faces[-1])
    points, every, after = np.concatenate(pieces), np.concatenate(faces), np.concatenate(following)
    kept = every[interior_triangles(points, every, np.concatenate(neighbors), after)]
    points = smooth(points, kept, after >= 0)

    renumber = np.arange(len(points))
    turned = np.repeat(clockwise, np.diff(starts))
    for k in np.flatnonzero(clockwise):
        own = slice(starts[k], starts[k] + counts[k])
        renumber[own] = renumber[own][::-1]
    kept = renumber[kept]
    kept[turned[kept[:, 0]]] = kept[turned[kept[:, 0]]][:, ::-1]
    return points[renumber], np.ascontiguousarray(kept, np.int32), np.array(starts)


def signed_area(points: Floats) -> float:
    """Area of a closed polygon (n, 2), positive when it runs counter-clockwise."""
    x, y = (points - points.mean(axis=0)).T
    return float(x @ np.roll(y, -1) - np.roll(x, -1) @ y) / 2


def _bulged(points: Floats, counts: Longs) -> Floats:
    """Outlines (counter-clockwise) with every straight run bent outwards by a ten-thousandth of its length.

    Exactly straight rows of points leave Delaunay with triangles of no area, whose winding is chance.

    Args:
        points: (n, 2) outlines one after the other, cm.
        counts: (p,) points of each.
    """
    start = np.repeat(np.cumsum(counts) - counts, counts)
    size = np.repeat(counts, counts)
    own = np.arange(len(points)) - start
    ahead = points[start + (own + 1) % size] - points
    length = np.hypot(ahead[:, 0], ahead[:, 1])
    unit = ahead / np.maximum(length, 1e-12)[:, None]
    behind = unit[start + (own - 1) % size]
    turn = behind[:, 0] * unit[:, 1] - behind[:, 1] * unit[:, 0]
    corner = (np.abs(turn) > 1e-5) | ((behind * unit).sum(axis=1) < 0)
    # Every outline is read from its first corner on, so that no run wraps around its end.
    first = np.array([int(np.argmax(c)) for c in np.split(corner, np.cumsum(counts)[:-1])])
    order = start + (own + np.repeat(first, counts)) % size
    several = np.add.reduceat(corner, np.cumsum(counts) - counts) >= 2
    begins = np.flatnonzero(corner[order] | (own == 0))
    run = np.cumsum(np.isin(np.arange(len(points)), begins)) - 1
    way = np.concatenate([[0.0], np.cumsum(length[order])])
    run_start, run_end = way[begins], way[np.append(begins[1:], len(points))]
    whole = (run_end - run_start)[run]
    t = (way[:-1] - run_start[run]) / np.maximum(whole, 1e-300)
    side = unit[order[begins]][run]
    push = _BULGE * whole * 4 * t * (1 - t) * np.repeat(several, counts)
    bulged = points.copy()
    bulged[order] += push[:, None] * np.stack([side[:, 1], -side[:, 0]], axis=1)
    return bulged


def _lattice(boundary: Floats, edge_length: float) -> Floats:
    """Points of a triangular lattice that lie well inside the polygon, (k, 2)."""
    if len(boundary) < 3:
        raise GeometryError(f"An outline needs 3 points, got {len(boundary)}. Run: swifttailor check PATTERN")
    low, high = boundary.min(axis=0), boundary.max(axis=0)
    expected = float(np.prod((high - low) / edge_length + 1)) * 2 / math.sqrt(3)
    if not expected <= _MOST_LATTICE_POINTS:  # thin and aslant: its own area may be small
        raise GeometryError(
            f"It reaches over {high[0] - low[0]:.0f} x {high[1] - low[1]:.0f} cm; at an edge length of "
            f"{edge_length:g} cm the mesh of that would begin with {expected:.0f} points, and at most "
            f"{_MOST_LATTICE_POINTS} are accepted. Give a larger edge length, or turn the panel."
        )
    rows = np.arange(low[1], high[1], edge_length * math.sqrt(3) / 2)
    columns = np.arange(low[0], high[0] + edge_length, edge_length)
    x, y = np.meshgrid(columns, rows)
    x[1::2] -= edge_length / 2
    points = np.stack([x.ravel(), y.ravel()], axis=1)
    points = points[_well_inside(points, boundary, _CLEARANCE * edge_length)]
    # A trace of noise keeps lattice points off common circles, where Delaunay is not unique.
    return points + np.random.default_rng(0).normal(0.0, 1e-4 * edge_length, points.shape)


def _well_inside(points: Floats, boundary: Floats, clearance: float) -> Bools:
    """Which of some points (k, 2) lie in a polygon (n, 2) and about so far, cm, from its outline."""
    polygon = shapely.Polygon(boundary)
    if _sharp_corners(boundary) <= _MANY_CORNERS:
        core = polygon.buffer(-clearance, quad_segs=4)
        shapely.prepare(core)
        return shapely.contains_xy(core, points[:, 0], points[:, 1])
    # A zigzag set back by more than its teeth crosses itself everywhere: minutes for thousands of them.
    outline = shapely.LinearRing(boundary)
    shapely.prepare([polygon, outline])
    inside = shapely.contains_xy(polygon, points[:, 0], points[:, 1])
    inside[inside] = ~shapely.dwithin(outline, shapely.points(points[inside]), clearance)
    return inside


def _sharp_corners(boundary: Floats) -> int:
    ahead = np.roll(boundary, -1, axis=0) - boundary
    behind = np.roll(ahead, 1, axis=0)
    cross = behind[:, 0] * ahead[:, 1] - behind[:, 1] * ahead[:, 0]
    return int((np.abs(np.arctan2(cross, (behind * ahead).sum(axis=1))) > _SHARP).sum())


def _conforming_delaunay(points: Floats, boundary_count: int) -> tuple[Longs, Longs, Longs]:
    """Triangulates the convex hull of points, of which the first so many form the boundary.

    Returns:
        Faces, neighbours and following as `recover_edges` has them; every boundary edge is among the faces.
    """
    scale = np.ptp(points, axis=0).max()
    try:
        found = Delaunay((points - points.mean(axis=0)) / max(scale, 1e-9))
    except (QhullError, ValueError) as error:
        raise GeometryError(
            f"A panel outline of {len(points)} points is too thin or degenerate to triangulate. "
            "Run: swifttailor check PATTERN"
        ) from error
    faces, neighbors = found.simplices.astype(np.int64), found.neighbors.astype(np.int64)
    corners = points[faces]
    u, w = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    clockwise = u[:, 0] * w[:, 1] - u[:, 1] * w[:, 0] < 0
    faces[clockwise] = faces[clockwise][:, ::-1]
    neighbors[clockwise] = neighbors[clockwise][:, ::-1]
    following = np.full(len(points), -1)
    following[:boundary_count] = (np.arange(boundary_count) + 1) % boundary_count
    return *recover_edges(points, faces, neighbors, following), following
