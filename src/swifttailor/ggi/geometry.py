"""The geometry image (paper, Alg. 4): where each pixel's piece of cloth is in space."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import csr_array

from swifttailor.arrays import Floats, Ints
from swifttailor.errors import GeometryError, InputError
from swifttailor.ggi.layout import Layout
from swifttailor.panel_mesh.pattern_mesh import PatternMesh

_CANDIDATES = 2_000_000
"""Pairs of face and pixel that are looked at together, to bound the memory."""
_ON_EDGE = 1e-9
"""A pixel's centre this far outside a face, in barycentric coordinates, still counts as inside."""


@dataclass(frozen=True, eq=False)
class GeometryRaster:
    """The hybrid interpolation of Alg. 4 as weights, fixed by a layout and a mesh and used for any drape.

    A pixel of the contour is interpolated linearly between the two vertices of its edge, one of the inside
    barycentrically in its face.
    """

    layout: Layout
    mesh: PatternMesh
    vertices: Ints
    """(n, 3) flat vertices of each occupied pixel of the layout's raster."""
    weights: Floats
    """(n, 3) their weights, which sum to one."""

    @cached_property
    def _operator(self) -> csr_array:
        """(n, v) from welded vertices to occupied pixels."""
        count = len(self.vertices)
        welded = self.mesh.weld[self.vertices].ravel()
        rows = np.arange(0, 3 * count + 1, 3)
        return csr_array((self.weights.ravel(), welded, rows), shape=(count, self.mesh.vertex_count))

    def values(self, vertices: Floats) -> Floats:
        """(n, 3) cm: positions at the occupied pixels, from the (v, 3) welded vertices of a drape."""
        vertices = np.asarray(vertices, np.float64)
        if vertices.shape != (self.mesh.vertex_count, 3):
            raise GeometryError(
                f"This mesh has vertices of shape ({self.mesh.vertex_count}, 3), got {vertices.shape}."
            )
        return self._operator @ vertices

    def image(self, vertices: Floats) -> NDArray[np.float32]:
        """(N, N, 3) cm: the geometry image of a drape; zero outside the panels, which is no position."""
        return self.layout.raster.spread(self.values(vertices).astype(np.float32), 0.0)


def rasterize_geometry(
    layout: Layout, mesh: PatternMesh, vertices: Floats
) -> tuple[NDArray[np.float32], NDArray[np.bool_]]:
    """Draws a drape into a layout (paper, Alg. 4).

    For many drapes of one pattern keep the `geometry_raster` and use its `image`.

    Args:
        layout: Of the mesh's pattern.
        mesh: The panels' mesh.
        vertices: (v, 3) welded vertex positions, cm.

    Returns:
        Positions (N, N, 3) in cm, and occupancy (N, N). Positions mean nothing where nothing is occupied.
    """
    return geometry_raster(layout, mesh).image(vertices), layout.raster.occupancy


def geometry_raster(layout: Layout, mesh: PatternMesh) -> GeometryRaster:
    """Finds for every occupied pixel the vertices it is interpolated from.

    Raises:
        InputError: Layout and mesh are of different patterns.
    """
    raster = layout.raster
    if mesh.pattern is not layout.pattern and mesh.pattern.canonical() != layout.pattern:
        raise InputError(
            f"The layout is of the pattern '{layout.pattern.name}' and the mesh of another "
            f"('{mesh.pattern.name}'). Lay out the mesh's own pattern."
        )
    panel_of = np.array([layout.pattern.panel_index(p.name) for p in mesh.pattern.panels], np.int64)
    flat_panel = panel_of[mesh.flat_panel]
    at = layout.to_pixels(flat_panel, mesh.flat_vertices)
    vertices = np.full((len(raster.pixels), 3), -1, np.int32)
    weights = np.zeros((len(raster.pixels), 3))
    _along_edges(layout, mesh, panel_of, vertices, weights)
    _inside_faces(layout, at, mesh.flat_faces, flat_panel, vertices, weights)
    _beside_the_mesh(layout, mesh, panel_of, at, vertices, weights)
    return GeometryRaster(layout, mesh, vertices, weights)


def _along_edges(
    layout: Layout, mesh: PatternMesh, panel_of: NDArray, vertices: Ints, weights: Floats
) -> None:
    """Linear between the vertices of an edge, which are equally spaced along it."""
    raster, outlines = layout.raster, layout.outlines
    runs = [np.zeros(0, np.int32)] * len(outlines.edge_panel)
    for k, edges in enumerate(mesh.edge_vertices):
        first = int(outlines.first_edge[panel_of[k]])
        runs[first : first + len(edges)] = edges
    lengths = np.array([len(r) for r in runs])
    start = np.cumsum(lengths) - lengths
    along = np.concatenate(runs)
    pixel = np.flatnonzero(raster.edge >= 0)
    edge = raster.edge[pixel]
    segments = lengths[edge] - 1
    position = raster.fraction[pixel] * segments
    before = np.minimum(position.astype(np.int64), segments - 1)
    t = position - before
    vertices[pixel] = along[(start[edge] + before)[:, None] + [0, 1, 1]]
    weights[pixel] = np.stack([1 - t, t, np.zeros_like(t)], axis=1)


def _inside_faces(
    layout: Layout, at: Floats, faces: Ints, flat_panel: NDArray, vertices: Ints, weights: Floats
) -> None:
    """Barycentric at the pixel centres inside each face; of two faces that share an edge the first."""
    raster, size = layout.raster, layout.resolution
    slot = np.full(size * size, -1, np.int64)
    inside = np.flatnonzero(raster.edge < 0)
    slot[raster.pixels[inside]] = inside
    corners = at[faces]
    low = np.clip(np.ceil(corners.min(axis=1) - 0.5), 0, size).astype(np.int64)
    high = np.clip(np.floor(corners.max(axis=1) - 0.5), -1, size - 1).astype(np.int64)
    extent = np.maximum(high - low + 1, 0)
    count = extent.prod(axis=1)
    parts = np.searchsorted(np.cumsum(count), np.arange(_CANDIDATES, count.sum() + _CANDIDATES, _CANDIDATES))
    slopes = _slopes(corners)
    for part in np.split(np.arange(len(faces)), np.unique(parts[:-1]) + 1):
        face = np.repeat(part, count[part])
        step = np.arange(len(face)) - np.repeat(np.cumsum(count[part]) - count[part], count[part])
        row, column = np.divmod(step, extent[face, 0])
        row += low[face, 1]
        column += low[face, 0]
        target = slot[row * size + column]
        wanted = np.flatnonzero(target >= 0)
        face, target = face[wanted], target[wanted]
        x, y = column[wanted] + 0.5 - corners[face, 0, 0], row[wanted] + 0.5 - corners[face, 0, 1]
        (bx, by), (cx, cy) = slopes[:, :, face]
        b, c = bx * x + by * y, cx * x + cy * y
        share = np.stack([1 - b - c, b, c])
        good = (share >= -_ON_EDGE).all(axis=0)  # false for a face without area, whose shares are NaN
        good &= raster.pixel_panel[target] == flat_panel[faces[face, 0]]
        good &= vertices[target, 0] < 0
        # Of repeated indices numpy keeps the last value.
        good = np.flatnonzero(good)[::-1]
        vertices[target[good]] = faces[face[good]]
        weights[target[good]] = share[:, good].T


def _slopes(corners: Floats) -> Floats:
    """How the last two barycentric coordinates grow along x and y, (2, 2, f), in triangles (f, 3, 2).

    A triangle without area has NaN.
    """
    (ux, uy), (vx, vy) = (corners[:, 1] - corners[:, 0]).T, (corners[:, 2] - corners[:, 0]).T
    area = ux * vy - uy * vx
    area = np.where(area == 0, np.nan, area)
    return np.stack([np.stack([vy, -vx]), np.stack([-uy, ux])]) / area


def _beside_the_mesh(
    layout: Layout, mesh: PatternMesh, panel_of: NDArray, at: Floats, vertices: Ints, weights: Floats
) -> None:
    """Pixels between a curved edge and the chords that the mesh has of it: the nearest point of a chord."""
    raster = layout.raster
    left = np.flatnonzero(vertices[:, 0] < 0)
    for k in np.unique(raster.pixel_panel[left]):
        mesh_panel = int(np.flatnonzero(panel_of == k)[0])
        runs = mesh.edge_vertices[mesh_panel]
        start, end = (np.concatenate([r[s] for r in runs]) for s in (slice(None, -1), slice(1, None)))
        a, step = at[start], at[end] - at[start]
        squared = np.maximum((step**2).sum(axis=1), 1e-30)
        of_panel = left[raster.pixel_panel[left] == k]
        for part in np.array_split(of_panel, len(of_panel) * len(start) // _CANDIDATES + 1):
            away = raster.points[part][:, None] - a
            t = np.clip((away * step).sum(axis=2) / squared, 0.0, 1.0)
            distance = ((away - t[..., None] * step) ** 2).sum(axis=2)
            best = distance.argmin(axis=1)
            t = t[np.arange(len(part)), best]
            vertices[part] = np.stack([start[best], end[best], end[best]], axis=1)
            weights[part] = np.stack([1 - t, t, np.zeros_like(t)], axis=1)
