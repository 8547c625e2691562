"""The PDF to print: cover, pieces at true size on tiled pages, sewing steps."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from swifttailor.atomic_files import write_atomically
from swifttailor.making import drawing
from swifttailor.making.cover_pages import CoverFacts, draw_cover, draw_steps
from swifttailor.making.drawing import Drawing, Stroke, Text
from swifttailor.making.paper import MARGIN_CM, Paper, Tile
from swifttailor.making.pdf_canvas import POINTS_PER_CM, draw, new_canvas, start_page
from swifttailor.making.piece_drawing import draw_piece, drawn_shape
from swifttailor.making.pieces import CuttingPlan
from swifttailor.making.scale_square import OUTER_CM, SIZE_CM, draw_test_square
from swifttailor.making.sheet_layout import GAP_CM, Sheet, lay_out_sheet
from swifttailor.pattern.finding import Finding

_CROSS_CM = 0.6
_FORM = "sheet"


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
    cover_pages = steps_pages = 0

    def write(temporary: Path) -> None:
        canvas = new_canvas(temporary, f"{plan.name}, sewing pattern", (paper.width, paper.height))
        facts = CoverFacts(plan, sheet, paper, placed, tuple(cloth), preview)
        nonlocal cover_pages, steps_pages
        cover_pages = draw_cover(canvas, facts)
        _tiles(canvas, sheet, paper, Drawing.joined(placed), plan.name)
        steps_pages = draw_steps(canvas, facts)
        canvas.save()

    write_atomically(path, write, overwrite=overwrite)
    pages = cover_pages + len(sheet.tiles) + steps_pages
    return PrintedPattern(path, pages, steps_pages, sheet, paper, plan.findings)


def _square_shape() -> Any:
    import shapely

    edge = (OUTER_CM[0] - SIZE_CM[0]) / 2, (OUTER_CM[1] - SIZE_CM[1]) / 2
    return shapely.box(-edge[0], -edge[1], SIZE_CM[0] + edge[0], SIZE_CM[1] + edge[1])


def _tiles(canvas: Any, sheet: Sheet, paper: Paper, whole: Drawing, name: str) -> None:
    width, height = paper.tile
    canvas.beginForm(
        _FORM, -GAP_CM, -GAP_CM, sheet.columns * width * POINTS_PER_CM, sheet.rows * height * POINTS_PER_CM
    )
    draw(canvas, whole)
    canvas.endForm()
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
        canvas.doForm(_FORM)
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
