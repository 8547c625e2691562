"""Where a panel's outline crosses or touches itself, and how deeply."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from typing import Literal

import numpy as np
import shapely
from numpy.typing import NDArray

from swifttailor.arrays import Floats
from swifttailor.pattern.check.outline import Outline

NOISE_CM = 0.05
"""Overlaps shallower than this are numerical noise of whoever made the pattern, not a shape that is wrong."""
TOUCH_CM = 0.005
"""Overlaps shallower than this cannot be told from touching: curves are followed to 0.002 cm."""

_MAX_MEETINGS = 1000
_CHUNK = 256


@dataclass(frozen=True, eq=False)
class Crossing:
    """The worst place where an outline meets itself."""

    kind: Literal["crossing", "noise", "touch"]
    depth: float
    """Width in cm of the widest overlap; infinite when there are too many crossings to look at each."""
    edges: tuple[int, int]
    """The two edges that meet there."""
    point: tuple[float, float]
    """The place, panel-local cm."""
    places: int
    """How often the outline meets itself."""


@lru_cache(maxsize=512)
def find_crossing(outline: Outline) -> Crossing | None:
    """Looks for self-intersections of an outline.

    The outline cuts the plane into faces. Where it does not cross itself, every face has winding number 0
    (outside) or 1 in the loop's own direction; a true crossing always makes a face with another number, and
    that face's width is the depth of the crossing. Loops that only touch themselves make none.

    Args:
        outline: Flattened panel; what was found in the latest of them is remembered.

    Returns:
        The deepest meeting, or None for a simple outline.
    """
    points, owner = _without_repeats(outline.points, outline.edge_of_segment)
    if len(points) < 3:
        return None
    ring = np.concatenate([points, points[:1]])
    if shapely.is_simple(shapely.linearrings(ring)):
        return None
    meetings, places = _meetings(points, owner)
    if not meetings:
        return None
    if len(meetings) >= _MAX_MEETINGS:
        a, b, place = meetings[0]
        return Crossing("crossing", np.inf, (a, b), place, len(meetings))
    faces = _wrongly_wound_faces(ring, outline.area)
    if not len(faces):
        a, b, place = meetings[0]
        return Crossing("touch", 0.0, (a, b), place, len(meetings))
    depths = face_depths(faces)
    worst = int(np.argmax(depths))
    nearest = int(np.argmin(shapely.distance(places, shapely.boundary(faces[worst]))))
    a, b, place = meetings[nearest]
    depth = float(depths[worst])
    kind = "crossing" if depth >= NOISE_CM else "noise" if depth > TOUCH_CM else "touch"
    return Crossing(kind, depth, (a, b), place, len(meetings))


def face_depths(faces: NDArray[np.object_]) -> Floats:
    """Width (k,) in cm of each face: exact for thin ones, within a factor of two for round ones."""
    return 2 * shapely.area(faces) / np.maximum(shapely.length(faces) / 2, 1e-300)


def _without_repeats(points: Floats, owner: NDArray[np.int64]) -> tuple[Floats, NDArray[np.int64]]:
    """Drops points that repeat their predecessor, so that no segment has length zero."""
    keep = np.any(points != np.roll(points, -1, axis=0), axis=1)
    return points[keep], owner[keep]


def _meetings(
    points: Floats, owner: NDArray[np.int64]
) -> tuple[list[tuple[int, int, tuple[float, float]]], NDArray[np.object_]]:
    """Pairs of edges whose segments meet away from a common corner, with the place (at most a thousand)."""
    count = len(points)
    following = np.roll(points, -1, axis=0)
    segments = shapely.linestrings(np.stack([points, following], axis=1))
    tree = shapely.STRtree(segments)
    found: list[tuple[int, int, tuple[float, float]]] = []
    places: list[shapely.Geometry] = []
    for start in range(0, count, _CHUNK):
        chunk = np.arange(start, min(start + _CHUNK, count))
        local, other = tree.query(segments[chunk], predicate="intersects")
        first = chunk[local]
        apart = (other - first) % count
        earlier = first < other
        neighbours = (apart == 1) | (apart == count - 1)
        keep = earlier & (~neighbours | _fold_back(points, following, first, other, apart))
        for i, j in zip(first[keep], other[keep], strict=True):
            meeting = shapely.intersection(segments[i], segments[j])
            if meeting.is_empty:
                continue
            place = shapely.centroid(meeting)
            found.append((int(owner[i]), int(owner[j]), (float(place.x), float(place.y))))
            places.append(place)
            if len(found) >= _MAX_MEETINGS:
                return found, np.array(places)
    return found, np.array(places)


def _fold_back(
    points: Floats,
    following: Floats,
    first: NDArray[np.int64],
    other: NDArray[np.int64],
    apart: NDArray[np.int64],
) -> NDArray[np.bool_]:
    """Whether neighbouring segments run back over each other instead of meeting at their corner alone."""
    a, b = np.where(apart == 1, first, other), np.where(apart == 1, other, first)
    u, v = following[a] - points[a], following[b] - points[b]
    across = u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0]
    return ((u * v).sum(axis=1) < 0) & (across == 0)


def _wrongly_wound_faces(ring: Floats, area: float) -> NDArray[np.object_]:
    """Faces of the plane cut by the closed polyline whose winding number a simple loop cannot have."""
    noded = shapely.union_all(shapely.linestrings(ring))
    faces = shapely.get_parts(shapely.polygonize(shapely.get_parts(noded)))
    if not len(faces):
        return faces
    inner = shapely.get_coordinates(shapely.point_on_surface(faces))
    right = 1 if area >= 0 else -1
    winding = np.array([_winding(ring, p) for p in inner])
    return faces[(winding != 0) & (winding != right)]


def _winding(ring: Floats, point: Floats) -> int:
    """Winding number of a closed polyline around a point."""
    a, b = ring[:-1] - point, ring[1:] - point
    side = a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]
    upward = (a[:, 1] <= 0) & (b[:, 1] > 0) & (side > 0)
    downward = (a[:, 1] > 0) & (b[:, 1] <= 0) & (side < 0)
    return int(upward.sum()) - int(downward.sum())
