"""Drawings on the pages of a PDF, by reportlab; standard fonts, no date."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np

from swifttailor.errors import MissingExtraError
from swifttailor.inches import CM_PER_INCH
from swifttailor.making.drawing import Drawing, Stroke, Text

POINTS_PER_CM = 72.0 / CM_PER_INCH
PLAIN, BOLD = "Helvetica", "Helvetica-Bold"


def new_canvas(path: Any, title: str, size: tuple[float, float], *, layers: bool = False) -> Any:
    """An empty PDF of pages of a size in cm, of version 1.5 where it gets layers.

    Raises:
        MissingExtraError: reportlab is not installed.
    """
    try:
        from reportlab.pdfgen.canvas import Canvas
    except ImportError:
        raise MissingExtraError("reportlab", "print", "Writing PDF") from None
    canvas = Canvas(str(path), pagesize=_points(size), invariant=1, pageCompression=1)
    if layers:  # forms of groups are of version 1.5
        canvas._doc._pdfVersion = max(canvas._doc._pdfVersion, (1, 5))
    canvas.setTitle(printable(title))
    canvas.setCreator("swifttailor")
    canvas.setAuthor("")
    canvas.setSubject("sewing pattern")
    return canvas


def start_page(canvas: Any, size: tuple[float, float]) -> None:
    """Begins a page of a size in cm, on which lengths are in points."""
    canvas.setPageSize(_points(size))


def draw(canvas: Any, drawing: Drawing) -> None:
    """Draws strokes and texts, cm from the lower left corner."""
    for stroke in drawing.strokes:
        _stroke(canvas, stroke)
    for text in drawing.texts:
        _text(canvas, text)


def printable(text: str) -> str:
    """Text in the letters that standard fonts have; others become question marks."""
    return "".join(c if c.isprintable() else " " for c in text).encode("cp1252", "replace").decode("cp1252")


def text_width(text: str, size: float, *, bold: bool = False) -> float:
    """Width of a text in cm at a font size in cm."""
    from reportlab.pdfbase.pdfmetrics import stringWidth

    return float(stringWidth(printable(text), BOLD if bold else PLAIN, size))


def wrapped(text: str, width: float, size: float) -> Iterable[str]:
    """Lines of a text, none wider than `width` cm at a font size in cm."""
    line = ""
    for word in text.split():
        longer = f"{line} {word}".strip()
        if line and text_width(longer, size) > width:
            yield line
            line = word
        else:
            line = longer
    if line:
        yield line


def _points(size: tuple[float, float]) -> tuple[float, float]:
    return size[0] * POINTS_PER_CM, size[1] * POINTS_PER_CM


def _stroke(canvas: Any, stroke: Stroke) -> None:
    canvas.setStrokeColor(stroke.style.color)
    canvas.setLineWidth(stroke.style.width * 0.1 * POINTS_PER_CM)
    canvas.setDash([d * 0.1 * POINTS_PER_CM for d in stroke.style.dash])
    canvas.setLineJoin(1)
    canvas.setLineCap(0)
    points = np.round(stroke.points * POINTS_PER_CM, 4).tolist()
    path = canvas.beginPath()
    path.moveTo(*points[0])
    for point in points[1:]:
        path.lineTo(*point)
    if stroke.closed:
        path.close()
    canvas.drawPath(path, stroke=1, fill=0)


def _text(canvas: Any, text: Text) -> None:
    canvas.saveState()
    canvas.setFillColor(text.color)
    canvas.setFont(BOLD if text.bold else PLAIN, text.size * POINTS_PER_CM)
    canvas.translate(text.x * POINTS_PER_CM, text.y * POINTS_PER_CM)
    canvas.rotate(text.angle)
    place = {"start": canvas.drawString, "end": canvas.drawRightString}.get(
        text.anchor, canvas.drawCentredString
    )
    if text.halo:
        canvas.setStrokeColor("#ffffff")
        canvas.setLineWidth(0.5 * text.size * POINTS_PER_CM)
        canvas.setLineJoin(1)
        canvas.setDash([])
        place(0, 0, printable(text.text), mode=1)
    place(0, 0, printable(text.text), mode=0 if text.halo else None)
    canvas.restoreState()
