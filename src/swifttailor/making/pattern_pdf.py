"""The PDF to print: cover, pieces at true size on tiled pages, sewing steps."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np

from swifttailor.atomic_files import write_atomically
from swifttailor.making import drawing
from swifttailor.making.cover_pages import CoverFacts, draw_cover, draw_steps
from swifttailor.making.drawing import Drawing, Stroke, Text
from swifttailor.making.finished_measures import finished_column
from swifttailor.making.nested_drawing import draw_nested, size_line
from swifttailor.making.paper import MARGIN_CM, Paper, Tile
from swifttailor.making.pdf_canvas import POINTS_PER_CM, draw, new_canvas, start_page
from swifttailor.making.pdf_layers import PdfLayers
from swifttailor.making.piece_drawing import draw_piece, drawn_shape
from swifttailor.making.pieces import CuttingPlan
from swifttailor.making.scale_square import OUTER_CM, SIZE_CM, draw_test_square
from swifttailor.making.sheet_layout import GAP_CM, Sheet, lay_out_sheet
from swifttailor.making.size_run import SizeRun
from swifttailor.pattern.finding import Finding

_CROSS_CM = 0.6


@dataclass(frozen=True, eq=False)
class PrintedPattern:
    """What was printed."""

    path: Path
    pages: int
    """Of the PDF: cover, tiles, steps."""
    steps_pages: int
    """The last pages, which hold the sewing steps."""
    sheet: Sheet
    paper: Paper
    findings: tuple[Finding, ...]


def write_pdf(
    plan: CuttingPlan,
    path: Path | str,
    *,
    paper: Paper,
    cloth: Sequence[str] = (),
    preview: Path | None = None,
    overwrite: bool = False,
) -> PrintedPattern:
    """Writes a pattern to print, true to scale.

    Args:
        plan: Pieces and steps.
        path: File to write.
        paper: What it is printed on.
        cloth: Lines about how much cloth is needed, for the cover.
        preview: Picture of the garment for the cover.
        overwrite: Whether another file of that name is replaced.

    Raises:
        InputError: The file cannot be written.
        MissingExtraError: reportlab is not installed.
    """
    path = Path(path)
    shapes = [drawn_shape(piece) for piece in plan.pieces]
    drawings = [draw_piece(piece, plan.name) for piece in plan.pieces]
    if paper.for_reading != paper:  # the cover is printed elsewhere, so the large sheet is measured by itself
        shapes.append(_square_shape())
        drawings.append(draw_test_square(0.0, 0.0))
    sheet = lay_out_sheet(shapes, paper)
    placed = [
        d.moved(turn, shift) for d, turn, shift in zip(drawings, sheet.turns, sheet.shifts, strict=True)
    ]
    column = finished_column(plan.sewn.pattern)
    finished = () if column is None else (column,)
    cover_pages = steps_pages = 0

    def write(temporary: Path) -> None:
        canvas = new_canvas(temporary, f"{plan.name}, sewing pattern", (paper.width, paper.height))
        facts = CoverFacts(plan, sheet, paper, placed, tuple(cloth), preview, finished=finished)
        nonlocal cover_pages, steps_pages
        cover_pages = draw_cover(canvas, facts)
        _tiles(canvas, sheet, paper, [Drawing.joined(placed)], plan.name)
        steps_pages = draw_steps(canvas, facts)
        canvas.save()

    write_atomically(path, write, overwrite=overwrite)
    pages = cover_pages + len(sheet.tiles) + steps_pages
    return PrintedPattern(path, pages, steps_pages, sheet, paper, plan.findings)


def write_sizes_pdf(
    run: SizeRun,
    path: Path | str,
    *,
    paper: Paper,
    said: Sequence[str] = (),
    cloth: Sequence[str] = (),
    overwrite: bool = False,
) -> PrintedPattern:
    """Writes a pattern in several sizes to print, nested, with a layer for each size.

    Args:
        run: The sizes.
        path: File to write.
        paper: What it is printed on.
        said: What the cover says of each size; their names when empty.
        cloth: Lines about how much cloth is needed, for the cover.
        overwrite: Whether another file of that name is replaced.

    Raises:
        InputError: The file cannot be written.
        MissingExtraError: reportlab is not installed.
    """
    path = Path(path)
    nested = [draw_nested(piece, run) for piece in run.nested]
    shapes = [one.shape for one in nested]
    square = [] if paper.for_reading == paper else [draw_test_square(0.0, 0.0)]
    shapes += [_square_shape() for _ in square]
    sheet = lay_out_sheet(shapes, paper)
    places = list(zip(sheet.turns, sheet.shifts, strict=True))
    common = [
        d.moved(*place) for d, place in zip([*(n.common for n in nested), *square], places, strict=True)
    ]
    layers = []
    for k, size in enumerate(run.sizes):
        moved = [one.sizes[k].moved(*place) for one, place in zip(nested, places, strict=False)]
        layers.append(replace(Drawing.joined(moved), layer=size))
    mapped = [
        Drawing.joined([common[k], *(one.moved(*places[k]) for one in nested[k].sizes)])
        for k in range(len(nested))
    ] + common[len(nested) :]
    base = run.plans[run.base]
    named = replace(base, pieces=tuple(one.pieces[run.base] for one in run.nested))
    words = said or run.sizes
    sizes = tuple((text, size_line(k)) for k, text in enumerate(words))
    columns = [
        finished_column(own.sewn.pattern, size) for size, own in zip(run.sizes, run.plans, strict=True)
    ]
    finished = tuple(column for column in columns if column is not None)
    cover_pages = steps_pages = 0

    def write(temporary: Path) -> None:
        canvas = new_canvas(
            temporary, f"{run.name}, sewing pattern", (paper.width, paper.height), layers=True
        )
        facts = CoverFacts(named, sheet, paper, mapped, tuple(cloth), None, sizes, finished)
        nonlocal cover_pages, steps_pages
        cover_pages = draw_cover(canvas, facts)
        _tiles(canvas, sheet, paper, [Drawing.joined(common), *layers], run.name)
        steps_pages = draw_steps(canvas, facts)
        canvas.save()

    write_atomically(path, write, overwrite=overwrite)
    pages = cover_pages + len(sheet.tiles) + steps_pages
    return PrintedPattern(path, pages, steps_pages, sheet, paper, base.findings)


def _square_shape() -> Any:
    import shapely

    edge = (OUTER_CM[0] - SIZE_CM[0]) / 2, (OUTER_CM[1] - SIZE_CM[1]) / 2
    return shapely.box(-edge[0], -edge[1], SIZE_CM[0] + edge[0], SIZE_CM[1] + edge[1])


def _tiles(canvas: Any, sheet: Sheet, paper: Paper, drawings: Sequence[Drawing], name: str) -> None:
    width, height = paper.tile
    reach = sheet.columns * width * POINTS_PER_CM, sheet.rows * height * POINTS_PER_CM
    layers = PdfLayers(canvas, (-GAP_CM, -GAP_CM, *reach))
    for one in drawings:
        layers.add(one)
    layers.finish()
    present = set(sheet.tiles)
    for number, tile in enumerate(sheet.tiles, start=1):
        start_page(canvas, (paper.width, paper.height))
        canvas.saveState()
        canvas.translate(MARGIN_CM * POINTS_PER_CM, MARGIN_CM * POINTS_PER_CM)
        canvas.saveState()
        clip = canvas.beginPath()
        clip.rect(0, 0, width * POINTS_PER_CM, height * POINTS_PER_CM)
        canvas.clipPath(clip, stroke=0, fill=0)
        canvas.saveState()
        canvas.translate(
            -tile.column * width * POINTS_PER_CM, -(sheet.rows - 1 - tile.row) * height * POINTS_PER_CM
        )
        for form in layers.forms:
            canvas.doForm(form)
        canvas.restoreState()
        draw(canvas, _crosses(tile, present, width, height))
        canvas.restoreState()
        draw(canvas, _frame(tile, present, width, height, f"{name}: page {number} of {len(sheet.tiles)}"))
        canvas.restoreState()
        canvas.showPage()


def _neighbours(tile: Tile, present: set[Tile]) -> dict[str, Tile]:
    around = {
        "left": Tile(tile.column - 1, tile.row),
        "right": Tile(tile.column + 1, tile.row),
        "top": Tile(tile.column, tile.row - 1),
        "bottom": Tile(tile.column, tile.row + 1),
    }
    return {side: other for side, other in around.items() if other in present}


def _crosses(tile: Tile, present: set[Tile], width: float, height: float) -> Drawing:
    """X marks at a quarter and three quarters of each shared edge; half of each is on either page."""
    strokes = []
    for side in _neighbours(tile, present):
        for share in (0.25, 0.75):
            x = {"left": 0.0, "right": width}.get(side, share * width)
            y = {"bottom": 0.0, "top": height}.get(side, share * height)
            for sign in (1.0, -1.0):
                rise = sign * _CROSS_CM
                arm = np.array([[x - _CROSS_CM, y - rise], [x + _CROSS_CM, y + rise]])
                strokes.append(Stroke(arm, drawing.FRAME._replace(width=0.35)))
    return Drawing(tuple(strokes))


def _frame(tile: Tile, present: set[Tile], width: float, height: float, caption: str) -> Drawing:
    """The edge along which the page is cut or folded, its name, and those of its neighbours."""
    frame = Stroke(np.array([[0, 0], [width, 0], [width, height], [0, height]]), drawing.FRAME, closed=True)
    grey = drawing.FRAME.color
    texts = [
        Text(tile.name, 0.4, height - 1.1, 0.9, anchor="start", bold=True, color=grey),
        Text(caption, width / 2, -0.4, 0.26, color=grey),
    ]
    places = {
        "left": (0.35, height / 2, 90.0),
        "right": (width - 0.15, height / 2, 90.0),
        "top": (width / 2, height - 0.35, 0.0),
        "bottom": (width / 2, 0.15, 0.0),
    }
    for side, other in _neighbours(tile, present).items():
        x, y, angle = places[side]
        texts.append(Text(f"to {other.name}", x, y, 0.28, angle, color=grey))
    return Drawing((frame,), tuple(texts))
