"""Style3D's pattern JSON, which GarmageNet's stitching network writes, as outlines and stitches.

Panels are a list; each has a `center` and `seqEdges`, the first of them (type 3) the outline. Its edges list
points in mm that the curve passes through, relative to the centre. A stitch joins two stretches of outlines.
Each runs from a `start` to an `end`, an edge and a share of its length; along the outline, or against it
where `isCounterClockWise` is set. The starts are sewn together, and the ends.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, cast

import numpy as np

from swifttailor.arrays import Floats
from swifttailor.errors import PatternError
from swifttailor.pattern.json_values import as_list, as_number, as_object, as_text, as_vector

MAX_PANELS = 500
MAX_EDGES = 2000
MAX_POINTS, MAX_ALL_POINTS = 200, 100_000
MAX_STITCHES = 5000
_CM = 0.1
_OUTLINE = 3
_SAME_CM = 1e-3
_FINE = 6
"""Pieces of a polyline between two points that a curve passes through."""


@dataclass(frozen=True)
class Outline:
    """The outline of one panel."""

    name: str
    edges: tuple[Floats, ...]
    """Polyline (n, 2) of each edge in cm, both ends included; each starts where the one before ends."""
    lines_inside: int
    """How many holes and inner lines the file has, which a panel here does not."""


@dataclass(frozen=True)
class Stretch:
    """A part of an outline that is sewn."""

    panel: int
    start: float
    """Where it begins: number of the edge plus the share of its length."""
    end: float
    forward: bool
    """Whether it runs the way that the outline does."""


@dataclass(frozen=True)
class Style3DPattern:
    """What the file says of panels and stitches."""

    outlines: tuple[Outline, ...]
    stitches: tuple[tuple[Stretch, Stretch], ...]
    left_out: int
    """Stitches to inner lines, holes or panels that are not there."""


def parse_style3d(content: Any) -> Style3DPattern:
    """Reads the parsed file.

    Raises:
        PatternError: It is not such a file, or holds more than a garment has.
    """
    top = as_object(content, "the file")
    panels = as_list(top.get("panels"), "panels", limit=MAX_PANELS)
    if not panels:
        raise PatternError("panels is empty; a pattern has at least one panel.")
    outlines, place_of = [], {}
    for k, raw in enumerate(panels):
        where = f"panels[{k}]"
        panel = as_object(raw, where)
        outline, ids = _outline(panel, where, k)
        piece = as_text(panel.get("id"), f"{where}.id")
        place_of |= {(piece, edge): (k, number) for number, edge in enumerate(ids)}
        outlines.append(outline)
        if sum(len(e) for o in outlines for e in o.edges) > MAX_ALL_POINTS * _FINE:
            raise PatternError(
                f"panels: more than {MAX_ALL_POINTS} points, which is more than any garment has."
            )
    names = [o.name for o in outlines]
    if len(set(names)) < len(names):
        outlines = [Outline(f"panel_{k}", o.edges, o.lines_inside) for k, o in enumerate(outlines)]
    listed = as_list(top.get("stitches", []), "stitches", limit=MAX_STITCHES)
    stitches = []
    for k, raw in enumerate(listed):
        sides = as_list(raw, f"stitches[{k}]", (2,))
        ends = [_stretch(as_object(s, f"stitches[{k}]"), f"stitches[{k}]", place_of) for s in sides]
        if None not in ends:
            stitches.append(cast("tuple[Stretch, Stretch]", tuple(ends)))
    return Style3DPattern(tuple(outlines), tuple(stitches), len(listed) - len(stitches))


def _outline(panel: dict[str, Any], where: str, number: int) -> tuple[Outline, list[str]]:
    center = as_vector(
        as_list(panel.get("center", [0, 0]), f"{where}.center", (2, 3))[:2], f"{where}.center", 2
    )
    lines = as_list(panel.get("seqEdges"), f"{where}.seqEdges", limit=MAX_EDGES)
    outer = [as_object(line, f"{where}.seqEdges") for line in lines]
    outer = [line for line in outer if line.get("type") == _OUTLINE]
    if len(outer) != 1:
        raise PatternError(f"{where}: one outline (type 3) was expected, got {len(outer)}.")
    edges, ids = [], []
    for k, raw in enumerate(as_list(outer[0].get("edges"), f"{where}.edges", limit=MAX_EDGES)):
        place = f"{where}.edges[{k}]"
        edge = as_object(raw, place)
        points = as_list(edge.get("controlPoints"), f"{place}.controlPoints", limit=MAX_POINTS)
        if len(points) < 2:
            raise PatternError(f"{place}.controlPoints: at least 2 points are needed, got {len(points)}.")
        flat = [as_vector(as_list(p, place, (2, 3))[:2], place, 2) for p in points]
        edges.append(_smooth((np.array(flat) + center) * _CM))
        ids.append(as_text(edge.get("id"), f"{place}.id"))
    if len(edges) < 2:
        raise PatternError(f"{where}: at least 2 edges are needed, got {len(edges)}.")
    for k, edge in enumerate(edges):  # ends that are rounded apart are one corner
        edge[0] = edges[k - 1][-1]
    label = panel.get("label") or panel.get("name") or f"{number:02d}"
    name = as_text(str(label), f"{where}.label")
    return Outline(name, tuple(edges), len(lines) - 1), ids


def _smooth(points: Floats) -> Floats:
    """A fine polyline along the smooth curve through points (n, 2), with the same ends."""
    from scipy.interpolate import CubicSpline

    apart = np.concatenate([[True], np.linalg.norm(np.diff(points, axis=0), axis=1) > _SAME_CM])
    own = points[apart] if apart[-1] else np.concatenate([points[apart][:-1], points[-1:]])
    if len(own) < 3:
        return points[[0, -1]].copy()
    at = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(own, axis=0), axis=1))])
    fine = np.interp(np.arange((len(own) - 1) * _FINE + 1) / _FINE, np.arange(len(own)), at)
    curve = CubicSpline(at, own)(fine)
    curve[0], curve[-1] = points[0], points[-1]
    return curve


def _stretch(
    side: dict[str, Any], where: str, place_of: dict[tuple[str, str], tuple[int, int]]
) -> Stretch | None:
    ends = []
    for key in ("start", "end"):
        end = as_object(side.get(key), f"{where}.{key}")
        place = place_of.get((str(end.get("clothPieceId")), str(end.get("edgeId"))))
        if place is None:
            return None
        share = as_number(end.get("param"), f"{where}.{key}.param")
        ends.append((place[0], place[1] + min(max(share, 0.0), 1.0)))
    if ends[0][0] != ends[1][0]:
        return None
    return Stretch(ends[0][0], ends[0][1], ends[1][1], not side.get("isCounterClockWise", False))
