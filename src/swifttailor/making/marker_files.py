"""A marker as SVG, PNG, PDF or DXF."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING
from xml.sax.saxutils import escape

import numpy as np
import shapely

from swifttailor.atomic_files import write_atomically, write_bytes, write_text
from swifttailor.errors import InputError
from swifttailor.making import drawing
from swifttailor.making.drawing import Drawing, Stroke, Text, arrow_head
from swifttailor.making.dxf_text import DxfText
from swifttailor.making.nesting import LaidPiece, Marker
from swifttailor.making.pattern_dxf import CUT, GRAIN, INTERNAL, SEW, simpler
from swifttailor.making.trim_drawing import mark_strokes

if TYPE_CHECKING:
    from PIL.Image import Image

ENDINGS = (".svg", ".png", ".pdf", ".dxf")
_PICTURE_PIXELS = 2400
_BORDER_CM = 4.0
_LETTER = 0.55


def write_marker(marker: Marker, path: Path | str, *, title: str, overwrite: bool = False) -> Path:
    """Writes a marker in the format of the file's ending.

    Args:
        marker: What to draw: the cloth lies with its length along x.
        path: File to write.
        title: The pattern's name.
        overwrite: Whether another file of that name is replaced.

    Raises:
        InputError: The ending is not among `ENDINGS`, or the file cannot be written.
        MissingExtraError: PDF is wanted and reportlab is not installed.
    """
    path = Path(path)
    require_ending(path)
    ending = path.suffix.lower()
    if ending == ".dxf":
        return write_bytes(path, marker_dxf(marker, title).encode("ascii"), overwrite=overwrite)
    whole = draw_marker(marker, title)
    size = marker.length + 2 * _BORDER_CM, marker.width + 2 * _BORDER_CM
    if ending == ".svg":
        return write_text(path, drawing_svg(whole, size), overwrite=overwrite)
    if ending == ".png":
        return write_atomically(
            path, lambda target: _picture(whole, size).save(target, "PNG"), overwrite=overwrite
        )
    return write_atomically(path, lambda target: _pdf(whole, size, title, target), overwrite=overwrite)


def require_ending(path: Path) -> None:
    """Refuses formats that no marker is written in.

    Raises:
        InputError: The ending is not among `ENDINGS`.
    """
    if path.suffix.lower() not in ENDINGS:
        raise InputError(
            f"A marker cannot be written as '{path.name}'. Accepted endings: {', '.join(ENDINGS)}."
        )


def draw_marker(marker: Marker, title: str) -> Drawing:
    """The cloth with all pieces on it, at true size."""
    border = np.array([_BORDER_CM, _BORDER_CM])
    cloth = np.array([[0, 0], [marker.length, 0], [marker.length, marker.width], [0, marker.width]])
    strokes = [Stroke(cloth + border, drawing.CLOTH, closed=True)]
    summary = (
        f"{title}: {marker.length / 100:.2f} m of cloth {marker.width:g} cm wide, "
        f"{100 * marker.waste:.0f} % left over; pieces with their right side up"
    )
    letter = min(2.0, 0.9 * marker.length / (_LETTER * len(summary)))
    texts = [Text(summary, _BORDER_CM, _BORDER_CM - 1.2 * letter, letter, anchor="start")]
    for item in marker.laid:
        part = _laid(item)
        strokes += [Stroke(s.points + border, s.style, s.closed) for s in part.strokes]
        texts += [Text(t.text, t.x + _BORDER_CM, t.y + _BORDER_CM, t.size, t.angle) for t in part.texts]
    return Drawing(tuple(strokes), tuple(texts))


def marker_dxf(marker: Marker, title: str) -> str:
    """The marker as DXF R12: cut lines on layer 1, sew lines on 14, grain on 7, trims on 8; millimetres."""
    dxf = DxfText()
    dxf.start("SECTION")
    dxf.add(2, "ENTITIES")
    for item in marker.laid:
        dxf.polyline(CUT, item.place(simpler(item.piece.cut.outline)) * 10.0, closed=True)
        dxf.polyline(SEW, item.place(simpler(item.piece.sew_line)) * 10.0, closed=True)
        for stroke in (s for mark in item.piece.marks for s in mark_strokes(mark)):
            dxf.polyline(INTERNAL, item.place(stroke.points) * 10.0, closed=stroke.closed)
        dxf.line(GRAIN, *(item.place(item.piece.grain) * 10.0))
        dxf.text(CUT, item.piece.name, item.place(item.piece.grain.mean(axis=0)[None])[0] * 10.0, size=15.0)
    summary = f"{title}: {marker.length:.1f} x {marker.width:g} cm, {100 * marker.waste:.1f} % waste"
    dxf.text(CUT, summary, np.array([0.0, -30.0]), size=20.0)
    dxf.start("ENDSEC")
    dxf.start("EOF")
    return dxf.content()


def drawing_svg(whole: Drawing, size: tuple[float, float]) -> str:
    """A drawing as SVG, 1:1; lengths in millimetres."""
    width, height = (10.0 * s for s in size)
    parts = [
        '<?xml version="1.0" encoding="UTF-8"?>',
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{width:.2f}mm" height="{height:.2f}mm" '
        f'viewBox="0 0 {width:.2f} {height:.2f}">',
        f'<rect width="{width:.2f}" height="{height:.2f}" fill="#ffffff"/>',
    ]
    for stroke in whole.strokes:
        points = " ".join(f"{10 * x:.2f},{height - 10 * y:.2f}" for x, y in stroke.points.tolist())
        dash = f' stroke-dasharray="{" ".join(map(str, stroke.style.dash))}"' if stroke.style.dash else ""
        kind = "polygon" if stroke.closed else "polyline"
        parts.append(
            f'<{kind} class="{stroke.style.name}" points="{points}" fill="none" '
            f'stroke="{stroke.style.color}" '
            f'stroke-width="{2 * stroke.style.width:.2f}"{dash}/>'
        )
    for text in whole.texts:
        x, y = 10 * text.x, height - 10 * text.y
        turn = f' transform="rotate({-text.angle:.2f} {x:.2f} {y:.2f})"' if text.angle else ""
        parts.append(
            f'<text x="{x:.2f}" y="{y:.2f}" font-size="{10 * text.size:.2f}" text-anchor="{text.anchor}" '
            f'font-family="Helvetica,Arial,sans-serif"{turn}>{escape(_clean(text.text))}</text>'
        )
    return "\n".join([*parts, "</svg>", ""])


def _laid(item: LaidPiece) -> Drawing:
    """A piece on the cloth: outline, sew line, grain, what is put on it, and name."""
    low, high = item.place(item.piece.grain)
    along = (high - low) / max(float(np.hypot(*(high - low))), 1e-9)
    head = min(2.0, 0.2 * float(np.hypot(*(high - low))))
    strokes = (
        Stroke(item.outline, drawing.CUT._replace(width=1.0), closed=True),
        Stroke(item.place(item.piece.sew_line), drawing.SEW, closed=True),
        Stroke(np.array([low, high]), drawing.GRAIN),
        Stroke(arrow_head(high, along, head), drawing.GRAIN),
    )
    put_on = tuple(
        Stroke(item.place(s.points), s.style, s.closed) for m in item.piece.marks for s in mark_strokes(m)
    )
    name = item.piece.name + (" (mirrored)" if item.mirrored else "")
    box = np.ptp(item.outline, axis=0)
    size = float(min(2.4, 0.8 * box[0] / (_LETTER * len(name)), 0.4 * box[1]))
    circle = shapely.maximum_inscribed_circle(shapely.Polygon(item.outline), tolerance=0.5)
    x, y = shapely.get_coordinates(circle)[0].tolist()
    return Drawing((*strokes, *put_on), (Text(name, x, y - 0.3 * size, size),))


def _picture(whole: Drawing, size: tuple[float, float]) -> Image:
    from PIL import Image as images
    from PIL import ImageDraw, ImageFont

    scale = _PICTURE_PIXELS / max(size)
    image = images.new("RGB", (max(int(size[0] * scale), 1), max(int(size[1] * scale), 1)), "white")
    pen = ImageDraw.Draw(image)
    for stroke in whole.strokes:
        points = [(x * scale, (size[1] - y) * scale) for x, y in stroke.points.tolist()]
        points += points[:1] if stroke.closed else []
        pen.line(points, fill=stroke.style.color, width=max(1, round(0.4 * stroke.style.width * scale)))
    for text in whole.texts:
        font = ImageFont.load_default(size=max(8.0, text.size * scale))
        anchor = {"start": "ls", "middle": "ms", "end": "rs"}[text.anchor]
        pen.text(
            (text.x * scale, (size[1] - text.y) * scale), text.text, fill="black", font=font, anchor=anchor
        )
    return image


def _pdf(whole: Drawing, size: tuple[float, float], title: str, target: Path) -> None:
    from swifttailor.making.pdf_canvas import draw, new_canvas

    canvas = new_canvas(target, f"{title}, marker", size)
    draw(canvas, whole)
    canvas.showPage()
    canvas.save()


def _clean(text: str) -> str:
    return "".join(c if c.isprintable() else " " for c in text)
