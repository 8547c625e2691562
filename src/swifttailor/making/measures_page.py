"""The page with the measurements of the finished garment in several sizes, one column a size."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from swifttailor.making import drawing
from swifttailor.making.drawing import Drawing, Stroke, Text
from swifttailor.making.finished_measures import MeasuresColumn, measures_table
from swifttailor.making.paper import Paper
from swifttailor.making.pdf_canvas import draw, start_page

_BORDER_CM = 1.5
_LETTERS_CM, _ROW_CM = 0.34, 0.62
_NAMES_CM, _WIDEST_CM = 4.2, 2.2


def draw_measures(canvas: Any, columns: Sequence[MeasuresColumn], paper: Paper) -> int:
    """Draws the page and returns the number of pages it took: one, or none without measurements."""
    if not columns:
        return 0
    start_page(canvas, (paper.width, paper.height))
    y = paper.height - _BORDER_CM - 0.6
    draw(canvas, Drawing((), (Text("Finished garment", _BORDER_CM, y, 0.6, anchor="start", bold=True),)))
    note = "Taken on the flat pieces along the sewing lines: what the garment measures, not the body."
    draw(canvas, Drawing((), (Text(note, _BORDER_CM, y - 0.8, 0.36, anchor="start"),)))
    y -= 2.0
    for unit, inches in (("cm", False), ("inches", True)):
        rows = [[unit, *(column.size for column in columns)], *measures_table(columns, inches=inches)]
        draw(canvas, _table(rows, y, paper))
        y -= (len(rows) + 1.5) * _ROW_CM
    canvas.showPage()
    return 1


def _table(rows: Sequence[Sequence[str]], top: float, paper: Paper) -> Drawing:
    room = paper.width - 2 * _BORDER_CM - _NAMES_CM
    wide = min(_WIDEST_CM, room / (len(rows[0]) - 1))
    right = _BORDER_CM + _NAMES_CM + wide * (len(rows[0]) - 1)
    texts, strokes = [], []
    for k, (name, *values) in enumerate(rows):
        y = top - k * _ROW_CM
        texts.append(Text(name, _BORDER_CM, y, _LETTERS_CM, anchor="start", bold=k == 0))
        for column, value in enumerate(values, start=1):
            x = _BORDER_CM + _NAMES_CM + wide * (column - 0.5)
            letters = min(_LETTERS_CM, 1.6 * wide / max(len(value), 1))
            texts.append(Text(value, x, y, letters, bold=k == 0))
        line = np.array([[_BORDER_CM, y - 0.2], [right, y - 0.2]])
        strokes.append(Stroke(line, drawing.FRAME))
    return Drawing(tuple(strokes), tuple(texts))
