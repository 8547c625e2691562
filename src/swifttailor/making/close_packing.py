"""Shapes packed closely on a grid: each as low as it goes, then as far left, the largest first."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal

import numpy as np
import shapely

from swifttailor.arrays import Bools, Floats

CELL_CM = 1.0
_REACH_CM = 0.9
"""A shape takes the cells whose middles are this close: two shapes without a cell in common are 3 mm
apart."""
_MOST_CELLS = 600_000
_BESIDE_CM = 0.2
"""Left free around the box of a shape."""
_QUARTER = np.array([[0.0, -1.0], [1.0, 0.0]])
_TURNS = tuple(np.linalg.matrix_power(_QUARTER, k) for k in range(4))


def pack_closely(
    shapes: Sequence[shapely.Polygon], width: float, height: float, *, turns: Literal[1, 2, 4] = 4
) -> list[tuple[Floats, Floats]] | None:
    """Packs shapes into a strip, turned by quarters where that helps; the same every time.

    Args:
        shapes: cm.
        width: Of the strip, cm.
        height: Enough for all of them in any packing, cm.
        turns: Ways in which shapes may lie: upright, on their head too, or on their sides as well.

    Returns:
        Rotation (2, 2) and shift (2,) of each; None where a shape does not fit, or the strip is too large
        to try.
    """
    from scipy.signal import fftconvolve

    columns, rows = int(width / CELL_CM), int(np.ceil(height / CELL_CM))
    if columns * rows > _MOST_CELLS:
        return None
    taken = np.zeros((rows, columns), np.float32)
    placed: list[tuple[Floats, Floats]] = [(_TURNS[0], np.zeros(2))] * len(shapes)
    order = sorted(range(len(shapes)), key=lambda k: (-shapes[k].envelope.area, k))
    used = 1
    for k in order:
        best: tuple[tuple[int, int, int], Bools, Floats, Floats] | None = None
        for number, turn in enumerate(_TURNS[:: 4 // turns]):
            cells, low = _cells(shapes[k], turn)
            if cells.shape[1] > columns or cells.shape[0] > rows:
                continue
            # Nothing lies above `used`, so places up to there are all that can be lowest.
            area = taken[: min(used + cells.shape[0], rows)]
            clashes = fftconvolve(area, cells[::-1, ::-1].astype(np.float32), mode="valid")
            free = np.argwhere(clashes < 0.5)
            if len(free):
                y, x = free[0].tolist()
                key = (y + cells.shape[0], x, number)
                if best is None or key < best[0]:
                    best = key, cells, np.array([x, y]) * CELL_CM - low, turn
        if best is None:
            return None
        (top, x, _), cells, shift, turn = best
        taken[top - cells.shape[0] : top, x : x + cells.shape[1]] += cells
        used = max(used, top)
        placed[k] = turn, shift
    return placed


def _cells(shape: shapely.Polygon, turn: Floats) -> tuple[Bools, Floats]:
    """Cells (h, w) that a turned shape takes, row 0 lowest, and their lower left corner (2,), cm."""
    turned = shapely.transform(shape, lambda points: points @ turn.T)
    low = np.array(turned.bounds[:2]) - _BESIDE_CM
    size = np.ceil((np.array(turned.bounds[2:]) + _BESIDE_CM - low) / CELL_CM).astype(int)
    middles = [low[k] + (np.arange(size[k]) + 0.5) * CELL_CM for k in (0, 1)]
    x, y = np.meshgrid(*middles)
    grown = shapely.buffer(turned, _REACH_CM * CELL_CM)
    shapely.prepare(grown)
    return shapely.contains_xy(grown, x.ravel(), y.ravel()).reshape(x.shape), low
