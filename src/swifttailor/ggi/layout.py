"""Where each panel lies in the images (paper, Alg. 1)."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from swifttailor.errors import InputError
from swifttailor.ggi.outlines import Outlines, trace_outlines
from swifttailor.ggi.packing import Packing, pack_rows
from swifttailor.pattern import Pattern

if TYPE_CHECKING:
    from swifttailor.ggi.raster import LayoutRaster

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]

MIN_RESOLUTION, MAX_RESOLUTION = 16, 4096
MIN_GUTTER, MAX_GUTTER = 1, 64
BORDER = 1
"""Free pixels along the sides of the image."""
SCALE_STEP = 1.0005
"""Scales that are tried lie this factor apart."""
MAX_CM_PER_PIXEL = 1e4
PACKINGS: dict[str, Packing] = {"rows": pack_rows}


@dataclass(frozen=True, eq=False)
class Layout:
    """A place for every panel in a square image, all at one scale.

    Pixel coordinates: x is the column, y the row, row 0 at the bottom; the centre of the pixel in row r and
    column c is (c + 0.5, r + 0.5). Panels whose loop runs clockwise are mirrored in x, so that every panel is
    seen from the right side of the cloth; none is turned.
    """

    pattern: Pattern
    """In canonical order; panel indices refer to it."""
    resolution: int
    """Pixels along each side of the image."""
    cm_per_pixel: float
    origins: Floats
    """(p, 2) pixel coordinates of each panel's local origin."""
    mirrored: NDArray[np.bool_]
    """(p,) whether local x runs from right to left."""

    def to_pixels(self, panel_index: int | Ints, local_points: ArrayLike) -> Floats:
        """Pixel coordinates (n, 2) of points (n, 2) in panel-local cm; one panel index, or one per point."""
        points = np.asarray(local_points, np.float64)
        return self.origins[panel_index] + points * self._signs[panel_index] / self.cm_per_pixel

    def to_local(self, panel_index: int | Ints, pixels: ArrayLike) -> Floats:
        """Panel-local cm (n, 2) of pixel coordinates (n, 2): the inverse of `to_pixels`."""
        points = np.asarray(pixels, np.float64)
        return (points - self.origins[panel_index]) * self._signs[panel_index] * self.cm_per_pixel

    @cached_property
    def _signs(self) -> Floats:
        return np.stack([np.where(self.mirrored, -1.0, 1.0), np.ones(len(self.mirrored))], axis=1)

    @cached_property
    def outlines(self) -> Outlines:
        """The panels' outlines, panel-local."""
        return trace_outlines(self.pattern)

    @cached_property
    def boxes(self) -> Ints:
        """(p, 4) first column, first row, last column, last row (inclusive) of the pixels of each panel."""
        low, high = self.outlines.bounds
        index = np.arange(len(low))
        ends = np.stack([self.to_pixels(index, low), self.to_pixels(index, high)])
        return np.concatenate([np.floor(ends.min(axis=0)), np.floor(ends.max(axis=0))], axis=1).astype(
            np.int64
        )

    @cached_property
    def raster(self) -> LayoutRaster:
        """Which pixel shows which point of which panel."""
        from swifttailor.ggi.raster import rasterize_layout

        return rasterize_layout(self)


def lay_out(
    pattern: Pattern,
    resolution: int = 256,
    *,
    gutter: int = 2,
    cm_per_pixel: float | None = None,
    packing: str = "rows",
) -> Layout:
    """Packs the panels of a pattern into a square image (paper, Alg. 1).

    The boxes of the panels are sorted by decreasing height, then width. The largest scale at which they fit
    is found by binary search over a fixed ladder of scales, so that equal patterns give equal layouts.

    Args:
        pattern: Brought into canonical order first.
        resolution: Pixels along each side, 16 to 4096.
        gutter: Free pixels kept between any two panels.
        cm_per_pixel: A scale to use instead of the largest possible one.
        packing: ``rows``, as in the paper.

    Raises:
        InputError: An argument is out of range, or the panels do not fit.
    """
    _validate(pattern, resolution, gutter, cm_per_pixel, packing)
    pattern = pattern.canonical()
    outlines = trace_outlines(pattern)
    low, high = outlines.bounds
    extent = high - low
    order = np.lexsort((np.arange(len(extent)), -extent[:, 0], -extent[:, 1]))
    side = resolution - 2 * BORDER + gutter
    place = PACKINGS[packing]

    def corners_at(scale: float) -> Ints | None:
        # The first pixel's centre lies on the box's lower corner. The tiny excess keeps a box whose size is
        # a whole number of pixels from being rounded both ways.
        sizes = np.floor(extent[order] / scale + (0.5 + 1e-9)).astype(np.int64) + 1
        return place(sizes + gutter, side)

    if cm_per_pixel is None:
        cm_per_pixel, corners = _largest_scale(corners_at, extent, resolution)
    else:
        corners = corners_at(cm_per_pixel)
        if corners is None:
            needed = _largest_scale(corners_at, extent, resolution)[0]
            raise InputError(
                f"At {cm_per_pixel:g} cm per pixel the {len(extent)} panels do not fit into {resolution} x "
                f"{resolution} pixels; at {needed:.4g} they do. Give that many cm per pixel, a higher "
                "resolution, or no scale at all."
            )
    mirrored = outlines.signed_area < 0
    # What lies lowest and leftmost after mirroring.
    nearest = np.stack([np.where(mirrored, -high[:, 0], low[:, 0]), low[:, 1]], axis=1)
    origins = np.zeros_like(extent)
    origins[order] = corners + (BORDER + 0.5)
    layout = Layout(pattern, resolution, float(cm_per_pixel), origins - nearest / cm_per_pixel, mirrored)
    layout.__dict__["outlines"] = outlines  # what the cached property would compute again
    return layout


def _largest_scale(
    corners_at: Callable[[float], Ints | None], extent: Floats, resolution: int
) -> tuple[float, Ints]:
    """The finest scale of the ladder at which the boxes fit, in cm per pixel, and their corners."""
    finest = max(float(np.sqrt(extent.prod(axis=1).sum())), float(extent.max()), 1e-6) / resolution
    low, high = 0, int(np.ceil(np.log(MAX_CM_PER_PIXEL / finest) / np.log(SCALE_STEP)))
    if corners_at(MAX_CM_PER_PIXEL) is None:
        raise InputError(
            f"{len(extent)} panels do not fit into {resolution} x {resolution} pixels, however small they "
            "are drawn. Give a higher resolution or a smaller gutter."
        )
    while low < high:
        middle = (low + high) // 2
        if corners_at(finest * SCALE_STEP**middle) is None:
            low = middle + 1
        else:
            high = middle
    scale = finest * SCALE_STEP**high
    corners = corners_at(scale)
    assert corners is not None
    return scale, corners


def _validate(
    pattern: Pattern, resolution: int, gutter: int, cm_per_pixel: float | None, packing: str
) -> None:
    if not pattern.panels:
        raise InputError("The pattern has no panels; there is nothing to lay out.")
    if not MIN_RESOLUTION <= resolution <= MAX_RESOLUTION:
        raise InputError(
            f"The resolution is {resolution}; from {MIN_RESOLUTION} to {MAX_RESOLUTION} pixels are accepted. "
            "256 is usual."
        )
    if not MIN_GUTTER <= gutter <= MAX_GUTTER:
        raise InputError(
            f"The gutter is {gutter}; from {MIN_GUTTER} to {MAX_GUTTER} pixels are accepted. 2 is usual."
        )
    if cm_per_pixel is not None and not 1e-6 <= cm_per_pixel <= MAX_CM_PER_PIXEL:
        raise InputError(
            f"The scale is {cm_per_pixel!r}; from 1e-6 to {MAX_CM_PER_PIXEL:g} cm per pixel are accepted."
        )
    if packing not in PACKINGS:
        raise InputError(f"There is no packing '{packing}'. Known ones: {', '.join(PACKINGS)}.")
