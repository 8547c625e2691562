"""The line that is cut: the sew line moved outward by the allowance of each edge.

The cloth to cut is the union of the piece, a strip along each edge, and what fills the corners between
strips. A union of areas cannot cross itself, and contains every strip whole, so no allowance can be
missing; where strips of different edges overlap (narrow slits, sharp inner corners) they become one, and
the sew lines tell where to cut.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import shapely

from swifttailor.arrays import Floats
from swifttailor.making.allowances import FOLDED_UP, EdgeKind

_MITRE = 2.5
"""Mitred corners reach this many allowances far; sharper ones are cut off there, square to their middle."""
_STEP_RADIANS = 0.35
"""Between edges that meet at a smaller angle, with different allowances, the cut line has a step."""
_FLATTEST = 0.35
"""A corner is turned where the sine of the angle between hem and side is at least this."""
_OVERLAP_CM = 0.005
"""Strips begin this far inside the sew line, so that they and the piece become one."""
_SMOOTH_CM = 0.0005


@dataclass(frozen=True, eq=False)
class Run:
    """A part of the sew line between two corners."""

    points: Floats
    """Polyline (n, 2), cm, anticlockwise around the piece."""
    kind: EdgeKind
    allowance: float
    """cm."""
    edge: int
    """Number of the panel's edge; -1 across the mouth of a dart."""


@dataclass(frozen=True, eq=False)
class CutLine:
    """What is cut, and what happened on the way."""

    outline: Floats
    """Closed polyline (n, 2), cm, anticlockwise; the first point is not repeated."""
    turned: tuple[Floats, ...]
    """Corners (2,) of the sew line whose allowance is shaped to be folded up."""
    blunted: tuple[Floats, ...]
    """Corners (2,) of the sew line too sharp for a full mitre."""
    closed_holes: int
    """Gaps between edges that the allowances fill."""


def cut_line(runs: Sequence[Run], more: Sequence[shapely.Geometry] = ()) -> CutLine:
    """Moves a sew line outward.

    Args:
        runs: The whole loop, each beginning where the one before ends.
        more: Areas of cloth that are cut with it.
    """
    runs = [r for r in runs if len(r.points) > 1 and _length(r.points) > 1e-6]
    inside = _area(np.concatenate([r.points[:-1] for r in runs]))
    strips = [_strip(r.points, r.allowance) for r in runs]
    extra: list[shapely.Geometry] = []
    turned, blunted = [], []
    for k, after in enumerate(runs):
        before = runs[k - 1]
        corner = after.points[0]
        coming, going = _last_direction(before.points), _first_direction(after.points)
        angle = float(np.arctan2(_cross(coming, going), coming @ going))
        before_folds, after_folds = before.kind in FOLDED_UP, after.kind in FOLDED_UP
        if before_folds != after_folds and max(before.allowance, after.allowance) > 0:
            hem, side, hem_index, side_index = (
                (before, after, k - 1, k) if before_folds else (after, before, k, k - 1)
            )
            outward = coming if before_folds else -going
            along_side = going if before_folds else -coming
            made = _turned_corner(corner, outward, along_side, hem.allowance, side.allowance, before_folds)
            if made is not None:
                flap, beyond, below, fill = made
                strips[hem_index] = strips[hem_index].union(flap).difference(beyond)
                strips[side_index] = strips[side_index].difference(below).union(fill)
                turned.append(corner)
                continue
        if angle > 1e-9:
            filling, blunt = _mitre(corner, coming, going, before.allowance, after.allowance, angle)
            if filling is not None:
                extra.append(filling)
            if blunt:
                blunted.append(corner)
    whole = shapely.union_all([inside, *strips, *extra, *more])
    areas = [part for part in shapely.get_parts(whole) if isinstance(part, shapely.Polygon)]
    whole = max(areas, key=lambda part: part.area)  # the others are specks and lines of rounding
    holes = sum(shapely.Polygon(ring).area > 0.01 for ring in whole.interiors)
    solid = shapely.Polygon(whole.exterior).simplify(_SMOOTH_CM)
    ring = np.asarray(shapely.get_coordinates(shapely.orient_polygons(solid).exterior))[:-1]
    return CutLine(ring, tuple(turned), tuple(blunted), holes)


def outward(points: Floats) -> Floats:
    """Unit normals (n - 1, 2) out of an anticlockwise loop, one a segment of a polyline (n, 2)."""
    step = np.diff(points, axis=0)
    step = step / np.maximum(np.hypot(*step.T), 1e-12)[:, None]
    return np.stack([step[:, 1], -step[:, 0]], axis=1)


def _strip(points: Floats, width: float) -> shapely.Geometry:
    """The band of a width along the outer side of a polyline, with square ends."""
    if width <= 0:
        return shapely.Polygon()
    keep = np.append(np.hypot(*np.diff(points, axis=0).T) > 1e-9, True)
    points = points[keep]
    normal = outward(points)
    low, high = points[:-1], points[1:]
    quads = np.stack(
        [
            low - _OVERLAP_CM * normal,
            low + width * normal,
            high + width * normal,
            high - _OVERLAP_CM * normal,
        ],
        1,
    )
    parts = list(shapely.polygons(quads))
    n, m = normal[:-1], normal[1:]
    bend = 1.0 + (n * m).sum(axis=1)
    cross = n[:, 0] * m[:, 1] - n[:, 1] * m[:, 0]
    for k in np.flatnonzero((cross > 1e-9) & (bend > 0.2)):  # gaps on the outer side of a bend
        middle = points[k + 1]
        tip = middle + width * (n[k] + m[k]) / bend[k]
        parts.append(
            shapely.Polygon([middle - _OVERLAP_CM * n[k], middle + width * n[k], tip, middle + width * m[k]])
        )
    return shapely.union_all(parts)


def _mitre(
    corner: Floats, coming: Floats, going: Floats, first: float, second: float, angle: float
) -> tuple[shapely.Geometry | None, bool]:
    """What fills the gap between two strips at an outer corner, and whether the mitre was cut short."""
    if max(first, second) <= 0:
        return None, False
    n, m = np.array([coming[1], -coming[0]]), np.array([going[1], -going[0]])
    start, end = corner + first * n, corner + second * m
    back = corner - _OVERLAP_CM * (n + m)
    if angle < _STEP_RADIANS and abs(first - second) > 1e-9:
        return _hull([back, start, end]), False
    solve = np.array([n, m])
    determinant = float(np.linalg.det(solve))
    limit = _MITRE * max(first, second)
    if abs(determinant) > 1e-9:
        tip = corner + np.linalg.solve(solve, [first, second])
        if float(np.hypot(*(tip - corner))) <= limit:
            # Where one allowance is much the wider, the tip lies before the end of its strip.
            return _hull([back, start, tip, end]), False
    middle = n + m
    middle = middle / max(float(np.hypot(*middle)), 1e-9) if angle < 3.1 else coming
    reach = max(first, second) * 1.5
    along_first = _until(start, coming, corner, middle, reach)
    along_second = _until(end, -going, corner, middle, reach)
    return _hull([back, start, along_first, along_second, end]), True


def _until(point: Floats, direction: Floats, corner: Floats, middle: Floats, reach: float) -> Floats:
    """Goes from a point until it is `reach` from the corner, measured along its middle line.

    Between allowances of very different widths at a blunt corner that would be far away, so not beyond three
    times `reach`.
    """
    speed = float(direction @ middle)
    missing = reach - float((point - corner) @ middle)
    if speed <= 1e-6 or missing <= 0:
        return point
    return point + direction * min(missing / speed, 3.0 * reach)


def _turned_corner(
    corner: Floats, outward_hem: Floats, side: Floats, hem_cm: float, side_cm: float, hem_comes_first: bool
) -> tuple[shapely.Geometry, shapely.Geometry, shapely.Geometry, shapely.Geometry] | None:
    """Shapes a hem's end so that it lies flush with the side when it is folded up.

    The side's cut line, mirrored at the hem, is the end of the hem's allowance.

    Args:
        corner: Where hem and side meet.
        outward_hem: Unit vector along the hem, out of the piece.
        side: Unit vector along the side, away from the corner.
        hem_cm: Allowance of the hem.
        side_cm: Allowance of the side.
        hem_comes_first: Whether the loop comes along the hem and leaves along the side.

    Returns:
        To add to the hem's strip, to take from it, to take from the side's strip and to add to it; None where
        the side leaves at too flat an angle.
    """
    t = outward_hem
    n = np.array([t[1], -t[0]]) if hem_comes_first else np.array([-t[1], t[0]])  # out of the piece
    folded = side - 2 * float(side @ n) * n
    if float(folded @ n) < _FLATTEST:
        return None
    out_of_side = np.array([side[1], -side[0]]) if hem_comes_first else np.array([-side[1], side[0]])
    # The side's cut line meets the hem's sew line at corner + reach * t.
    reach = side_cm / float(t @ out_of_side) if float(t @ out_of_side) > 1e-6 else 0.0
    foot = corner + reach * t
    end = foot + folded * (hem_cm / float(folded @ n))
    far = 3.0 * (abs(reach) + abs(float((end - corner) @ t)) + hem_cm + side_cm)
    flap = _hull([corner - _OVERLAP_CM * (n + t), foot, end, corner + hem_cm * n])
    lift, drop = -2 * _OVERLAP_CM * folded, 0.1 * folded
    beyond = shapely.Polygon([foot + lift, end + drop, end + drop + far * t, foot + lift + far * t])
    below = shapely.Polygon(
        [corner - 0.2 * _OVERLAP_CM * t, corner + far * t, corner + far * (t + n), corner + far * n]
    )
    fill = _hull([corner - _OVERLAP_CM * t, corner + side_cm * out_of_side, foot, corner])
    fill = fill.difference(below)
    return flap, beyond, below, fill


def _area(points: Floats) -> shapely.Geometry:
    polygon = shapely.Polygon(points)
    return polygon if polygon.is_valid else shapely.make_valid(polygon)


def _hull(points: Sequence[Floats]) -> shapely.Geometry:
    return shapely.convex_hull(shapely.MultiPoint(np.array(points)))


def _length(points: Floats) -> float:
    return float(np.hypot(*np.diff(points, axis=0).T).sum())


def _first_direction(points: Floats) -> Floats:
    steps = np.diff(points, axis=0)
    size = np.hypot(*steps.T)
    first = int(np.argmax(size > 1e-7))
    return steps[first] / max(float(size[first]), 1e-12)


def _last_direction(points: Floats) -> Floats:
    return -_first_direction(points[::-1])


def _cross(a: Floats, b: Floats) -> float:
    return float(a[0] * b[1] - a[1] * b[0])
