"""The pages of a printed pattern that are read: cover with page map, list of pieces, sewing steps."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from swifttailor.making import drawing
from swifttailor.making.drawing import Drawing, Stroke, Style, Text
from swifttailor.making.finished_measures import MeasuresColumn, in_inches
from swifttailor.making.made_for import made_for
from swifttailor.making.measures_page import draw_measures
from swifttailor.making.notions import notions
from swifttailor.making.paper import Paper
from swifttailor.making.pdf_canvas import POINTS_PER_CM, draw, start_page, wrapped
from swifttailor.making.pieces import CuttingPlan
from swifttailor.making.scale_square import OUTER_CM, draw_test_square
from swifttailor.making.sewing_steps import in_list, preparation, sewing_steps
from swifttailor.making.sheet_layout import Sheet

_BORDER_CM = 1.5
_BODY_CM, _LINE_CM = 0.36, 0.52


@dataclass(frozen=True, eq=False)
class CoverFacts:
    """What the cover tells."""

    plan: CuttingPlan
    sheet: Sheet
    paper: Paper
    placed: Sequence[Drawing]
    """The pieces where they lie on the sheet."""
    cloth: tuple[str, ...]
    preview: Path | None
    sizes: tuple[tuple[str, Style], ...] = ()
    """Of a file with several: what is said of each size, and its cut line."""
    finished: tuple[MeasuresColumn, ...] = ()
    """The measurements of the finished garment, one column a size."""


def draw_cover(canvas: Any, facts: CoverFacts) -> int:
    """Draws the cover and returns the number of pages it took."""
    paper = facts.paper.for_reading
    start_page(canvas, (paper.width, paper.height))
    plan, sheet = facts.plan, facts.sheet
    top = paper.height - _BORDER_CM - 0.6
    count = sum(piece.count for piece in plan.pieces)
    pages = f"{_counted(len(sheet.tiles), 'page')} of {_paper_words(facts.paper)}"
    lines = [
        Text(plan.name, _BORDER_CM, top, 0.8, anchor="start", bold=True),
        Text(
            f"{_counted(len(plan.pieces), 'pattern piece')} for {_counted(count, 'piece')} of cloth, "
            f"on {pages}. Print at 100 % (\u201cactual size\u201d), one-sided.",
            _BORDER_CM, top - 0.9, _BODY_CM, anchor="start",
        ),
    ]  # fmt: skip
    draw(canvas, Drawing((), tuple(lines)))
    square_top = top - 1.6
    draw(canvas, draw_test_square(_BORDER_CM + 0.1, square_top - OUTER_CM[1]))
    picture = _BORDER_CM + OUTER_CM[0] + 0.8
    low = square_top - OUTER_CM[1] - 0.1
    if facts.preview is not None:
        _picture(canvas, facts.preview, picture, low, paper.width - _BORDER_CM - picture, square_top - low)
    bottom = low - 1.0
    draw(canvas, Drawing((), (Text("Page map", _BORDER_CM, bottom, 0.5, anchor="start", bold=True),)))
    wide = 0.58 * (paper.width - 2 * _BORDER_CM)
    draw(canvas, _page_map(facts, _BORDER_CM, _BORDER_CM, wide, bottom - 0.4 - _BORDER_CM))
    return _pieces_beside(canvas, facts, paper, _BORDER_CM + wide + 0.8, bottom)


def draw_steps(canvas: Any, facts: CoverFacts) -> int:
    """Draws the sewing steps and returns the number of pages they took."""
    plan = facts.plan
    writer = _Writer(canvas, facts.paper.for_reading)
    writer.heading("Before you sew")
    if facts.sizes:
        writer.paragraph(f"Lengths in these steps are those of size {plan.pieces[0].size}.", mark="\u2022")
    for line in preparation(plan):
        writer.paragraph(line, mark="\u2022")
    writer.heading("Sewing")
    for number, step in enumerate(sewing_steps(plan), start=1):
        writer.paragraph(f"{step.title}.", mark=f"{number}.", bold=True)
        for sentence in step.sentences:
            writer.paragraph(sentence)
    if plan.findings:
        writer.heading("Look at")
        for finding in plan.findings:
            writer.paragraph(f"{finding.message}.", mark="\u2022")
    return writer.finish()


def _pieces_beside(canvas: Any, facts: CoverFacts, paper: Paper, left: float, top: float) -> int:
    """List of pieces and cloth beside the page map, continued on a page of its own where it is long."""
    plan = facts.plan
    entries: list[tuple[str, bool]] = [("Sizes" if facts.sizes else "Made for", True)]
    entries += [(words, False) for words, _ in facts.sizes] or [(made_for(plan.sewn.pattern), False)]
    lines_of = dict(facts.sizes)
    entries.append(("Pieces", True))
    entries += [(f"{k}. {p.name}: {in_list(p)}", False) for k, p in enumerate(plan.pieces, start=1)]
    entries.append(("Cloth", True))
    entries += [(line, False) for line in facts.cloth or ("Not computed.",)]
    needed = notions(plan)
    if needed:
        size = f", size {plan.pieces[0].size}" if facts.sizes else ""
        entries.append((f"Also needed{size}", True))
        entries += [(line, False) for line in needed]
    entries.append(("Allowances", True))
    widths = plan.allowances
    entries.append(
        (
            f"included: seams {widths.seam:g} cm, hems {widths.hem:g} cm, curved hems "
            f"{min(widths.curved_hem, widths.hem):g} cm, other edges {widths.edge:g} cm. "
            "Cut along the outer line, sew along the dashed one.",
            False,
        )
    )
    # The finished garment's measures stay together: here where there is room, else on a page of their own.
    alone = () if facts.sizes else facts.finished
    measures = [f"{name}: {cm:.1f} cm, {in_inches(cm)} in" for own in alone for name, cm in own.cm.items()]
    pages, y, width = 1, top, paper.width - _BORDER_CM - left
    for text, is_heading in entries:
        lines = [text] if is_heading else list(wrapped(text, width, _BODY_CM))
        needed = (1.1 if is_heading else _LINE_CM * len(lines)) + (1.0 if is_heading else 0)
        if y - needed < _BORDER_CM:
            canvas.showPage()
            start_page(canvas, (paper.width, paper.height))
            pages, y = pages + 1, paper.height - _BORDER_CM - 0.5
            left, width = _BORDER_CM, paper.width - 2 * _BORDER_CM
            lines = [text] if is_heading else list(wrapped(text, width, _BODY_CM))
        if is_heading:
            y -= 0.0 if y == top else 0.5
            draw(canvas, Drawing((), (Text(text, left, y, 0.5, anchor="start", bold=True),)))
            y -= 0.75
            continue
        for k, line in enumerate(lines):
            draw(canvas, Drawing((), (Text(line, left + (0.3 if k else 0.0), y, _BODY_CM, anchor="start"),)))
            if k == len(lines) - 1 and text in lines_of:
                y -= 0.28
                sample = np.array([[left, y], [left + 0.6 * width, y]])
                draw(canvas, Drawing((Stroke(sample, lines_of[text]),)))
            y -= _LINE_CM
        y -= 0.08
    fits = y - 1.25 - _LINE_CM * len(measures) >= _BORDER_CM
    if measures and fits:
        y -= 0.5
        words = [Text("Finished garment", left, y, 0.5, anchor="start", bold=True)]
        lows = y - 0.75 - _LINE_CM * np.arange(len(measures))
        words += [
            Text(m, left, float(low), _BODY_CM, anchor="start") for m, low in zip(measures, lows, strict=True)
        ]
        draw(canvas, Drawing((), tuple(words)))
    canvas.showPage()
    return pages if measures and fits else pages + draw_measures(canvas, facts.finished, paper)


def _page_map(facts: CoverFacts, left: float, bottom: float, width: float, height: float) -> Drawing:
    """The whole sheet, small, with the pages drawn over it."""
    sheet = facts.sheet
    tile = np.array(facts.paper.tile)
    size = tile * (sheet.columns, sheet.rows)
    scale = float(min(width / size[0], height / size[1]))
    origin = np.array([left, bottom + height - scale * size[1]])
    strokes, texts = [], []
    for shown in sheet.tiles:
        low = tile * (shown.column, sheet.rows - 1 - shown.row) * scale + origin
        high = low + tile * scale
        corners = np.array([low, [high[0], low[1]], high, [low[0], high[1]]])
        strokes.append(Stroke(corners, drawing.FRAME, closed=True))
        letter = float(np.clip(0.35 * min(high - low), 0.12, 0.9))
        x, y = ((low + high) / 2).tolist()
        texts.append(Text(shown.name, x, y - 0.35 * letter, letter, color=drawing.GUIDE.color))
    for placed in facts.placed:
        for stroke in placed.strokes:
            if stroke.style.name in ("cut", "fold"):
                style = stroke.style._replace(width=0.15, dash=())
                strokes.append(Stroke(stroke.points * scale + origin, style, stroke.closed))
    for number, placed in enumerate(facts.placed[: len(facts.plan.pieces)], start=1):
        points = np.concatenate([s.points for s in placed.strokes if s.style.name == "cut"])
        x, y = (points.min(axis=0) + points.max(axis=0)) / 2 * scale + origin
        texts.append(Text(str(number), float(x), float(y) - 0.13, 0.36, bold=True))
    return Drawing(tuple(strokes), tuple(texts))


def _picture(canvas: Any, path: Path, left: float, bottom: float, width: float, height: float) -> None:
    from PIL import Image
    from reportlab.lib.utils import ImageReader

    with Image.open(path) as opened:
        opened.thumbnail((1200, 1200))
        image = opened.convert("RGB")
    scale = min(width / image.width, height / image.height)
    canvas.drawImage(
        ImageReader(image),
        left * POINTS_PER_CM,
        (bottom + height - scale * image.height) * POINTS_PER_CM,
        scale * image.width * POINTS_PER_CM,
        scale * image.height * POINTS_PER_CM,
    )


def _counted(number: int, noun: str) -> str:
    return f"{number} {noun}{'s' * (number != 1)}"


def _paper_words(paper: Paper) -> str:
    return paper.name.upper() if len(paper.name) == 2 else paper.name.capitalize()


class _Writer:
    """Writes paragraphs down pages."""

    def __init__(self, canvas: Any, paper: Paper) -> None:
        self.canvas, self.paper, self.pages = canvas, paper, 0
        self.y = -1.0

    def heading(self, text: str) -> None:
        """A heading, with room for some lines below it."""
        self._room(2.5)
        self.y -= 0.35
        self._line(text, _BORDER_CM, 0.55, bold=True)
        self.y -= 0.85

    def paragraph(self, text: str, *, mark: str = "", bold: bool = False) -> None:
        """Wrapped lines, indented, with a mark before the first."""
        indent = 0.9
        width = self.paper.width - 2 * _BORDER_CM - indent
        for k, line in enumerate(wrapped(text, width, _BODY_CM)):
            self._room(_LINE_CM)
            if mark and k == 0:
                self._line(mark, _BORDER_CM, _BODY_CM, bold=bold)
            self._line(line, _BORDER_CM + indent, _BODY_CM, bold=bold)
            self.y -= _LINE_CM
        self.y -= 0.1

    def finish(self) -> int:
        """Ends the last page and returns how many there are."""
        if self.pages:
            self.canvas.showPage()
        return self.pages

    def _room(self, height: float) -> None:
        if self.pages and self.y - height >= _BORDER_CM:
            return
        if self.pages:
            self.canvas.showPage()
        start_page(self.canvas, (self.paper.width, self.paper.height))
        self.pages += 1
        self.y = self.paper.height - _BORDER_CM - 0.5

    def _line(self, text: str, x: float, size: float, *, bold: bool) -> None:
        draw(self.canvas, Drawing((), (Text(text, x, self.y, size, anchor="start", bold=bold),)))
