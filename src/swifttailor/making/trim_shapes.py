"""Pieces of cloth that are drawn as one outline: runs, cut line, and which of them are alike."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import pairwise

import numpy as np
import shapely

from swifttailor.arrays import Floats
from swifttailor.making.allowances import EdgeKind
from swifttailor.making.cut_line import Run, cut_line
from swifttailor.making.piece import Piece
from swifttailor.making.trim_marks import TrimMark

_ALIKE_CM = 0.05
_CORNER_DEGREES = 15.0
_SAME_CM = 1e-6


def ring(points: Floats) -> Floats:
    """A closed outline (n, 2) anticlockwise, without points twice in a row."""
    points = points[np.hypot(*(points - np.roll(points, 1, axis=0)).T) > _SAME_CM]
    x, y = (points - points.mean(axis=0)).T
    area = float(x @ np.roll(y, -1) - np.roll(x, -1) @ y)
    return points if area > 0 else points[::-1]


def ring_of(shape: shapely.Geometry) -> Floats:
    """The outline of the largest part of a shape, (n, 2) anticlockwise."""
    parts = [part for part in shapely.get_parts(shape) if isinstance(part, shapely.Polygon)]
    largest = max(parts, key=lambda part: part.area)
    return ring(shapely.get_coordinates(largest.exterior)[:-1])


def rectangle(width: float, length: float) -> Floats:
    """(4, 2) corners around the origin."""
    x, y = width / 2, length / 2
    return np.array([[-x, -y], [x, -y], [x, y], [-x, y]])


def shape_piece(
    name: str,
    trim: str,
    outline: Floats,
    names: Sequence[str],
    *,
    mirrored: Sequence[str] = (),
    seam: float,
    facing: Callable[[Floats, Floats], float] | None = None,
    marks: Sequence[TrimMark] = (),
    cloth: str = "",
) -> Piece:
    """A piece with seam allowance around it.

    Args:
        name: Of the piece.
        trim: That it is cut for.
        outline: (n, 2) sew line, cm.
        names: One for each that is cut as drawn.
        mirrored: One for each that is cut turned over.
        seam: Width of the allowance, cm.
        facing: From the ends of an edge, what is folded over there, cm; 0 where it is sewn on.
        marks: On it.
        cloth: What it is cut of, where that is not the garment's cloth alone.
    """
    points = ring(outline)
    runs = tuple(_runs(points, seam, facing))
    middle = float(points[:, 0].min() + points[:, 0].max()) / 2
    symmetric = same_shape(points, points * (-1.0, 1.0))
    return Piece(
        name,
        tuple(names),
        tuple(mirrored),
        runs,
        cut_line(runs),
        (),
        (),
        (),
        (),
        symmetric,
        middle,
        marks=tuple(marks),
        trim=trim,
        cloth=cloth,
    )


def same_shape(a: Floats, b: Floats) -> bool:
    """Whether two outlines (n, 2) are one shape, wherever they lie."""
    one, two = (shapely.LinearRing(p - (p.min(axis=0) + p.max(axis=0)) / 2) for p in (a, b))
    return float(shapely.hausdorff_distance(one, two)) <= _ALIKE_CM


def _corners(points: Floats) -> list[int]:
    """Positions in a closed outline (n, 2) at which it turns."""
    coming = points - np.roll(points, 1, axis=0)
    going = np.roll(points, -1, axis=0) - points
    cross = coming[:, 0] * going[:, 1] - coming[:, 1] * going[:, 0]
    turn = np.abs(np.degrees(np.arctan2(cross, (coming * going).sum(axis=1))))
    found = [int(k) for k in np.flatnonzero(turn > _CORNER_DEGREES)]
    return found if len(found) > 1 else [0, len(points) // 2]


def _runs(points: Floats, seam: float, facing: Callable[[Floats, Floats], float] | None) -> list[Run]:
    """One run between every two corners."""
    at = _corners(points)
    rolled = np.roll(points, -at[0], axis=0)
    starts = [*(k - at[0] for k in at), len(points)]
    closed = np.concatenate([rolled, rolled[:1]])
    runs = []
    for k, (start, end) in enumerate(pairwise(starts)):
        part = closed[start : end + 1]
        folded = 0.0 if facing is None else facing(part[0], part[-1])
        kind = EdgeKind.HEM if folded else EdgeKind.SEAM
        runs.append(Run(part, kind, folded or seam, k))
    return runs
