"""Which triangle is seen at which pixel: span filling and a depth buffer in plain numpy.

A pixel belongs to a triangle when its centre lies inside. Borders are half open, so that two triangles
sharing an edge never both claim a pixel nor leave one unclaimed.
"""

from __future__ import annotations

from itertools import pairwise

import numpy as np

from swifttailor.arrays import Array

CHUNK = 1 << 20
"""Fragments worked on at once: what fits the caches, and bounds the memory."""
_DEPTH_STEPS = float(2**31 - 1)
_NOTHING = np.iinfo(np.int64).max


def rasterize(corners: Array, size: tuple[int, int]) -> Array:
    """Finds the nearest triangle at every pixel centre.

    Args:
        corners: (m, 3, 3) triangle corners: x right and y down in pixels, and a depth that is affine over the
            picture, larger farther away. Must be finite.
        size: Width and height in pixels.

    Returns:
        (height, width) int32 triangle indices, -1 where there is none. Of two triangles at the same depth
        the one listed first wins.
    """
    width, height = size
    nearest = np.full(width * height, _NOTHING)
    if len(corners):
        depth = _Depth(corners)
        rows = _rows(corners, width, height)
        for start, stop in _chunks(rows.count):
            _fill(nearest, rows.part(start, stop), depth, width)
    seen = nearest != _NOTHING
    return np.where(seen, nearest & 0xFFFFFFFF, -1).astype(np.int32).reshape(height, width)


def barycentric(corners: Array) -> Array:
    """Coefficients (m, 2, 3) c with weight_k = c[k, 0] x + c[k, 1] y + c[k, 2] of corners 1 and 2.

    Corner 0 has what remains to 1. Triangles without area get zeros, and so their corner 0 throughout.
    """
    x, y = corners[:, :, 0], corners[:, :, 1]
    x1, y1, x2, y2 = x[:, 1] - x[:, 0], y[:, 1] - y[:, 0], x[:, 2] - x[:, 0], y[:, 2] - y[:, 0]
    area = x1 * y2 - x2 * y1
    inverse = np.divide(1.0, area, out=np.zeros_like(area), where=np.abs(area) > 1e-12)
    first = np.stack([y2 * inverse, -x2 * inverse], axis=1)
    second = np.stack([-y1 * inverse, x1 * inverse], axis=1)
    slopes = np.stack([first, second], axis=1)
    constant = -(slopes[:, :, 0] * x[:, :1] + slopes[:, :, 1] * y[:, :1])
    return np.concatenate([slopes, constant[:, :, None]], axis=2)


def depth_at(corners: Array, face: Array, *, fill: float) -> Array:
    """Depth (height, width) of the triangles (m, 3, 3) that `rasterize` found; `fill` where none is."""
    depth = np.full(face.shape, fill)
    rows, columns = np.nonzero(face >= 0)
    seen = face[rows, columns]
    w = barycentric(corners)[seen]
    first = w[:, 0, 0] * (columns + 0.5) + w[:, 0, 1] * (rows + 0.5) + w[:, 0, 2]
    second = w[:, 1, 0] * (columns + 0.5) + w[:, 1, 1] * (rows + 0.5) + w[:, 1, 2]
    z = corners[seen, :, 2]
    value = z[:, 0] + first * (z[:, 1] - z[:, 0]) + second * (z[:, 2] - z[:, 0])
    depth[rows, columns] = np.clip(value, z.min(axis=1), z.max(axis=1))
    return depth


class _Rows:
    """Runs of pixels: one triangle on one row of the picture."""

    def __init__(self, triangle: Array, row: Array, first: Array, count: Array) -> None:
        self.triangle, self.row, self.first, self.count = triangle, row, first, count

    def part(self, start: int, stop: int) -> _Rows:
        s = slice(start, stop)
        return _Rows(self.triangle[s], self.row[s], self.first[s], self.count[s])


def _rows(corners: Array, width: int, height: int) -> _Rows:
    order = np.argsort(corners[:, :, 1], axis=1, kind="stable")
    x = np.take_along_axis(corners[:, :, 0], order, axis=1)
    y = np.take_along_axis(corners[:, :, 1], order, axis=1)
    # Row r has its pixel centres at r + 0.5 and is covered when y_min <= r + 0.5 < y_max.
    top = np.clip(np.ceil(y[:, 0] - 0.5), 0, height).astype(np.int64)
    bottom = np.clip(np.ceil(y[:, 2] - 0.5), 0, height).astype(np.int64)
    across = (x.max(axis=1) > 0.0) & (x.min(axis=1) < width)
    counts = np.where(across, bottom - top, 0)
    triangle = np.repeat(np.arange(len(corners)), counts)
    row = np.arange(len(triangle)) - np.repeat(np.cumsum(counts) - counts - top, counts)
    center = row + 0.5

    def slope(a: int, b: int) -> Array:
        rise = y[:, b] - y[:, a]
        return np.divide(x[:, b] - x[:, a], rise, out=np.zeros_like(rise), where=rise > 0.0)

    def crossing(a: int, b: int) -> Array:
        # Each edge runs from its upper to its lower end in every triangle that has it: equal bits.
        return x[triangle, a] + (center - y[triangle, a]) * slope(a, b)[triangle]

    long_side = crossing(0, 2)
    short_side = np.where(center < y[triangle, 1], crossing(0, 1), crossing(1, 2))
    left = np.ceil(np.minimum(long_side, short_side) - 0.5)
    right = np.ceil(np.maximum(long_side, short_side) - 0.5)
    first = np.clip(left, 0, width).astype(np.int64)
    count = np.clip(right, 0, width).astype(np.int64) - first
    keep = count > 0
    return _Rows(triangle[keep], row[keep], first[keep], count[keep])


def _chunks(counts: Array) -> list[tuple[int, int]]:
    """Ranges of rows with about `CHUNK` fragments each."""
    total = np.cumsum(counts)
    if not len(total):
        return []
    cuts = np.searchsorted(total, np.arange(CHUNK, total[-1], CHUNK), side="left") + 1
    bounds = np.unique(np.concatenate([[0], cuts, [len(counts)]]))
    return [(int(a), int(b)) for a, b in pairwise(bounds)]


def _fill(nearest: Array, rows: _Rows, depth: _Depth, width: int) -> None:
    """Lowers the depth keys of the pixels that the rows cover."""
    triangle, count = rows.triangle, rows.count
    slope, down, constant = depth.plane[triangle].T
    start = slope * (rows.first + 0.5) + down * (rows.row + 0.5) + constant
    ends = np.cumsum(count)
    along = np.arange(ends[-1]) - np.repeat(ends - count, count)
    z = np.repeat(start, count) + along * np.repeat(slope, count)
    # The plane of a sliver can leave the range of its corners within the row; hold it between them.
    z = np.clip(z, np.repeat(depth.low[triangle], count), np.repeat(depth.high[triangle], count))
    key = (z.astype(np.int64) << 32) | np.repeat(triangle, count)
    np.minimum.at(nearest, np.repeat(rows.row * width + rows.first, count) + along, key)


class _Depth:
    """Depth in whole steps as a plane over the picture, one for each triangle."""

    def __init__(self, corners: Array) -> None:
        z = corners[:, :, 2]
        z = (z - z.min()) * (_DEPTH_STEPS / max(float(np.ptp(z)), 1e-12))
        change = z[:, 1:] - z[:, :1]
        weights = barycentric(corners)
        self.plane = change[:, :1] * weights[:, 0] + change[:, 1:] * weights[:, 1]
        self.plane[:, 2] += z[:, 0]
        self.low = np.minimum(np.minimum(z[:, 0], z[:, 1]), z[:, 2])
        self.high = np.maximum(np.maximum(z[:, 0], z[:, 1]), z[:, 2])
