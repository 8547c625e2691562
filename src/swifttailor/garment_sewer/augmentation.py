"""The same garment in other images: mirrored left to right, its panels packed elsewhere.

These work on tables of numpy arrays or torch tensors alike.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np

from swifttailor.arrays import Longs
from swifttailor.garment_sewer.pixels.pixel_table import Array, PixelTable
from swifttailor.ggi.layout import BORDER
from swifttailor.ggi.packing import pack_skyline
from swifttailor.ggi.panel_cells import cell_grid, panel_cells


def mirror_points(points: Array) -> Array:
    """Points or directions (..., 3) with left and right exchanged; a copy."""
    mirrored = points * 1.0
    mirrored[..., 0] *= -1.0
    return mirrored


def mirror(table: PixelTable) -> PixelTable:
    """The table of the garment mirrored left to right, each panel in the place of its box.

    Exact for a body that is symmetric. Pixels keep their order in the table, so that whatever else is known
    of them needs only `mirror_points`.
    """
    size = table.resolution
    both = table.panel_box[:, 0] + table.panel_box[:, 2]
    row, column = table.pixels // size, table.pixels % size
    point, origin = table.point * 1.0, table.panel_origin * 1.0
    point[:, 0] = both[table.panel] + 1 - point[:, 0]
    origin[:, 0] = both + 1 - origin[:, 0]
    # Local x is turned round as well: what was the x axis now points the other way in a mirrored world.
    axes = mirror_points(table.panel_axes)
    axes[:, 0] *= -1.0
    return replace(
        table,
        pixels=row * size + both[table.panel] - column,
        point=point,
        prior=mirror_points(table.prior),
        direction=mirror_points(table.direction),
        panel_color=table.mirror_color,
        mirror_color=table.panel_color,
        panel_origin=origin,
        panel_axes=axes,
        panel_offset=mirror_points(table.panel_offset),
        panel_normal=mirror_points(table.panel_normal),
    )


def move_panels(table: PixelTable, steps: Array) -> PixelTable:
    """The table with each panel moved by whole pixels (p, 2), to where there is room for it."""
    by = steps[table.panel]
    box = table.panel_box * 1
    box[:, :2] += steps
    box[:, 2:] += steps
    return replace(
        table,
        pixels=table.pixels + by[:, 1] * table.resolution + by[:, 0],
        point=table.point + by,
        panel_origin=table.panel_origin + steps,
        panel_box=box,
    )


def random_cells(panel_count: int, resolution: int, chance: np.random.Generator) -> Longs:
    """By how many pixels (p, 2) to move panels of one cell each so that they lie in other cells.

    Args:
        panel_count: Of the garment.
        resolution: Of the image.
        chance: Decides the cells.
    """
    columns, rows = cell_grid(panel_count)
    places = chance.permutation(columns * rows)[:panel_count]
    before, after = (panel_cells(panel_count, resolution, p)[:, :2] for p in (None, places))
    return after - before


def random_steps(
    boxes: np.ndarray[Any, np.dtype[Any]],
    resolution: int,
    chance: np.random.Generator,
    *,
    gutter: int = 2,
    tries: int = 3,
) -> np.ndarray[Any, np.dtype[Any]]:
    """By how many pixels (p, 2) to move panels so that they are packed in another order.

    Where none of `tries` random orders fits, all panels move together within what is free at the image's
    upper and right side.

    Args:
        boxes: (p, 4) as in `PixelTable.panel_box`.
        resolution: Of the image.
        chance: Decides the order, and where the packed panels lie as a whole.
        gutter: Free pixels between panels.
        tries: Orders to try.
    """
    sizes = boxes[:, 2:] - boxes[:, :2] + 1
    corners = boxes[:, :2]
    for _ in range(tries):
        order = chance.permutation(len(sizes))
        placed = pack_skyline(sizes[order] + gutter, resolution - 2 * BORDER + gutter)
        if placed is not None:
            corners = np.zeros_like(corners)
            corners[order] = placed + BORDER
            break
    free = resolution - BORDER - (corners + sizes).max(axis=0)
    below = corners.min(axis=0) - BORDER
    return corners - boxes[:, :2] + chance.integers(-below, free + 1)
