"""Which pixel of the images shows which point of which panel.

A panel owns the pixels whose centre lies inside its outline, and a contour one pixel wide along the
outline. A pixel of the inside stands for its centre. A pixel of the contour stands for a point *on* the
outline: where the edge passes the middle of the pixel's column (edges that run rather along x) or of its row
(the others), and for the corner where one lies in the pixel. Hence the contour has a pixel for every step of
the outline and no doubled ones, the points along it are about a pixel apart, and samples in a row or column
keep their order.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from swifttailor.arrays import Floats, Ints
from swifttailor.errors import InputError

if TYPE_CHECKING:
    from swifttailor.ggi.layout import Layout


MAX_CROSSINGS = 20_000_000
"""Rows and columns that all outlines together may cross: a hundred times what GarmentCode's patterns do at
4096 pixels."""


@dataclass(frozen=True, eq=False)
class LayoutRaster:
    """The occupied pixels of a layout and what they stand for. Edges are numbered as in `Outlines`."""

    resolution: int
    pixels: Ints
    """(n,) occupied pixels, row * resolution + column, ascending."""
    pixel_panel: NDArray[np.int16]
    """(n,) panel index."""
    points: Floats
    """(n, 2) pixel coordinates of the point each pixel stands for."""
    edge: Ints
    """(n,) number of the edge on which that point lies, or -1 inside."""
    fraction: Floats
    """(n,) where on the edge, as a share of its arc length; 0 inside."""
    contour_pixels: Ints
    """(c,) pixels along the edges, edge by edge in the direction of travel, both corners included. A pixel
    that several edges pass (at corners, in panels thinner than a pixel) is listed with each of them."""
    contour_fraction: Floats
    """(c,) where on the edge."""
    contour_start: Ints
    """(e + 1,) where each edge's pixels begin in `contour_pixels`."""

    @cached_property
    def occupancy(self) -> NDArray[np.bool_]:
        """(N, N) whether a pixel belongs to a panel."""
        return _constant(self.spread(np.ones(len(self.pixels), np.bool_), False))

    @cached_property
    def panel(self) -> NDArray[np.int16]:
        """(N, N) panel index of each pixel, -1 where there is none."""
        return _constant(self.spread(self.pixel_panel, -1))

    def spread(self, values: NDArray, empty: float) -> NDArray:
        """An image (N, N, ...) from values (n, ...) of the occupied pixels."""
        image = np.full((self.resolution**2, *values.shape[1:]), empty, values.dtype)
        image[self.pixels] = values
        return image.reshape(self.resolution, self.resolution, *values.shape[1:])


def _constant(image: NDArray) -> NDArray:
    image.flags.writeable = False  # handed out to everyone who asks
    return image


def rasterize_layout(layout: Layout) -> LayoutRaster:
    """Draws the outlines of a layout; the cost grows with the pixels, not with the panels' size in cm.

    Raises:
        InputError: The layout's panels reach beyond the image, or their outlines are absurdly long.
    """
    outlines, size = layout.outlines, layout.resolution
    _require_boxes_apart(layout)
    at = layout.to_pixels(outlines.panel.astype(np.int64), outlines.points)
    here, there = outlines.segments
    crossings = float(np.abs(at[there] - at[here]).sum())
    if crossings > MAX_CROSSINGS:
        raise InputError(
            f"The outlines cross {crossings:.0f} rows and columns of pixels; at most {MAX_CROSSINGS} are "
            "drawn. Use a lower resolution."
        )
    contour = _thinned(_contour(at, outlines.edge, outlines.fraction, size))
    inside = _inside(at, here, there, size)

    panel = np.full((size, size), -1, np.int16)
    for k, (left, bottom, right, top) in enumerate(layout.boxes.tolist()):
        panel[bottom : top + 1, left : right + 1] = k
    panel[~inside] = -1
    panel = panel.ravel()
    panel[contour.pixel] = outlines.edge_panel[contour.edge]

    pixels = np.flatnonzero(panel >= 0).astype(np.int32)
    points = np.stack([pixels % size + 0.5, pixels // size + 0.5], axis=1)
    edge = np.full(len(pixels), -1, np.int32)
    fraction = np.zeros(len(pixels))
    shown = contour.of_nearest()
    slot = np.searchsorted(pixels, shown.pixel)
    points[slot], edge[slot], fraction[slot] = shown.point, shown.edge, shown.fraction
    start = np.searchsorted(contour.edge, np.arange(len(outlines.edge_panel) + 1)).astype(np.int32)
    return LayoutRaster(
        resolution=size,
        pixels=pixels,
        pixel_panel=panel[pixels],
        points=points,
        edge=edge,
        fraction=fraction,
        contour_pixels=contour.pixel,
        contour_fraction=contour.fraction,
        contour_start=start,
    )


def _require_boxes_apart(layout: Layout) -> None:
    boxes, size = layout.boxes, layout.resolution
    if len(boxes) and (boxes.min() < 0 or boxes.max() >= size):
        raise InputError(
            f"The layout does not fit its image of {size} x {size} pixels: panels reach from pixel "
            f"{boxes.min()} to {boxes.max()}. Make one with lay_out()."
        )
    left, bottom, right, top = boxes.T
    meet = (
        (left[:, None] <= right)
        & (left <= right[:, None])
        & (bottom[:, None] <= top)
        & (bottom <= top[:, None])
    )
    first, second = np.nonzero(np.triu(meet, 1))
    if len(first):
        names = [layout.pattern.panels[int(k)].name for k in (first[0], second[0])]
        raise InputError(
            f"In the layout the boxes of '{names[0]}' and '{names[1]}' overlap. Make one with lay_out()."
        )


@dataclass(frozen=True, eq=False)
class _Contour:
    """Samples of the outlines, sorted by edge and along it, at most one per edge and pixel."""

    point: Floats
    edge: Ints
    fraction: Floats
    pixel: Ints
    is_corner: NDArray[np.bool_]
    size: int

    def take(self, index: NDArray) -> _Contour:
        return _Contour(
            self.point[index],
            self.edge[index],
            self.fraction[index],
            self.pixel[index],
            self.is_corner[index],
            self.size,
        )

    def off_centre(self) -> Floats:
        """Squared distance of each point from the centre of its pixel."""
        center = np.stack([self.pixel % self.size, self.pixel // self.size], axis=1) + 0.5
        return ((self.point - center) ** 2).sum(axis=1)

    def of_nearest(self) -> _Contour:
        """One sample for each pixel: a corner where there is one, else the nearest to the pixel's centre."""
        order = np.lexsort((self.edge, self.off_centre(), ~self.is_corner, self.pixel))
        first = np.concatenate([[True], self.pixel[order][1:] != self.pixel[order][:-1]])
        return self.take(order[first[: len(order)]])


def _contour(at: Floats, edge: Ints, fraction: Floats, size: int) -> _Contour:
    """Samples where the outlines pass the middle of columns or rows, where they turn, and at corners."""
    here = np.flatnonzero(edge[1:] == edge[:-1])
    a, step = at[here], at[here + 1] - at[here]
    major = (np.abs(step[:, 1]) > np.abs(step[:, 0])).astype(np.int64)
    rows = np.arange(len(here))
    start, run = a[rows, major], step[rows, major]
    low, high = np.minimum(start, start + run), np.maximum(start, start + run)
    first = np.ceil(low - 0.5)
    count = np.maximum(np.floor(high - 0.5) - first + 1, 0).astype(np.int64)
    which = np.repeat(rows, count)
    middle = first[which] + (np.arange(len(which)) - np.repeat(np.cumsum(count) - count, count)) + 0.5
    length = run[which]
    t = np.divide(middle - start[which], length, out=np.zeros(len(which)), where=length != 0)
    t = np.clip(t, 0.0, 1.0)[:, None]
    crossing = a[which] + t * step[which]
    crossing[np.arange(len(which)), major[which]] = middle  # exactly, so that rounding moves no sample
    way = fraction[here]
    along = np.clip(way[which] + t[:, 0] * (fraction[here + 1] - way)[which], 0.0, 1.0)

    # Where an edge turns from running along x to running along y, or back, its samples change from one kind
    # to the other and could leave a pixel out.
    sense = major * 2 + (run > 0)
    follows = here[1:] == here[:-1] + 1
    turns = here[1:][follows & (sense[1:] != sense[:-1])]
    ends = np.flatnonzero(np.concatenate([[True], edge[1:] != edge[:-1]]) if len(edge) else [])
    ends = np.concatenate([ends, np.append(ends[1:], len(edge)) - 1]) if len(ends) else ends
    points = np.concatenate([crossing, at[turns], at[ends]])
    corner = np.zeros(len(points), np.bool_)
    corner[len(crossing) + len(turns) :] = True
    cell = np.floor(points).astype(np.int32)
    samples = _Contour(
        points,
        np.concatenate([edge[here][which], edge[turns], edge[ends]]),
        np.concatenate([along, fraction[turns], fraction[ends]]),
        cell[:, 1] * np.int32(size) + cell[:, 0],
        corner,
        size,
    )
    order = np.lexsort((samples.fraction, samples.off_centre(), ~corner, samples.pixel, samples.edge))
    ordered = samples.take(order)
    new = np.ones(len(order), np.bool_)
    new[1:] = (ordered.edge[1:] != ordered.edge[:-1]) | (ordered.pixel[1:] != ordered.pixel[:-1])
    kept = ordered.take(np.flatnonzero(new))
    return kept.take(np.lexsort((kept.fraction, kept.edge)))


def _thinned(contour: _Contour) -> _Contour:
    """Leaves out samples between two pixels that touch, at a corner or along a side, without them."""
    for _ in range(2):
        row, column = contour.pixel // contour.size, contour.pixel % contour.size
        spare = np.zeros(len(row), np.bool_)
        near = (np.abs(row[2:] - row[:-2]) <= 1) & (np.abs(column[2:] - column[:-2]) <= 1)
        spare[1:-1] = near & (contour.edge[2:] == contour.edge[:-2]) & ~contour.is_corner[1:-1]
        # Of several in a row every second one stays, else the contour would get a hole.
        index = np.arange(len(spare))
        last_kept = np.maximum.accumulate(np.where(spare, -1, index))
        spare &= (index - last_kept) % 2 == 1
        if not spare.any():
            break
        contour = contour.take(np.flatnonzero(~spare))
    return contour


def _inside(at: Floats, here: Ints, there: Ints, size: int) -> NDArray[np.bool_]:
    """(N, N) whether the outlines wind around a pixel's centre."""
    (x0, y0), (x1, y1) = at[here].T, at[there].T
    low, high = np.minimum(y0, y1), np.maximum(y0, y1)
    first = np.ceil(low - 0.5).astype(np.int64)
    count = np.maximum(
        np.ceil(high - 0.5).astype(np.int64) - first, 0
    )  # half open: no row counts a joint twice
    which = np.repeat(np.arange(len(here)), count)
    row = first[which] + np.arange(len(which)) - np.repeat(np.cumsum(count) - count, count)
    t = (row + 0.5 - y0[which]) / (y1 - y0)[which]
    column = np.ceil(x0[which] + t * (x1 - x0)[which] - 0.5).astype(np.int64)
    # Anticlockwise outlines run down on the left of what they enclose and up on its right.
    turn = np.where(y1 < y0, 1.0, -1.0)[which]
    steps = np.bincount(row * (size + 1) + np.clip(column, 0, size), turn, size * (size + 1))
    return np.cumsum(steps.reshape(size, size + 1), axis=1)[:, :-1] > 0.5
