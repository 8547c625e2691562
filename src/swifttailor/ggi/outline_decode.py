"""From a geometry image back to a garment whose panels end exactly at the outlines of its pattern.

Unlike the grid of the paper (Alg. 5) this needs the vector pattern. Panels are meshed to their outlines with
seam edges in matching pairs, every vertex reads its position between the pixels around it, and stitched
vertices become one: no staircase along hems, no search for the seams' correspondence.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import csr_array

from swifttailor.arrays import Floats, Longs
from swifttailor.errors import GeometryError, InputError
from swifttailor.garment.garment import Garment
from swifttailor.ggi.layout import Layout
from swifttailor.panel_mesh import mesh_pattern
from swifttailor.panel_mesh.pattern_mesh import PatternMesh

_REACH = 2.5
"""Radius in pixels from which a vertex near the outline gathers its position."""
_FLAT = 0.02
"""Squared pixels: where what was gathered spreads less in a direction, no slope is taken that way."""
_WIDEST_STEP = 3.0
"""Pixels between two samples of an edge; what is wider apart is not joined by a straight line."""
_SAME_POINT = 1e-9


@dataclass(frozen=True, eq=False)
class OutlineSampler:
    """Where each vertex of a mesh reads its position: fixed by layout and mesh, used for any drape."""

    layout: Layout
    mesh: PatternMesh
    weights: csr_array
    """(m, n) from the occupied pixels of the layout to the flat vertices; every row sums to one."""

    @cached_property
    def _merged(self) -> csr_array:
        """(v, n) from the occupied pixels to the welded vertices: the mean of those that a seam joins."""
        weld = self.mesh.weld
        share = 1.0 / np.bincount(weld, minlength=self.mesh.vertex_count)[weld]
        mean = csr_array((share, (weld, np.arange(len(weld)))), shape=(self.mesh.vertex_count, len(weld)))
        return mean @ self.weights

    def positions(self, geometry: NDArray[np.floating]) -> Floats:
        """Positions (v, 3) cm of the welded vertices, from a geometry image (N, N, 3) in cm."""
        size = self.layout.resolution
        if geometry.shape != (size, size, 3):
            raise InputError(
                f"This layout has {size} x {size} pixels; a geometry image of shape {geometry.shape} is not "
                f"of it. Give one of shape ({size}, {size}, 3)."
            )
        seen = geometry.reshape(-1, 3)[self.layout.raster.pixels].astype(np.float64)
        if not np.isfinite(seen).all():
            raise InputError("The geometry image holds positions inside panels that are not finite numbers.")
        return self._merged @ seen


def decode_outline(layout: Layout, geometry: NDArray[np.floating], edge_length: float = 2.0) -> Garment:
    """Makes the garment that a geometry image shows, meshed to the exact outlines of its pattern.

    Args:
        layout: Of the pattern; its raster says what each pixel stands for.
        geometry: (N, N, 3) positions in cm; what lies outside the panels is not read.
        edge_length: Of the mesh, cm.

    Raises:
        InputError: The image is not of this layout, or the edge length is out of range.
        PatternError: The pattern cannot be meshed.
        GeometryError: A panel crosses itself.
    """
    sampler = outline_sampler(layout, mesh_pattern(layout.pattern, edge_length))
    return Garment(sampler.mesh, sampler.positions(geometry))


def outline_sampler(layout: Layout, mesh: PatternMesh) -> OutlineSampler:
    """Finds for every vertex the pixels it reads.

    A vertex on an edge lies between two samples of that edge. One inside is interpolated bilinearly where the
    four pixels around it are inside too; else a plane is fitted to what its panel shows nearby.

    Args:
        layout: Of the mesh's pattern.
        mesh: The panels' mesh, its panels in the order of the layout's.

    Raises:
        InputError: Layout and mesh are of different patterns.
    """
    if mesh.pattern != layout.pattern:
        raise InputError(
            f"The layout is of the pattern '{layout.pattern.name}' and the mesh of another "
            f"('{mesh.pattern.name}'). Mesh the layout's own pattern."
        )
    at = layout.to_pixels(mesh.flat_panel.astype(np.int64), mesh.flat_vertices)
    parts = [_along_edges(layout, mesh)]
    left = np.ones(len(at), np.bool_)
    left[parts[0].vertex] = False
    parts.append(_bilinear(layout, at, mesh.flat_panel, np.flatnonzero(left)))
    left[parts[1].vertex] = False
    parts.append(_fitted(layout, at, mesh.flat_panel, np.flatnonzero(left)))
    row = np.concatenate([np.repeat(p.vertex, p.pixel.shape[1]) for p in parts])
    column = np.concatenate([p.pixel.ravel() for p in parts])
    weight = np.concatenate([p.weight.ravel() for p in parts])
    used = weight != 0
    weights = csr_array((weight[used], (row[used], column[used])), shape=(len(at), len(layout.raster.pixels)))
    return OutlineSampler(layout, mesh, weights)


@dataclass(frozen=True, eq=False)
class _Part:
    """Weights of some vertices."""

    vertex: Longs
    """(k,) flat vertices."""
    pixel: Longs
    """(k, w) occupied pixels, by their place in the raster."""
    weight: Floats
    """(k, w)."""


def _along_edges(layout: Layout, mesh: PatternMesh) -> _Part:
    """Vertices on edges, linearly between the samples that the contour shows of the same edge."""
    raster, outlines = layout.raster, layout.outlines
    edge_count = len(outlines.edge_panel)
    runs = [run for edges in mesh.edge_vertices for run in edges]
    sizes = np.array([len(r) for r in runs], np.int64)
    edge = np.repeat(np.arange(edge_count), sizes)
    step = np.arange(len(edge)) - np.repeat(np.cumsum(sizes) - sizes, sizes)
    wanted = 2.0 * edge + step / (sizes - 1)[edge]

    sample_edge = np.repeat(np.arange(edge_count), np.diff(raster.contour_start))
    slot = np.searchsorted(raster.pixels, raster.contour_pixels)
    following = np.arange(edge_count) + 1
    following[outlines.first_edge[1:] - 1] = outlines.first_edge[:-1]

    def place(of_edge: Longs, fraction: Floats) -> Floats:
        """A number for each point of the outlines; a corner has the same on both its edges."""
        ends = fraction >= 1.0 - _SAME_POINT
        return np.where(ends, 2.0 * following[of_edge], 2.0 * of_edge + np.where(ends, 0.0, fraction))

    # A pixel that several edges pass shows a point of one of them only.
    shown = place(raster.edge[slot].astype(np.int64), raster.fraction[slot])
    own = np.flatnonzero(np.abs(shown - place(sample_edge, raster.contour_fraction)) <= _SAME_POINT)
    known = (2.0 * sample_edge + raster.contour_fraction)[own]
    slot = slot[own]
    if not len(known):
        return _Part(np.zeros(0, np.int64), np.zeros((0, 2), np.int64), np.zeros((0, 2)))

    before = np.searchsorted(known, wanted + _SAME_POINT, side="right") - 1
    after = np.minimum(before + 1, len(known) - 1)
    before = np.maximum(before, 0)
    exact = np.abs(known[before] - wanted) <= 2 * _SAME_POINT
    after[exact] = before[exact]
    apart = known[after] - known[before]
    t = np.divide(wanted - known[before], apart, out=np.zeros(len(wanted)), where=apart > 0)
    gap = raster.points[slot[after]] - raster.points[slot[before]]
    between = (apart > 0) & (sample_edge[own[before]] == edge) & (sample_edge[own[after]] == edge)
    good = exact | (between & (np.hypot(gap[:, 0], gap[:, 1]) <= _WIDEST_STEP))
    # A corner is on two edges; either will do.
    vertex, first = np.unique(np.concatenate(runs)[good], return_index=True)
    chosen = np.flatnonzero(good)[first]
    pixel = np.stack([slot[before[chosen]], slot[after[chosen]]], axis=1)
    return _Part(vertex.astype(np.int64), pixel, np.stack([1 - t[chosen], t[chosen]], axis=1))


def _window(layout: Layout, at: Floats, panel: NDArray, reach: int) -> tuple[Longs, NDArray[np.bool_]]:
    """Pixels (k, w) in a square around points (k, 2), `reach` to each side, and which are of the panel."""
    raster, size = layout.raster, layout.resolution
    slots = raster.spread(np.arange(len(raster.pixels), dtype=np.int32), -1).ravel()
    corner = np.floor(at - 0.5).astype(np.int64) - (reach - 1)
    steps = np.arange(2 * reach)
    column = corner[:, :1, None] + steps[None, None, :]
    row = corner[:, 1:, None] + steps[None, :, None]
    within = (column >= 0) & (column < size) & (row >= 0) & (row < size)
    index = np.clip(row, 0, size - 1) * size + np.clip(column, 0, size - 1)
    found = slots[index].reshape(len(at), 4 * reach**2).astype(np.int64)
    valid = within.reshape(found.shape) & (found >= 0)
    valid &= raster.pixel_panel[found] == panel[:, None]
    return found, valid


def _bilinear(layout: Layout, at: Floats, flat_panel: NDArray, vertices: Longs) -> _Part:
    """Vertices between four inner pixels of their panel, whose values stand for the pixels' centres."""
    pixel, valid = _window(layout, at[vertices], flat_panel[vertices], 1)
    kept = (valid & (layout.raster.edge[pixel] < 0)).all(axis=1)
    vertices, pixel = vertices[kept], pixel[kept]
    x, y = (at[vertices] - 0.5 - np.floor(at[vertices] - 0.5)).T
    weight = np.stack([(1 - x) * (1 - y), x * (1 - y), (1 - x) * y, x * y], axis=1)
    return _Part(vertices, pixel, weight)


def _fitted(layout: Layout, at: Floats, flat_panel: NDArray, vertices: Longs) -> _Part:
    """Vertices near the outline: the value there of a plane through the pixels around (least squares)."""
    raster = layout.raster
    pixel, valid = _window(layout, at[vertices], flat_panel[vertices], 2)
    away = raster.points[pixel] - at[vertices][:, None]
    closeness = np.where(valid, np.maximum(1 - (away**2).sum(axis=2) / _REACH**2, 0.0) ** 2, 0.0)
    total = closeness.sum(axis=1)
    if (total <= 0).any():
        panel = layout.pattern.panels[int(flat_panel[vertices[total <= 0][0]])].name
        raise GeometryError(
            f"Panel '{panel}' has a vertex with no pixel of its panel around it: the mesh does not lie in "
            "the layout. Decode with the layout that the image was drawn with."
        )
    closeness /= total[:, None]
    middle = np.einsum("kw,kwi->ki", closeness, away)
    away -= middle[:, None]
    spread, axes = np.linalg.eigh(np.einsum("kw,kwi,kwj->kij", closeness, away, away))
    # Pixels in a row tell the slope along the row and none across it.
    inverse = np.where(spread > _FLAT, 1.0 / np.maximum(spread, _FLAT), 0.0)
    back = np.einsum("kij,kj,kmj,km->ki", axes, inverse, axes, middle)
    return _Part(vertices, pixel, closeness * (1.0 - np.einsum("kwi,ki->kw", away, back)))
