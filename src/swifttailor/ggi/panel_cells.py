"""One image for each panel: its box stretched to a cell of its own, the cells of a garment in a grid.

GarmageNet stores garments so, with a square image for every panel. Here the images lie side by side in one
square, so that whatever reads a `Layout` reads these as well. A panel of a few millimetres has as many
pixels as the largest, and neighbouring pixels of one panel are not as far apart along its rows as along its
columns.
"""

from __future__ import annotations

import math
from typing import Literal

import numpy as np

from swifttailor.arrays import Longs
from swifttailor.errors import InputError
from swifttailor.ggi.layout import MAX_RESOLUTION, MIN_CM_PER_PIXEL, MIN_RESOLUTION, Layout, lay_out
from swifttailor.ggi.outlines import trace_outlines
from swifttailor.pattern import Pattern

LayoutKind = Literal["packed", "per_panel"]
"""``packed``: all panels in one square at one scale (`lay_out`); ``per_panel``: each in a cell of its own."""
LAYOUT_KINDS: tuple[LayoutKind, ...] = ("packed", "per_panel")

MIN_CELL = 6
"""Pixels along the shorter side of a cell."""
_MARGIN = 1
"""Free pixels along every side of a cell: panels of neighbouring cells are two apart, as in `lay_out`."""
_THINNEST = 1e-9
"""Panels are stretched as if they were at least this share of the pattern's largest extent wide."""


def lay_out_as(kind: LayoutKind, pattern: Pattern, resolution: int) -> Layout:
    """The layout of a pattern in either way.

    Raises:
        InputError: There is no such kind, or the panels do not fit.
    """
    if kind not in LAYOUT_KINDS:
        raise InputError(f"There is no layout '{kind}'. Known ones: {', '.join(LAYOUT_KINDS)}.")
    return lay_out(pattern, resolution) if kind == "packed" else lay_out_in_cells(pattern, resolution)


def lay_out_in_cells(pattern: Pattern, resolution: int = 256) -> Layout:
    """Stretches each panel to a cell of its own in a grid of equal cells (`panel_cells`).

    The cells are as large as their number allows, so that a pattern of few panels has large ones.

    Args:
        pattern: Brought into canonical order first; its panels fill the grid row by row from below.
        resolution: Pixels along each side of all cells together, 16 to 4096.

    Returns:
        A layout whose `cm_per_pixel` squared is the mean area of a pixel, over the panels' boxes.

    Raises:
        InputError: The resolution is out of range, or too low for so many panels.
    """
    if not pattern.panels:
        raise InputError("The pattern has no panels; there is nothing to lay out.")
    if not (isinstance(resolution, int) and MIN_RESOLUTION <= resolution <= MAX_RESOLUTION):
        raise InputError(
            f"The resolution is {resolution!r}; from {MIN_RESOLUTION} to {MAX_RESOLUTION} pixels are "
            "accepted. 256 is usual."
        )
    pattern = pattern.canonical()
    cells = panel_cells(len(pattern.panels), resolution)
    outlines = trace_outlines(pattern)
    low, high = outlines.bounds
    extent = np.maximum(high - low, max(float((high - low).max()) * _THINNEST, MIN_CM_PER_PIXEL))
    first = cells[:, :2] + _MARGIN + 0.5  # centres of the first and of the last pixel lie on the box
    pixels = cells[:, 2:] - 2 * _MARGIN - 1
    cm_per_pixel = max(math.sqrt(extent.prod(axis=1).sum() / pixels.prod(axis=1).sum()), MIN_CM_PER_PIXEL)
    mirrored = outlines.signed_area < 0
    nearest = np.stack([np.where(mirrored, -high[:, 0], low[:, 0]), low[:, 1]], axis=1)
    origins = first - nearest * pixels / extent
    stretch = pixels / extent * cm_per_pixel
    return Layout(pattern, resolution, cm_per_pixel, origins, mirrored, stretch)._with(outlines)


def panel_cells(count: int, resolution: int, places: Longs | None = None) -> Longs:
    """First column, first row, width and height (p, 4) of the cells of a garment's panels.

    The grid has the least number of columns whose square is no less than the number of panels, and as many
    rows as are needed: cells are square, or higher than wide, as most panels are.

    Args:
        count: Of the panels.
        resolution: Pixels along each side of all cells together.
        places: (p,) numbers of the cells, row by row from below; the first ones when None.

    Raises:
        InputError: The cells would be too small.
    """
    columns, rows = cell_grid(count)
    width, height = resolution // columns, resolution // rows
    if min(width, height) < MIN_CELL:
        raise InputError(
            f"{count} panels in {resolution} x {resolution} pixels have cells of {width} x {height}; at "
            f"least {MIN_CELL} are needed each way. Give a higher resolution, or the layout 'packed'."
        )
    row, column = np.divmod(np.arange(count) if places is None else places, columns)
    size = np.full(count, width), np.full(count, height)
    return np.stack([column * width, row * height, *size], axis=1).astype(np.int64)


def cell_grid(count: int) -> tuple[int, int]:
    """Columns and rows of the cells of so many panels."""
    columns = math.isqrt(count - 1) + 1
    return columns, -(-count // columns)
