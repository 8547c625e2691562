"""Where pieces lie on the sheet that is cut into pages."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import shapely

from swifttailor.arrays import Bools, Floats
from swifttailor.errors import InputError
from swifttailor.making.close_packing import pack_closely
from swifttailor.making.paper import Paper, Tile

GAP_CM = 1.0
MOST_PAGES = 600
_MOST_COLUMNS, _CLOSE_COLUMNS = 10, 6
_QUARTER = np.array([[0.0, -1.0], [1.0, 0.0]])


@dataclass(frozen=True, eq=False)
class Sheet:
    """Shapes side by side, and the pages that show some of them."""

    turns: tuple[Floats, ...]
    """(2, 2) rotation of each shape: none, or a quarter turn."""
    shifts: tuple[Floats, ...]
    """(2,) cm, after the rotation."""
    columns: int
    rows: int
    tiles: tuple[Tile, ...]
    """Pages with something on them, row by row from the top."""


def lay_out_sheet(shapes: Sequence[shapely.Polygon], paper: Paper) -> Sheet:
    """Puts shapes side by side so that few pages are needed.

    Args:
        shapes: What is printed; some may be turned by a quarter, since grain lines are printed with them.
        paper: Its printed area is the size of a page.

    Returns:
        The sheet; the lower left corner of page (0, rows - 1) is the origin.

    Raises:
        InputError: More pages would be needed than anybody tapes together.
    """
    width, height = paper.tile
    area = sum(shape.area for shape in shapes) / (width * height)
    if area > MOST_PAGES:
        raise _too_many(area, paper)
    best: tuple[tuple[int, float], Sheet] | None = None
    sizes = np.array([np.subtract(s.bounds[2:], s.bounds[:2]) for s in shapes]) + GAP_CM
    for columns in range(1, _MOST_COLUMNS + 1):
        for rows_of_pages in (0, 1, 2):
            limit = columns * width
            turned = _turned(sizes, limit, rows_of_pages * height)
            placed = np.where(turned[:, None], sizes[:, ::-1], sizes)
            wide = max(limit, float(placed[:, 0].max()))
            corners, _ = skyline(placed, wide)
            sheet = _sheet(shapes, turned, corners, paper)
            cost = (len(sheet.tiles), float(sheet.columns * sheet.rows))
            if best is None or cost < best[0]:
                best = cost, sheet
    assert best is not None
    for columns in range(1, _CLOSE_COLUMNS + 1):
        packed = pack_closely(shapes, columns * width, float(sizes.max(axis=1).sum()))
        if packed is not None:
            sheet = _placed(shapes, [t for t, _ in packed], [s for _, s in packed], paper)
            cost = (len(sheet.tiles), float(sheet.columns * sheet.rows))
            best = (cost, sheet) if cost < best[0] else best
    if len(best[1].tiles) > MOST_PAGES:
        raise _too_many(len(best[1].tiles), paper)
    return best[1]


def _too_many(pages: float, paper: Paper) -> InputError:
    return InputError(
        f"The pattern would take {math.ceil(pages)} pages of {paper.name}; at most {MOST_PAGES} are printed. "
        "Take larger paper, such as --paper a0, or check the pattern's size: swifttailor check PATTERN"
    )


def skyline(sizes: Floats, width: float) -> tuple[Floats, float]:
    """Packs boxes into a strip, each as low as it goes and then as far left, the largest first.

    Args:
        sizes: (n, 2) widths and heights; no width may exceed the strip's.
        width: Of the strip.

    Returns:
        Lower left corners (n, 2) and the height used.
    """
    order = np.lexsort((np.arange(len(sizes)), -sizes[:, 0], -sizes[:, 1]))
    corners = np.zeros((len(sizes), 2))
    line = [(0.0, width, 0.0)]  # from, to, height
    top = 0.0
    for k in order:
        w, h = sizes[k]
        spots = []
        for start, _, _ in line:
            if start + w <= width + 1e-9:
                under = [y for a, b, y in line if b > start + 1e-9 and a < start + w - 1e-9]
                spots.append((max(under), start))
        y, x = min(spots)
        corners[k] = x, y
        top = max(top, y + h)
        pieces = []
        for a, b, level in line:
            if a < x:
                pieces.append((a, min(b, x), level))
            if b > x + w:
                pieces.append((max(a, x + w), b, level))
        line = sorted([p for p in pieces if p[1] - p[0] > 1e-9] + [(x, x + w, y + h)])
    return corners, top


def _turned(sizes: Floats, width: float, height: float) -> Bools:
    """(n,) which boxes lie down: those too wide for the sheet, and those that then need fewer pages."""
    too_wide = (sizes[:, 0] > width + GAP_CM) & (sizes[:, 1] <= width + GAP_CM)
    if height <= 0:
        return too_wide
    flat = (sizes[:, 1] > height) & (sizes[:, 0] <= height) & (sizes[:, 1] <= width)
    return too_wide | flat


def _sheet(shapes: Sequence[shapely.Polygon], turned: Bools, corners: Floats, paper: Paper) -> Sheet:
    """Shapes of which some lie down, each with the lower left corner of its box at a place."""
    turns = [_QUARTER if is_turned else np.eye(2) for is_turned in turned]
    shifts = [
        corner - (shapely.get_coordinates(shape) @ turn.T).min(axis=0)
        for shape, turn, corner in zip(shapes, turns, corners, strict=True)
    ]
    return _placed(shapes, turns, shifts, paper)


def _placed(
    shapes: Sequence[shapely.Polygon], turns: Sequence[Floats], shifts: Sequence[Floats], paper: Paper
) -> Sheet:
    """The pages that shapes lie on."""
    width, height = paper.tile
    moved = [
        shapely.Polygon(shapely.get_coordinates(shape) @ turn.T + shift)
        for shape, turn, shift in zip(shapes, turns, shifts, strict=True)
    ]
    reach = np.array([m.bounds[2:] for m in moved]).max(axis=0)
    columns, rows = (math.ceil(r / size - 1e-9) for r, size in zip(reach, (width, height), strict=True))
    tree = shapely.STRtree(moved)
    tiles = []
    for row in range(rows):
        for column in range(columns):
            low = column * width, (rows - 1 - row) * height
            if len(tree.query(shapely.box(*low, low[0] + width, low[1] + height), predicate="intersects")):
                tiles.append(Tile(column, row))
    return Sheet(tuple(turns), tuple(shifts), columns, rows, tuple(tiles))
