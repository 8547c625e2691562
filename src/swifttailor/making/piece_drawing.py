"""A piece as it is printed: cut and sew line, notches, grain, fold, darts, gathers, trims, numbers, label."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import shapely

from swifttailor.arrays import Floats
from swifttailor.making import drawing
from swifttailor.making.drawing import Drawing, Stroke, Text, arrow_head, circle
from swifttailor.making.piece import EdgeMark, Piece, PlacedNotch, SeamMark
from swifttailor.making.trim_drawing import draw_trims, shown_marks

_TEETH_APART_CM = 0.5
_SHORTEST_CM = 0.5
"""A notch is drawn at least this long, into the piece where the allowance is narrower."""
_LETTER = 0.55
"""Width of a letter over its size, about."""
_LARGEST, _SMALLEST = 0.75, 0.2
"""Sizes of the label, cm."""
_NUMBER_FROM_CM = 2.5
"""Edges shorter than this have no room for the number of their seam."""


def draw_piece(piece: Piece, title: str) -> Drawing:
    """Draws a piece where it lies, or its right half where it is cut on the fold.

    Args:
        piece: What to draw.
        title: The pattern's name, printed under the piece's.
    """
    shape = drawn_shape(piece)
    strokes = [Stroke(np.asarray(shape.exterior.coords)[:-1], drawing.CUT, closed=True)]
    texts: list[Text] = []
    if piece.on_fold:
        half = _half_plane(piece)
        strokes = _clipped([Stroke(_closed(piece.cut.outline), drawing.CUT)], half)
        strokes += _clipped([Stroke(_closed(piece.sew_line), drawing.SEW)], half)
        added, words = _fold(piece)
        strokes += added
        texts += words
    else:
        strokes.append(Stroke(piece.sew_line, drawing.SEW, closed=True))
    for notch in piece.notches:
        if _is_drawn(piece, notch.point):
            strokes += _notch(notch)
    for dart in piece.darts:
        tip = dart.legs[0][-1]
        if _is_drawn(piece, tip):
            strokes += [Stroke(leg, drawing.DART) for leg in dart.legs]
            strokes.append(Stroke(np.array([(dart.legs[0][0] + dart.legs[1][0]) / 2, tip]), drawing.GUIDE))
            strokes.append(Stroke(circle(tip, 0.25), drawing.DART, closed=True))
    for mark in piece.edge_marks:
        if _is_drawn(piece, mark.points[len(mark.points) // 2]):
            added, word = _edge_mark(mark)
            strokes.append(added)
            texts.append(word)
    added, words = draw_trims(piece)
    strokes += added
    texts += words
    for place, number in _numbers(piece):
        if len(number) <= 2:
            strokes.append(Stroke(circle(place, 0.32), drawing.NUMBER, closed=True))
        x, y = place.tolist()
        texts.append(Text(number, x, y - 0.13, 0.36, color=drawing.NUMBER.color))
    strokes += _grain(piece)
    texts += _label(piece, title, shape)
    return Drawing(tuple(strokes), tuple(texts), layer=piece.size)


def drawn_shape(piece: Piece) -> shapely.Polygon:
    """What is printed of a piece: all of it, or the right half where it is cut on the fold."""
    whole = shapely.Polygon(piece.cut.outline)
    if not piece.on_fold:
        return whole
    half = shapely.intersection(whole, _half_plane(piece))
    parts = [g for g in shapely.get_parts(half) if isinstance(g, shapely.Polygon)]
    return max(parts, key=lambda part: part.area)


def _half_plane(piece: Piece) -> shapely.Polygon:
    low, high = piece.box
    return shapely.box(piece.middle, low[1] - 1, high[0] + 1, high[1] + 1)


def _is_drawn(piece: Piece, point: Floats) -> bool:
    return not piece.on_fold or bool(point[0] > piece.middle - 1e-6)


def _closed(points: Floats) -> Floats:
    return np.concatenate([points, points[:1]])


def _clipped(strokes: list[Stroke], area: shapely.Polygon) -> list[Stroke]:
    kept = []
    for stroke in strokes:
        line = shapely.intersection(shapely.LineString(stroke.points), area)
        merged = shapely.line_merge(line) if isinstance(line, shapely.MultiLineString) else line
        for part in shapely.get_parts(merged):
            points = shapely.get_coordinates(part)
            if isinstance(part, shapely.LineString) and np.ptp(points[:, 0]) > 1e-6:
                kept.append(replace(stroke, points=points))
    return kept


def _notch(notch: PlacedNotch) -> list[Stroke]:
    along = np.array([-notch.outward[1], notch.outward[0]])
    inside = max(_SHORTEST_CM - notch.depth, 0.0)
    offsets = [0.0] if notch.teeth == 1 else [-_TEETH_APART_CM / 2, _TEETH_APART_CM / 2]
    return [
        Stroke(
            np.array([notch.point - inside * notch.outward, notch.point + notch.depth * notch.outward])
            + o * along,
            drawing.NOTCH,
        )
        for o in offsets
    ]


def _edge_mark(mark: EdgeMark) -> tuple[Stroke, Text]:
    """A dotted line inside an edge that is gathered or eased, with the length that it becomes."""
    normal = np.zeros_like(mark.points)
    step = np.gradient(mark.points, axis=0)
    step = step / np.maximum(np.hypot(*step.T), 1e-12)[:, None]
    normal = np.stack([-step[:, 1], step[:, 0]], axis=1)
    line = mark.points + 0.35 * normal
    length = np.append(0.0, np.cumsum(np.hypot(*np.diff(line, axis=0).T)))
    k = int(np.searchsorted(length, 0.3 * length[-1]))
    k = min(max(k, 1), len(line) - 1)
    at = line[k - 1] + (line[k] - line[k - 1]) * 0.5 if len(line) < 4 else line[k]
    if len(line) < 4:
        at = line[0] + 0.3 * (line[-1] - line[0])
    angle = float(np.degrees(np.arctan2(step[k, 1], step[k, 0])))
    upright = angle if -90 < angle <= 90 else angle + 180
    room = 0.75 if upright != angle else 0.35
    size = float(np.clip(0.5 * length[-1] / (_LETTER * len(mark.text)), 0.15, 0.32))
    x, y = at + room * normal[k]
    return Stroke(line, drawing.GATHER), Text(
        mark.text, float(x), float(y), size, upright, color=drawing.GATHER.color
    )


def _numbers(piece: Piece) -> list[tuple[Floats, str]]:
    found = []
    for mark in piece.seam_marks:
        place = _number_place(piece, mark)
        if mark.length >= _NUMBER_FROM_CM and (not piece.on_fold or place[0] > piece.middle + 0.4):
            found.append((place, "/".join(map(str, mark.numbers))))
    return found


def _number_place(piece: Piece, mark: SeamMark) -> Floats:
    crowded = any(
        np.hypot(*(m.points[len(m.points) // 2] - mark.point)) < 0.5 * mark.length for m in piece.edge_marks
    )
    return mark.point + (1.25 if crowded else 0.75) * mark.inward


def _grain(piece: Piece) -> list[Stroke]:
    low, high = piece.grain
    up = np.array([0.0, 1.0])
    size = min(0.6, 0.2 * float(high[1] - low[1]))
    return [
        Stroke(np.array([low, high]), drawing.GRAIN),
        Stroke(arrow_head(high, up, size), drawing.GRAIN),
        Stroke(arrow_head(low, -up, size), drawing.GRAIN),
    ]


def _fold(piece: Piece) -> tuple[list[Stroke], list[Text]]:
    shape = drawn_shape(piece)
    on_line = shapely.intersection(shape, shapely.LineString([(piece.middle, -1e4), (piece.middle, 1e4)]))
    points = shapely.get_coordinates(on_line)
    low, high = float(points[:, 1].min()), float(points[:, 1].max())
    x, inset = piece.middle, 0.12 * (high - low)
    depth = min(1.0, 0.15 * float(np.ptp(shapely.get_coordinates(shape)[:, 0])))
    bracket = np.array(
        [
            [x + depth * 0.1, low + inset],
            [x + depth, low + inset],
            [x + depth, high - inset],
            [x + depth * 0.1, high - inset],
        ]
    )
    left = np.array([-1.0, 0.0])
    strokes = [
        Stroke(np.array([[x, low], [x, high]]), drawing.FOLD),
        Stroke(bracket, drawing.GRAIN),
        Stroke(arrow_head(bracket[0], left, 0.3 * depth + 0.1), drawing.GRAIN),
        Stroke(arrow_head(bracket[3], left, 0.3 * depth + 0.1), drawing.GRAIN),
    ]
    words = "place on the fold"
    size = float(np.clip(0.7 * (high - low) / (_LETTER * len(words)), 0.15, 0.4))
    return strokes, [
        Text(words, x + depth + 1.25 * size, (low + high) / 2, size, 90.0, color=drawing.FOLD.color)
    ]


def _label(piece: Piece, title: str, shape: shapely.Polygon) -> list[Text]:
    """Name, cutting instruction and pattern, as large as fits at the widest place."""
    often = [piece.often, piece.cloth] if piece.cloth else [piece.often]
    full = [piece.name, *often, title + (f", size {piece.size}" if piece.size else "")]
    shape, middle, radius = _label_place(piece, shape)
    x0, x1 = _across(shape, float(middle[1]))
    if piece.on_fold:
        x0 = min(x0 + min(2.2, 0.3 * (x1 - x0)), x1)
    best: tuple[float, list[str]] = (0.0, full[:1])
    for lines in (full, full[:-1], [f"{piece.name}: {piece.instruction}"], full[:1]):
        longest = max(len(line) for line in lines)
        size = min(1.5 * radius / (1.35 * len(lines)), 0.85 * (x1 - x0) / (_LETTER * longest), _LARGEST)
        if size > best[0] * (3.0 if piece.trim else 1.25):  # what is cut for trims says how, however small
            best = size, lines
    size, lines = max(best[0], _SMALLEST), best[1]
    x, y = (x0 + x1) / 2, float(middle[1]) + 0.675 * size * (len(lines) - 2) + 0.3 * size
    return [
        Text(line, x, y - 1.35 * size * k, size if k == 0 else 0.8 * size, bold=k == 0)
        for k, line in enumerate(lines)
    ]


def _label_place(piece: Piece, shape: shapely.Polygon) -> tuple[shapely.Geometry, Floats, float]:
    """Where the label stands: beside what is put on the piece, where there is room enough."""
    put_on = [
        shapely.Polygon(m.points) if m.kind == "outline" else shapely.LineString(m.points).buffer(0.3)
        for m in shown_marks(piece)
        if m.kind in ("outline", "line") and len(m.points) > 1
    ]
    put_on += [shapely.LineString(m.hole).buffer(0.4) for m in piece.marks if m.hole is not None]
    places = []
    for area in (shape, shapely.difference(shape, shapely.union_all(put_on))):
        center = shapely.get_coordinates(shapely.maximum_inscribed_circle(area, tolerance=0.2))
        places.append((area, center[0], float(np.hypot(*(center[1] - center[0])))))
    return places[1] if places[1][2] > 0.5 * places[0][2] else places[0]


def _across(shape: shapely.Geometry, y: float) -> tuple[float, float]:
    """The longest stretch inside a polygon at a height."""
    low, _, high, _ = shape.bounds
    line = shapely.intersection(shape, shapely.LineString([(low - 1, y), (high + 1, y)]))
    parts = [shapely.get_coordinates(p)[:, 0] for p in shapely.get_parts(line)]
    widest = max(parts, key=lambda x: float(np.ptp(x)))
    return float(widest.min()), float(widest.max())
