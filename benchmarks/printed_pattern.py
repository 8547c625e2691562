"""Measures printed patterns in pixels: the test square, and cut lines beside pattern plus allowance.

    .venv/bin/python benchmarks/printed_pattern.py tests/garmentcode_patterns/patterns.jsonl.gz --limit 5

Pages are rendered by pdftoppm (Poppler), or by pdfium where there is none.
"""

from __future__ import annotations

import argparse
import shutil
import subprocess
import tempfile
from collections.abc import Iterator
from itertools import islice
from pathlib import Path

import numpy as np

from swifttailor.making import CuttingPlan, cutting_plan
from swifttailor.making.overlaps import sampled
from swifttailor.making.paper import MARGIN_CM, Paper
from swifttailor.making.pattern_pdf import PrintedPattern, write_pdf
from swifttailor.pattern.pattern_list import read_patterns

CM_PER_INCH = 2.54
_WINDOW_CM = 0.06
"""Half the length of the profile across a line."""
_CLEAR_CM = 0.35
"""Points closer to notches, corners, page borders or other cut lines are left out."""


def render(pdf: Path, dpi: int, *, first: int = 1, last: int | None = None) -> Iterator[np.ndarray]:
    """Pages (h, w) as darkness from 0 to 1, row 0 at the top."""
    if shutil.which("pdftoppm"):
        from PIL import Image

        for page in range(first, (last or first) + 1):
            with tempfile.TemporaryDirectory() as folder:
                command = ["pdftoppm", "-r", str(dpi), "-f", str(page), "-l", str(page), "-gray", str(pdf)]
                subprocess.run([*command, f"{folder}/p"], check=True)
                (file,) = Path(folder).iterdir()
                yield 1.0 - np.asarray(Image.open(file), np.float64) / 255.0
        return
    import pypdfium2

    document = pypdfium2.PdfDocument(pdf)
    for page in range(first - 1, last or first):
        picture = document[page].render(scale=dpi / 72, grayscale=True).to_numpy()
        yield 1.0 - np.atleast_3d(picture)[..., 0].astype(np.float64) / 255.0


def test_square_cm(darkness: np.ndarray, dpi: int) -> tuple[float, float]:
    """Width and height of the black rectangle on a cover page."""
    height = len(darkness)
    dark = darkness > 0.75
    scale = CM_PER_INCH / dpi
    # The longest dark runs are its sides; both are found between the middles of their lines.
    columns = dark[: height // 3, : int(14 / scale)].sum(axis=0) * scale
    rows = dark[: height // 3, : int(14 / scale)].sum(axis=1) * scale
    return _between(columns, 4.5, scale), _between(rows, 9.0, scale)


def _between(lengths: np.ndarray, least: float, scale: float) -> float:
    at = np.flatnonzero(lengths > least)
    groups = np.split(at, np.flatnonzero(np.diff(at) > 3) + 1)
    first, last = (float(np.mean(g)) for g in (groups[0], groups[-1]))
    return (last - first) * scale


def outline_errors(plan: CuttingPlan, printed: PrintedPattern, dpi: int) -> np.ndarray:
    """Distances in mm of printed cut lines from the pattern's edges plus allowance, over all pages."""
    tile_width, tile_height = printed.paper.tile
    expected = [_expected(plan, k, printed) for k in range(len(plan.pieces))]
    points = np.concatenate([e[0] for e in expected])
    normals = np.concatenate([e[1] for e in expected])
    cover = printed.pages - len(printed.sheet.tiles) - printed.steps_pages
    errors = []
    scale = dpi / CM_PER_INCH
    for number, tile in enumerate(printed.sheet.tiles):
        low = np.array([tile.column * tile_width, (printed.sheet.rows - 1 - tile.row) * tile_height])
        local = points - low
        on_page = ((local > 0.8) & (local < np.array([tile_width, tile_height]) - 0.8)).all(axis=1)
        if not on_page.any():
            continue
        (picture,) = render(printed.path, dpi, first=cover + number + 1)
        at = (local[on_page] + MARGIN_CM) * scale
        at[:, 1] = picture.shape[0] - at[:, 1]
        across = normals[on_page] * (1.0, -1.0) * scale
        steps = np.linspace(-_WINDOW_CM, _WINDOW_CM, 41)
        places = at[:, None] + steps[None, :, None] * across[:, None]
        columns, rows = np.floor(places).astype(int).transpose(2, 0, 1)
        values = picture[rows.clip(0, picture.shape[0] - 1), columns.clip(0, picture.shape[1] - 1)]
        weight = values.sum(axis=1)
        assert (weight > 0).all(), "a cut line is missing"
        errors.append(10.0 * (values * steps).sum(axis=1) / weight)
    return np.concatenate(errors)


def _expected(plan: CuttingPlan, k: int, printed: PrintedPattern) -> tuple[np.ndarray, np.ndarray]:
    """Points of the pattern's own edges moved out by the allowance, and normals, on the sheet."""
    piece, turn, shift = plan.pieces[k], printed.sheet.turns[k], printed.sheet.shifts[k]
    corners = np.array([r.points[0] for r in piece.runs])
    notches = np.array([n.point for n in piece.notches]).reshape(-1, 2)
    keep_points, keep_normals = [], []
    import shapely

    polygon = shapely.Polygon(piece.cut.outline)
    for run in piece.runs:
        if run.edge < 0 or run.allowance <= 0:
            continue
        points, normals = sampled(run, 1.0)
        moved = points + run.allowance * normals
        away = np.hypot(*(points[:, None] - corners[None]).transpose(2, 0, 1)).min(axis=1)
        # The pattern's own rule: near corners the neighbour's allowance begins, and hems are shaped to fold.
        clear = away > 4.0 * run.allowance + 0.2
        if len(notches):
            near = np.hypot(*(points[:, None] - notches[None]).transpose(2, 0, 1)).min(axis=1)
            clear &= near > 2 * _CLEAR_CM
        # Where allowances overlap there is no line.
        clear &= ~(
            shapely.contains_xy(polygon, moved) & (polygon.exterior.distance(shapely.points(moved)) > 0.03)
        )
        if piece.on_fold:
            clear &= moved[:, 0] > piece.middle + 1.0
        keep_points.append(moved[clear])
        keep_normals.append(normals[clear])
    points, normals = np.concatenate(keep_points), np.concatenate(keep_normals)
    return points @ turn.T + shift, normals @ turn.T


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("patterns", type=Path)
    parser.add_argument("--limit", type=int, default=5)
    parser.add_argument("--paper", default="a4")
    parser.add_argument("--dpi", type=int, default=300)
    options = parser.parse_args()
    widths, heights, errors, pieces = [], [], [], 0
    for entry in islice(read_patterns(options.patterns), options.limit):
        plan = cutting_plan(entry.read().pattern)
        with tempfile.TemporaryDirectory() as folder:
            try:
                printed = write_pdf(plan, Path(folder) / "p.pdf", paper=Paper.named(options.paper))
            except Exception as error:
                print(f"{entry.id}: {error}")
                continue
            (cover,) = render(printed.path, 600)
            width, height = test_square_cm(cover, 600)
            found = outline_errors(plan, printed, options.dpi)
        widths.append(width)
        heights.append(height)
        errors.append(found)
        pieces += len(plan.pieces)
        print(
            f"{entry.id}: square {width:.3f} x {height:.3f} cm; {len(found)} points, "
            f"largest {abs(found).max():.3f} mm"
        )
    every = np.abs(np.concatenate(errors))
    print(f"patterns {len(errors)}, pieces {pieces}, points {len(every)}")
    print(
        f"test square: {min(widths):.3f} to {max(widths):.3f} by {min(heights):.3f} to {max(heights):.3f} cm"
    )
    print(f"cut lines off by: median {np.median(every):.3f}, largest {every.max():.3f} mm")


if __name__ == "__main__":
    main()
