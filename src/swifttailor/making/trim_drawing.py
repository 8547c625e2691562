"""What is put on a piece, as it is printed: thin dashed outlines, buttons, buttonholes, small words."""

from __future__ import annotations

import numpy as np
import shapely

from swifttailor.arrays import Floats
from swifttailor.making import drawing
from swifttailor.making.drawing import Stroke, Text, circle
from swifttailor.making.piece import Piece
from swifttailor.making.trim_marks import TrimMark, on_half

_LETTERS_CM, _LEAST_CM = 0.26, 0.16
_LETTER = 0.55
_SMALLEST_RADIUS_CM = 0.3
_BESIDE_CM = 0.15


def shown_marks(piece: Piece) -> list[TrimMark]:
    """The marks that are printed: on the right half alone where the piece is cut on the fold."""
    return on_half(piece.marks, piece.middle) if piece.on_fold else list(piece.marks)


def draw_trims(piece: Piece) -> tuple[list[Stroke], list[Text]]:
    """Lines and words of all that is put on a piece."""
    strokes: list[Stroke] = []
    texts: list[Text] = []
    said: set[str] = set()
    for mark in sorted(shown_marks(piece), key=lambda m: -float(m.points[:, 1].max())):
        strokes += mark_strokes(mark)
        if mark.words and ((mark.kind != "button" and mark.kind != "hole") or mark.words not in said):
            said.add(mark.words)  # of a row of buttons, the uppermost says it for all
            texts.append(_words(mark, piece))
    return strokes, texts


def mark_strokes(mark: TrimMark) -> list[Stroke]:
    """The lines of one mark."""
    if mark.kind == "outline":
        return [Stroke(mark.points, drawing.TRIM, closed=True)]
    if mark.kind == "line":
        return [Stroke(mark.points, drawing.TRIM)]
    strokes = []
    center, radius = mark.points[0], max(mark.radius, _SMALLEST_RADIUS_CM)
    if mark.kind == "button":
        strokes.append(Stroke(circle(center, radius), drawing.BUTTON, closed=True))
        for arm in (np.array([radius, 0.0]), np.array([0.0, radius])):
            strokes.append(Stroke(np.array([center - arm, center + arm]), drawing.BUTTON))
    if mark.hole is not None:
        strokes += _hole(mark.hole)
    return strokes


def _hole(ends: Floats) -> list[Stroke]:
    """A line with a bar at both ends."""
    along = ends[1] - ends[0]
    across = 0.15 * np.array([-along[1], along[0]]) / max(float(np.hypot(*along)), 1e-9)
    bars = [Stroke(np.array([end - across, end + across]), drawing.BUTTON) for end in ends]
    return [Stroke(ends, drawing.BUTTON), *bars]


def _words(mark: TrimMark, piece: Piece) -> Text:
    """The words inside an outline below its upper edge, along a line, or beside a button."""
    color = drawing.TRIM.color
    if mark.kind == "outline":
        low, high = mark.points.min(axis=0), mark.points.max(axis=0)
        wide, tall = high - low
        if wide < 0.35 * tall and wide < 2.5:  # bands and zips
            size = float(np.clip(0.8 * tall / (_LETTER * len(mark.words)), _LEAST_CM, _LETTERS_CM))
            size = min(size, max(0.7 * wide, _LEAST_CM))
            x, y = (low + high) / 2
            return Text(mark.words, float(x) + 0.35 * size, float(y), size, 90.0, color=color, halo=True)
        size = float(np.clip(0.85 * wide / (_LETTER * len(mark.words)), _LEAST_CM, _LETTERS_CM))
        share = 0.5 if tall < 6.5 else 0.6
        y = float(high[1]) - share * float(tall) - 0.35 * size
        x0, x1 = _across(mark.points, y)
        return Text(mark.words, (x0 + x1) / 2, y, size, color=color, halo=True)
    if mark.kind == "line":
        return _along(mark)
    x, y = mark.points[0].tolist()
    reach = max(mark.radius, _SMALLEST_RADIUS_CM) + _BESIDE_CM
    if mark.hole is not None:
        reach = max(reach, float(np.abs(mark.hole[:, 0] - x).max()) + _BESIDE_CM)
    # Towards the middle of what is drawn, where there is cloth to write on.
    middle = piece.middle if not piece.on_fold else float(piece.box[1, 0])
    anchor, sign = ("start", 1.0) if middle > x else ("end", -1.0)
    return Text(
        mark.words,
        x + sign * reach,
        y - 0.35 * _LETTERS_CM,
        _LETTERS_CM,
        anchor=anchor,
        color=color,
        halo=True,
    )


def _along(mark: TrimMark) -> Text:
    """Words beside the middle of a line, read along it."""
    line = shapely.LineString(mark.points)
    size = float(np.clip(0.85 * line.length / (_LETTER * len(mark.words)), _LEAST_CM, _LETTERS_CM))
    a, b = shapely.get_coordinates(line.interpolate([0.45, 0.55], normalized=True))
    step = (b - a) / max(float(np.hypot(*(b - a))), 1e-9)
    angle = float(np.degrees(np.arctan2(step[1], step[0])))
    angle = angle if -90 < angle <= 90 else angle - np.copysign(180.0, angle)
    up = np.array([np.cos(np.radians(angle + 90)), np.sin(np.radians(angle + 90))])
    x, y = (a + b) / 2 + (_BESIDE_CM + 0.2) * up
    return Text(mark.words, float(x), float(y), size, angle, color=drawing.TRIM.color, halo=True)


def _across(points: Floats, y: float) -> tuple[float, float]:
    """Where an outline begins and ends at a height."""
    low, high = float(points[:, 0].min()), float(points[:, 0].max())
    cut = shapely.intersection(
        shapely.make_valid(shapely.Polygon(points)), shapely.LineString([(low - 1, y), (high + 1, y)])
    )
    return (low, high) if cut.is_empty else (cut.bounds[0], cut.bounds[2])
