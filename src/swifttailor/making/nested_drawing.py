"""A piece in all sizes as it is printed: lines of another kind and colour for each, in a layer of its own."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
import shapely
import shapely.affinity

from swifttailor.arrays import Floats
from swifttailor.making import drawing
from swifttailor.making.drawing import Drawing, Stroke, Style, Text
from swifttailor.making.piece_drawing import draw_piece, drawn_shape
from swifttailor.making.size_run import NestedPiece, SizeRun

_LINES: tuple[tuple[str, tuple[float, ...]], ...] = (
    ("#000000", ()),
    ("#b3261e", (6.0, 2.0)),
    ("#1f5fa8", (3.0, 1.5)),
    ("#2e7d32", (8.0, 1.5, 1.5, 1.5)),
    ("#8e4a9e", (1.5, 1.5)),
    ("#b26a00", (10.0, 2.0, 1.0, 2.0, 1.0, 2.0)),
    ("#00707a", (4.0, 3.0)),
    ("#7a4b2a", (12.0, 3.0)),
    ("#4b4b4b", (6.0, 1.5, 1.5, 1.5, 1.5, 1.5)),
    ("#c2185b", (2.0, 3.0)),
    ("#37474f", (9.0, 4.0)),
    ("#5d7a00", (1.0, 2.5)),
)
"""Colour and dashes in mm of each size's cut line; black and white printers tell the dashes apart."""
_OWN = ("cut", "sew", "notch", "dart", "gather", "trim", "button")
"""What lies elsewhere in each size; the rest is drawn once."""
_NAME_CM = 0.32


@dataclass(frozen=True, eq=False)
class NestedDrawing:
    """A piece as it is drawn in all sizes."""

    common: Drawing
    """Grain, fold, numbers of seams, name."""
    sizes: tuple[Drawing, ...]
    """Lines, notches, darts, gathers and trims of each size; the layer is the size's name."""
    shape: shapely.Polygon
    """What all of it covers."""


def size_line(number: int) -> Style:
    """The cut line of the size of that number."""
    color, dash = _LINES[number % len(_LINES)]
    return Style("cut", color, 0.45, dash)


def draw_nested(nested: NestedPiece, run: SizeRun) -> NestedDrawing:
    """Draws a piece in all sizes, where its middle size lies.

    Args:
        nested: The piece.
        run: The sizes that it belongs to.
    """
    straight = np.eye(2)
    base, shift = nested.middle(run.base)
    drawn = draw_piece(base, f"{run.name}, sizes {run.sizes[0]} to {run.sizes[-1]}").moved(straight, shift)
    marks = {mark.text for piece in nested.pieces for mark in piece.edge_marks}
    size_in_title = f", size {base.size}"
    common = Drawing(
        tuple(s for s in drawn.strokes if s.style.name not in _OWN),
        tuple(replace(t, text=t.text.replace(size_in_title, "")) for t in drawn.texts if t.text not in marks),
    )
    layers, shapes = [], []
    for number, (piece, own) in enumerate(zip(nested.pieces, nested.shifts, strict=True)):
        one = draw_piece(piece, run.name).moved(straight, own)
        strokes = tuple(_own(s, number) for s in one.strokes if s.style.name in _OWN)
        texts = _marks(nested, run, number, [t for t in drawn.texts if t.text in marks])
        share = (number + 0.5) / len(run.sizes)
        texts += _names(piece.size, one, number, share)
        layers.append(Drawing(strokes, tuple(texts), layer=piece.size))
        shapes.append(shapely.affinity.translate(drawn_shape(piece), *own))
    return NestedDrawing(common, tuple(layers), _cover(shapes))


def _own(stroke: Stroke, number: int) -> Stroke:
    line = size_line(number)
    if stroke.style.name == "cut":
        return Stroke(stroke.points, line, stroke.closed)
    if stroke.style.name == "sew":
        return Stroke(stroke.points, drawing.SEW._replace(color=line.color, width=0.15), stroke.closed)
    return Stroke(stroke.points, stroke.style._replace(color=line.color), stroke.closed)


def _marks(nested: NestedPiece, run: SizeRun, number: int, base: list[Text]) -> list[Text]:
    """What is done with edges in one size, below each other where it stands in the middle size."""
    piece, shift = nested.middle(run.base)
    own = nested.pieces[number]
    if len(own.edge_marks) != len(piece.edge_marks):
        return []
    found = []
    for text in base:
        place = np.array([text.x, text.y])
        k = min(
            (k for k, mark in enumerate(piece.edge_marks) if mark.text == text.text),
            key=lambda k: float(np.hypot(*(piece.edge_marks[k].points + shift - place).T).min()),
        )
        edge = piece.edge_marks[k].points + shift
        turned = np.radians(text.angle + 90.0)
        inward = np.array([np.cos(turned), np.sin(turned)])
        if inward @ (place - edge[np.hypot(*(edge - place).T).argmin()]) < 0:
            inward = -inward
        x, y = place + 1.3 * text.size * number * inward
        words = f"{own.size}: {own.edge_marks[k].text}"
        found.append(
            replace(text, text=words, x=float(x), y=float(y), color=size_line(number).color, halo=True)
        )
    return found


def _names(size: str, one: Drawing, number: int, share: float) -> list[Text]:
    """The size's name twice beside its cut line, elsewhere than those of the other sizes."""
    outline = max((s.points for s in one.strokes if s.style.name == "cut"), key=len)
    color = size_line(number).color
    return [_beside(outline, (share / 2 + half) % 1.0, size, color) for half in (0.0, 0.5)]


def _beside(outline: Floats, share: float, size: str, color: str) -> Text:
    line = shapely.LineString(outline)
    at = shapely.get_coordinates(line.interpolate(share, normalized=True))[0]
    return Text(
        size, float(at[0]), float(at[1]) - 0.36 * _NAME_CM, _NAME_CM, bold=True, color=color, halo=True
    )


def _cover(shapes: list[shapely.Polygon]) -> shapely.Polygon:
    whole = shapely.union_all(shapes)
    return whole if isinstance(whole, shapely.Polygon) else shapely.convex_hull(whole)
