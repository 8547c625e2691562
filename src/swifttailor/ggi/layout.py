"""Where each panel lies in the images (paper, Alg. 1)."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from swifttailor.arrays import Floats, Longs
from swifttailor.errors import InputError
from swifttailor.ggi.outlines import Outlines, trace_outlines
from swifttailor.ggi.packing import Packing, pack_rows, pack_skyline
from swifttailor.pattern import Pattern

if TYPE_CHECKING:
    from swifttailor.ggi.raster import LayoutRaster


MIN_RESOLUTION, MAX_RESOLUTION = 16, 4096
MIN_GUTTER, MAX_GUTTER = 1, 64
BORDER = 1
"""Free pixels along the sides of the image."""
SCALE_STEP = 1.0005
"""Scales that are tried lie this factor apart."""
MIN_CM_PER_PIXEL, MAX_CM_PER_PIXEL = 1e-6, 1e8
_MAX_ORIGIN = 1e15
PACKINGS: dict[str, tuple[Packing, ...]] = {"skyline": (pack_rows, pack_skyline), "rows": (pack_rows,)}
"""What is tried under each name, each for a finer scale than those before it have reached."""


@dataclass(frozen=True, eq=False)
class Layout:
    """A place for every panel in a square image, all at one scale or each stretched by itself.

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
    stretch: Floats | None = None
    """(p, 2) how many times finer than `cm_per_pixel` each panel is drawn along its x and y; None where all
    are drawn at that scale."""

    def __post_init__(self) -> None:
        origins = np.array(self.origins, np.float64)
        mirrored = np.array(self.mirrored, np.bool_)
        count = len(self.pattern.panels)
        if origins.shape != (count, 2) or mirrored.shape != (count,):
            raise InputError(
                f"A layout of {count} panels has origins of shape ({count}, 2) and mirrored of shape "
                f"({count},), got {origins.shape} and {mirrored.shape}."
            )
        if not (np.abs(origins) <= _MAX_ORIGIN).all():
            raise InputError("A layout's origins must be finite numbers, at most 1e15 pixels.")
        _require_scale(self.cm_per_pixel)
        if self.stretch is not None:
            stretch = np.array(self.stretch, np.float64)
            if stretch.shape != (count, 2) or not ((stretch > 0) & (stretch < np.inf)).all():
                raise InputError(
                    f"A layout of {count} panels has a stretch of shape ({count}, 2) of numbers above 0, got "
                    f"shape {stretch.shape}. Make one with lay_out_in_cells()."
                )
            stretch.flags.writeable = False
            object.__setattr__(self, "stretch", stretch)
        origins.flags.writeable = mirrored.flags.writeable = False
        object.__setattr__(self, "origins", origins)
        object.__setattr__(self, "mirrored", mirrored)

    def to_pixels(self, panel_index: int | Longs, local_points: ArrayLike) -> Floats:
        """Pixel coordinates (n, 2) of points (n, 2) in panel-local cm; one panel index, or one per point."""
        points = np.asarray(local_points, np.float64)
        return self.origins[panel_index] + points * self._factors[panel_index] / self.cm_per_pixel

    def to_local(self, panel_index: int | Longs, pixels: ArrayLike) -> Floats:
        """Panel-local cm (n, 2) of pixel coordinates (n, 2): the inverse of `to_pixels`."""
        points = np.asarray(pixels, np.float64)
        return (points - self.origins[panel_index]) / self._factors[panel_index] * self.cm_per_pixel

    @cached_property
    def _factors(self) -> Floats:
        signs = np.stack([np.where(self.mirrored, -1.0, 1.0), np.ones(len(self.mirrored))], axis=1)
        return signs if self.stretch is None else signs * self.stretch

    @property
    def panel_cm_per_pixel(self) -> Floats:
        """(p, 2) cm from column to column and from row to row of each panel."""
        return self.cm_per_pixel / np.abs(self._factors)

    @cached_property
    def outlines(self) -> Outlines:
        """The panels' outlines, panel-local."""
        return trace_outlines(self.pattern)

    def _with(self, outlines: Outlines) -> Layout:
        """This layout with outlines that were traced before."""
        self.__dict__["outlines"] = outlines
        return self

    @cached_property
    def boxes(self) -> Longs:
        """(p, 4) first column, first row, last column, last row (inclusive) of the pixels of each panel."""
        low, high = self.outlines.bounds
        index = np.arange(len(low))
        ends = np.stack([self.to_pixels(index, low), self.to_pixels(index, high)])
        return np.concatenate([np.floor(ends.min(axis=0)), np.floor(ends.max(axis=0))], axis=1).astype(
            np.int64
        )

    def local_points(self) -> Floats:
        """(n, 2) panel-local cm of the points that the occupied pixels of `raster` stand for."""
        return self.to_local(self.raster.pixel_panel.astype(np.int64), self.raster.points)

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
    packing: str = "skyline",
) -> Layout:
    """Packs the panels of a pattern into a square image (paper, Alg. 1).

    The boxes of the panels are sorted by decreasing height, then width. The finest scale at which they fit is
    found by binary search over a fixed ladder of scales, so that equal patterns give equal layouts.

    Args:
        pattern: Brought into canonical order first.
        resolution: Pixels along each side, 16 to 4096.
        gutter: Free pixels kept between any two panels.
        cm_per_pixel: A scale to use instead of the finest possible one.
        packing: ``rows``, as in the paper, or ``skyline``, which is never worse.

    Raises:
        InputError: An argument is out of range, or the panels do not fit.
    """
    _validate(pattern, resolution, gutter, cm_per_pixel, packing)
    pattern = pattern.canonical()
    outlines = trace_outlines(pattern)
    low, high = outlines.bounds
    boxes = _Boxes(high - low, resolution, gutter)
    corners = None
    if cm_per_pixel is not None:
        found = (boxes.place(place, cm_per_pixel) for place in PACKINGS[packing])
        corners = next((c for c in found if c is not None), None)
    if cm_per_pixel is None or corners is None:
        finest, corners = boxes.place_finest(PACKINGS[packing])
        if cm_per_pixel is not None and cm_per_pixel < finest:
            raise InputError(
                f"At {cm_per_pixel:g} cm per pixel the {len(low)} panels do not fit into {resolution} x "
                f"{resolution} pixels; from {finest:.4g} on they do. Give that many cm per pixel, a higher "
                "resolution, or no scale at all."
            )
        # What fits at a finer scale fits in the same places at a coarser one.
        cm_per_pixel = finest if cm_per_pixel is None else cm_per_pixel
    mirrored = outlines.signed_area < 0
    # What lies lowest and leftmost after mirroring.
    nearest = np.stack([np.where(mirrored, -high[:, 0], low[:, 0]), low[:, 1]], axis=1)
    # The centre of a panel's first pixel lies on the corner of its box.
    origins = corners + (BORDER + 0.5) - nearest / cm_per_pixel
    return Layout(pattern, resolution, float(cm_per_pixel), origins, mirrored)._with(outlines)


class _Boxes:
    """The panels' boxes in the order in which they are packed."""

    def __init__(self, extent: Floats, resolution: int, gutter: int) -> None:
        self.extent = extent
        self.order = np.lexsort((np.arange(len(extent)), -extent[:, 0], -extent[:, 1]))
        self.resolution, self.gutter = resolution, gutter

    def place(self, packing: Packing, scale: float) -> Longs | None:
        """Lower left corners (p, 2) in pixels at a scale in cm per pixel, or None when they do not fit."""
        # Rounding must not make a box one pixel larger than it is reckoned here, hence the tiny excess.
        sizes = np.floor(self.extent[self.order] / scale + (0.5 + 1e-6)).astype(np.int64) + 1
        # The last box of a row needs no gutter, but the sides of the image have a border.
        placed = packing(sizes + self.gutter, self.resolution - 2 * BORDER + self.gutter)
        if placed is None:
            return None
        corners = np.zeros_like(placed)
        corners[self.order] = placed
        return corners

    def place_finest(self, packings: tuple[Packing, ...]) -> tuple[float, Longs]:
        """The finest scale of the ladder that is found, and the corners there."""
        area = float(self.extent.prod(axis=1).sum())
        start = max(max(math.sqrt(area), float(self.extent.max())) / self.resolution, MIN_CM_PER_PIXEL)
        high = math.ceil(math.log(MAX_CM_PER_PIXEL / start) / math.log(SCALE_STEP))
        best = self.place(packings[0], start * SCALE_STEP**high)
        if best is None:
            raise InputError(
                f"{len(self.extent)} panels do not fit into {self.resolution} x {self.resolution} pixels, "
                "however small they are drawn. Give a higher resolution or a smaller gutter."
            )
        for packing in packings:
            low = 0
            while low < high:
                middle = (low + high) // 2
                corners = self.place(packing, start * SCALE_STEP**middle)
                if corners is None:
                    low = middle + 1
                else:
                    high, best = middle, corners
        return start * SCALE_STEP**high, best


def _validate(
    pattern: Pattern, resolution: int, gutter: int, cm_per_pixel: float | None, packing: str
) -> None:
    if not pattern.panels:
        raise InputError("The pattern has no panels; there is nothing to lay out.")
    if not (isinstance(resolution, int) and MIN_RESOLUTION <= resolution <= MAX_RESOLUTION):
        raise InputError(
            f"The resolution is {resolution!r}; from {MIN_RESOLUTION} to {MAX_RESOLUTION} pixels are "
            "accepted. 256 is usual."
        )
    if not (isinstance(gutter, int) and MIN_GUTTER <= gutter <= MAX_GUTTER):
        raise InputError(
            f"The gutter is {gutter!r}; from {MIN_GUTTER} to {MAX_GUTTER} pixels are accepted. 2 is usual."
        )
    if cm_per_pixel is not None:
        _require_scale(cm_per_pixel)
    if packing not in PACKINGS:
        raise InputError(f"There is no packing '{packing}'. Known ones: {', '.join(PACKINGS)}.")


def _require_scale(cm_per_pixel: float) -> None:
    if not MIN_CM_PER_PIXEL <= cm_per_pixel <= MAX_CM_PER_PIXEL:
        raise InputError(
            f"The scale is {cm_per_pixel!r}; from {MIN_CM_PER_PIXEL:g} to {MAX_CM_PER_PIXEL:g} cm per pixel "
            "is accepted."
        )
