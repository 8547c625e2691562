"""Knife pleats laid around the body: the network has seen none, and puts their layers through each other."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from scipy.spatial import ConvexHull

from swifttailor.arrays import Floats
from swifttailor.body import Body
from swifttailor.garment.hull_reach import hull_reach
from swifttailor.panel_mesh.pattern_mesh import PatternMesh
from swifttailor.pattern import EdgeRef, Pattern
from swifttailor.pattern.panel import Panel

LAYER_CM = 0.7
"""So far apart layers are laid; the solver keeps them about so far from each other."""
_OFF_BODY_CM = 0.9
_NAME = re.compile(r"skirt_(pleat|under)_(\d+)_(front|back)")
_SLICE_CM, _ARMS_CM = 3.0, 27.0
"""Thickness of what is looked at of the body at a height, and how far from the middle its arms hang there."""
_ROUND = 180


@dataclass(frozen=True)
class _Strip:
    """A strip in the coordinates of its half: x along the waist from the right, d down from it, cm."""

    panel: int
    k: int
    under: bool
    shift: tuple[float, float]
    """Added to panel-local x; height of the waist, from which panel-local y is subtracted."""
    left: tuple[float, float]
    right: tuple[float, float]
    """Lines of the folds beside what is seen of it: x at the waist, and by how much it grows a cm."""


def pleats_laid(mesh: PatternMesh, vertices: Floats, body: Body) -> Floats | None:
    """Lays the strips of a pleated skirt around the body, layer by layer, as wide as they are cut.

    Args:
        mesh: Of the garment.
        vertices: (v, 3) where the network put it, cm; what the pleats are sewn to stays there.
        body: What it is worn by.

    Returns:
        (v, 3) where it lies then; None where the garment has no pleats.
    """
    halves = {face: _strips(mesh.pattern, face) for face in ("front", "back")}
    if not all(halves.values()):
        return None
    names = [panel.name for panel in mesh.pattern.panels]
    pleats = np.array([_NAME.fullmatch(name) is not None for name in names])
    of_pleat = pleats[mesh.flat_panel]
    count = np.bincount(mesh.weld, minlength=mesh.vertex_count)
    inside = np.bincount(mesh.weld, of_pleat, mesh.vertex_count)
    held, moved = (inside > 0) & (inside < count), inside == count
    if not held.any():
        return None
    top = float(vertices[held, 1].mean())
    widths = {face: (_end(strips, 0), _end(strips, -1)) for face, strips in halves.items()}
    girth, growth = (sum(right[part] - left[part] for left, right in widths.values()) for part in (0, 1))
    fall = math.sqrt(max(1 - (growth / (2 * math.pi)) ** 2, 0.25))
    oval = _Oval(body, top)
    laid = np.zeros((len(mesh.flat_vertices), 3))
    for face, strips in halves.items():
        left, right = widths[face]
        for strip in strips:
            flat = mesh.flat_panel == strip.panel
            x = mesh.flat_vertices[flat, 0] + strip.shift[0]
            down = strip.shift[1] - mesh.flat_vertices[flat, 1]
            begins, ends = left[0] + left[1] * down, right[0] + right[1] * down
            share = np.clip((x - begins) / (ends - begins), 0.0, 1.0)
            wider = (girth + growth * down) / girth
            laid[flat] = oval.at(share, top - fall * down, wider, LAYER_CM * _layer(strip, x, down), face)
    welded = mesh.welded_mean(laid)
    placed = vertices.copy()
    placed[moved] = welded[moved]
    return placed


def _layer(strip: _Strip, x: Floats, down: Floats) -> Floats:
    """How many layers points of a strip lie below the outermost, as a number below 0."""
    fold = strip.left[0] + strip.left[1] * down
    if strip.under:
        depth = np.maximum((fold - x).max(), 1e-6)
        return -2.0 * (fold - x) / depth
    width = np.maximum(strip.right[0] + strip.right[1] * down - fold, 1e-6)
    if not strip.k:  # nothing lies over its right side
        return np.minimum((x - fold) / width - 1.0, 0.0)
    return np.where(x < fold, -2.0, -2.0 + 2.0 * (x - fold) / width)


def _strips(pattern: Pattern, face: str) -> list[_Strip]:
    """Of one half, from the wearer's right on; empty where they are not what a pleated skirt has."""
    found: dict[tuple[str, int], int] = {}
    for number, panel in enumerate(pattern.panels):
        name = _NAME.fullmatch(panel.name)
        if name is not None and name[3] == face:
            found[name[1], int(name[2])] = number
    seen = [found[key] for key in sorted(found) if key[0] == "pleat"]
    if not seen or set(found) != {
        *[("pleat", k) for k in range(len(seen))],
        *[("under", k) for k in range(1, len(seen))],
    }:
        return []
    sewn = {
        (ref.panel, ref.edge) for stitch in pattern.stitches for ref in stitch.sides if _to_band(stitch.sides)
    }
    strips: list[_Strip] = []
    at = 0.0
    for k, number in enumerate(seen):
        panel = pattern.panels[number]
        # Several edges where a seam or dart of a bodice ends on a strip.
        edges = [edge for edge in range(len(panel.edges)) if (panel.name, edge) in sewn]
        if not edges:
            return []
        ends = np.concatenate([panel.chord(edge) for edge in edges])
        first, last = ends[ends[:, 0].argmin()], ends[ends[:, 0].argmax()]
        shift = (at - first[0], max(first[1], last[1]))
        right = _line(panel, last, shift)
        left = strips[-1].right if strips else _line(panel, first, shift)
        if right is None or left is None:
            return []
        if k:
            under = pattern.panels[found["under", k]]
            highest = under.vertices[under.vertices[:, 1].argmax()]
            moved = (at - highest[0], highest[1])
            strips.append(_Strip(found["under", k], k, True, moved, left, left))
        strips.append(_Strip(number, k, False, shift, left, right))
        at = last[0] + shift[0]
    return strips


def _to_band(sides: Sequence[EdgeRef]) -> bool:
    """Whether a stitch joins a strip to what is no strip."""
    return any(_NAME.fullmatch(ref.panel) is None for ref in sides)


def _line(panel: Panel, corner: Floats, shift: tuple[float, float]) -> tuple[float, float] | None:
    """The side of a strip from a corner at the waist down, in the coordinates of its half."""
    near = int(np.linalg.norm(panel.vertices - corner, axis=1).argmin())
    others = [panel.vertices[(near + step) % len(panel.vertices)] for step in (1, -1)]
    low = min(others, key=lambda point: point[1])
    drop = corner[1] - low[1]
    if drop < 1.0:
        return None
    slope = (low[0] - corner[0]) / drop
    return float(corner[0] + shift[0] - slope * (shift[1] - corner[1])), float(slope)


def _end(strips: list[_Strip], which: int) -> tuple[float, float]:
    seen = [strip for strip in strips if not strip.under]
    return seen[which].left if which == 0 else seen[which].right


class _Oval:
    """Around the body: as it is at the waist, wider below, and nowhere in the body."""

    def __init__(self, body: Body, top: float) -> None:
        self.body = body
        self.middle, radius = self._around(top)
        self.waist = radius
        self.slices: dict[int, Floats] = {}
        angle = _angles()
        points = self.middle + radius[:, None] * np.stack([np.sin(angle), np.cos(angle)], axis=1)
        self.reached = {}
        for face in ("front", "back"):
            # From the wearer's right (-x) to the left, by the length of the way.
            ends = np.pi / 2 if face == "front" else -3 * np.pi / 2
            turn = np.linspace(-np.pi / 2, ends, _ROUND)
            way = np.stack(
                [np.interp(turn, angle, points[:, axis], period=2 * np.pi) for axis in (0, 1)], axis=1
            )
            gone = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(way, axis=0), axis=1))])
            self.reached[face] = (gone / gone[-1], turn)

    def at(self, share: Floats, height: Floats, wider: Floats, lift: Floats, face: str) -> Floats:
        """(n, 3) points at a share of the way along a half, at heights, on an oval `wider` than the waist."""
        shares, turns = self.reached[face]
        turn = np.interp(share, shares, turns)
        angle = _angles()
        radius = wider * np.interp(turn, angle, self.waist, period=2 * np.pi)
        body = np.zeros(len(turn))
        rows = np.round(height / _SLICE_CM).astype(int)
        for row in np.unique(rows):
            here = rows == row
            if row not in self.slices:
                self.slices[row] = self._around(row * _SLICE_CM)[1]
            body[here] = np.interp(turn[here], angle, self.slices[row], period=2 * np.pi)
        inmost = body + _OFF_BODY_CM + 2 * LAYER_CM
        radius = np.maximum(radius, inmost) + lift
        return np.stack(
            [self.middle[0] + radius * np.sin(turn), height, self.middle[1] + radius * np.cos(turn)], axis=1
        )

    def _around(self, height: float) -> tuple[Floats, Floats]:
        """Middle (2,) of the body at a height, and how far from it its hull reaches in all directions, cm."""
        points = self.body.vertices
        near = (np.abs(points[:, 1] - height) <= _SLICE_CM) & (np.abs(points[:, 0]) < _ARMS_CM)
        flat = points[near][:, [0, 2]]
        middle = getattr(self, "middle", None)
        if len(flat) < 8:
            return (np.zeros(2) if middle is None else middle), np.zeros(_ROUND)
        hull = ConvexHull(flat)
        if middle is None:
            corners = flat[hull.vertices]
            middle = (corners.min(axis=0) + corners.max(axis=0)) / 2
        angle = _angles()
        ways = np.stack([np.sin(angle), np.cos(angle)], axis=1)
        return middle, np.maximum(hull_reach(hull, middle, ways), 0.0)


def _angles() -> Floats:
    return np.linspace(-np.pi, np.pi, _ROUND, endpoint=False)
