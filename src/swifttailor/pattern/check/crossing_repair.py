"""Moves corners and flattens curves by a few millimetres so that an outline no longer overlaps itself."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np
import shapely

from swifttailor.arrays import Floats
from swifttailor.pattern import curve as curves
from swifttailor.pattern.check.crossings import Crossing, find_crossing
from swifttailor.pattern.check.outline import trace_outline
from swifttailor.pattern.curve import Arc, Cubic, Curve, Line, Quadratic
from swifttailor.pattern.panel import Panel

MAX_MOVE_CM = 0.5
"""No point of the outline of a pattern that was drawn is moved further: beyond that the shape is wrong, not
inexact."""
CLEARANCE_CM = 0.01
"""Gap left between parts of the outline that overlapped."""

MOST_PLACES = 64
"""An outline that meets itself more often is no slip: trying to mend it would take minutes and fail."""
MOST_EDGES_TRIED = 100_000
"""Edges of trial outlines looked at for one pattern, a few seconds' work; what is left then is left alone."""
_MAX_ROUNDS = 8
_FLATTENINGS = (0.995, 0.99, 0.98, 0.97, 0.96, 0.95, 0.93, 0.9, 0.8, 0.65, 0.5, 0.3, 0.0)
_BULGES = (1.1, 1.5, 2.0, 3.0, 5.0)
"""Ways that the middle of an arc is moved, of the depth of a crossing."""


@dataclass
class Effort:
    """How much may still be tried."""

    edges: int = MOST_EDGES_TRIED

    def spend(self, panel: Panel) -> bool:
        """Counts one more trial; False where there is nothing left for it."""
        self.edges -= len(panel.edges)
        return self.edges >= 0


def mend_crossings(
    panel: Panel,
    largest_move: float = MAX_MOVE_CM,
    largest_share: float = 0.0,
    effort: Effort | None = None,
) -> tuple[Panel, float] | None:
    """Tries to free an outline of self-intersections.

    A corner that pokes through another edge is put back to its side of it; where two neighbouring edges
    cross beside their common corner, the corner is moved to the crossing; where a curve bulges over another
    edge, it is flattened, or made rounder if it is an arc. The smallest change that works is taken; but a
    flounce gets even.

    Args:
        panel: A panel whose outline meets itself.
        largest_move: How far a point may be moved, cm.
        largest_share: How far of the panel's size, where that is more.
        effort: What the trials are counted in; each panel has its own when None.

    Returns:
        The panel with a simple outline and the longest way a point of it was moved in cm, or None when
        changes of up to that do not do it.
    """
    mended, outline = panel, trace_outline(panel)
    effort = Effort() if effort is None else effort
    crossing, largest_move = find_crossing(outline), max(largest_move, largest_share * outline.size)
    ring = _evenly_wide(panel) if crossing is not None else None
    if ring is not None and find_crossing(trace_outline(ring)) is None:
        moved = _distance_moved(panel, ring)
        if moved <= largest_move:
            return ring, moved
    for _ in range(_MAX_ROUNDS):
        if crossing is None:
            return mended, _distance_moved(panel, mended)
        if not np.isfinite(crossing.depth) or crossing.depth > largest_move:
            return None
        if crossing.places > MOST_PLACES:
            return None
        trials = [(_distance_moved(panel, trial), trial) for trial in _moves(mended, crossing, largest_move)]
        best, best_crossing = None, crossing
        for moved, trial in sorted(trials, key=lambda t: t[0]):
            if moved > largest_move or not effort.spend(trial):
                break
            left = find_crossing(trace_outline(trial))
            if left is None:
                return trial, moved
            if _badness(left) < _badness(best_crossing):
                best, best_crossing = trial, left
        if best is None:
            return None
        mended, crossing = best, best_crossing
    return None


def _evenly_wide(panel: Panel) -> Panel | None:
    """A flounce, two arcs between two lines, as wide in the middle as at its ends; None for other panels."""
    kinds = [type(edge.curve) for edge in panel.edges]
    if len(kinds) != 4 or kinds.count(Arc) != 2 or kinds[0] != kinds[2] or kinds.count(Line) != 2:
        return None
    arcs = (0, 2) if kinds[0] is Arc else (1, 3)
    chords = {k: panel.chord(k) for k in range(4)}
    middles = {k: curves.evaluate(panel.edges[k].curve, chords[k], np.array([0.5]))[0] for k in arcs}
    lengths = [float(np.hypot(*(chords[k][1] - chords[k][0]))) for k in range(4)]
    outer, inner = sorted(arcs, key=lambda k: -lengths[k])
    bulge = middles[outer] - chords[outer].mean(axis=0)
    if lengths[inner] == 0.0 or not bulge.any():
        return None
    way = bulge / np.hypot(*bulge) * sum(lengths[k] for k in range(4) if k not in arcs) / 4
    middle = (middles[outer] + middles[inner]) / 2
    for k, aim in ((outer, middle + way), (inner, middle - way)):
        sagitta = float(np.hypot(*(middles[k] - chords[k].mean(axis=0))))
        out = aim - chords[k].mean(axis=0)
        arc = _bulged(panel.edges[k].curve, chords[k], float(out @ bulge / np.hypot(*bulge)) - sagitta)
        if arc is None:
            return None
        panel = _with_curve(panel, k, arc)
    return panel


def _distance_moved(before: Panel, after: Panel) -> float:
    """Longest way, cm, between points of equal parameter on two panels with the same edges."""
    t = np.linspace(0.0, 1.0, 17)
    longest = 0.0
    for k, (old, new) in enumerate(zip(before.edges, after.edges, strict=True)):
        if old == new and np.array_equal(before.chord(k), after.chord(k)):
            continue
        points = [curves.evaluate(e.curve, p.chord(k), t) for e, p in ((old, before), (new, after))]
        longest = max(longest, float(np.hypot(*(points[1] - points[0]).T).max()))
    return longest


def _badness(crossing: Crossing) -> tuple[int, float]:
    return crossing.places, crossing.depth


def _moves(panel: Panel, crossing: Crossing, largest_move: float) -> Iterator[Panel]:
    """The panel with one corner moved or one curve flattened."""
    for corner, place in _corner_moves(panel, crossing, largest_move):
        vertices = panel.vertices.copy()
        vertices[corner] = place
        yield replace(panel, vertices=vertices)
    for k in set(crossing.edges):
        for factor in _FLATTENINGS:
            flatter = _flattened(panel.edges[k].curve, panel.chord(k), factor)
            if flatter is not None:
                yield _with_curve(panel, k, flatter)
        for share in _BULGES:
            for way in (share * crossing.depth, -share * crossing.depth):
                arc = _bulged(panel.edges[k].curve, panel.chord(k), way)
                if arc is not None:
                    yield _with_curve(panel, k, arc)


def _with_curve(panel: Panel, edge: int, curve: Curve) -> Panel:
    edges = list(panel.edges)
    edges[edge] = replace(edges[edge], curve=curve)
    return replace(panel, edges=tuple(edges))


def _bulged(curve: Curve, chord: Floats, way: float) -> Arc | None:
    """An arc whose middle is so much further from its chord, cm; None for other curves and for none left."""
    half = float(np.hypot(*(chord[1] - chord[0]))) / 2
    if not isinstance(curve, Arc) or half == 0.0:
        return None
    radius = max(curve.radius, half)
    rest = np.sqrt(radius**2 - half**2)
    sagitta = radius + (rest if curve.large else -rest) + way
    if sagitta <= 0:
        return None
    return replace(curve, radius=float((half**2 + sagitta**2) / (2 * sagitta)), large=bool(sagitta > half))


def _flattened(curve: Curve, chord: Floats, factor: float) -> Curve | None:
    """The curve with its bulge times `factor`; None for lines, arcs beyond a semicircle and bare points."""
    if isinstance(curve, Quadratic):
        return Quadratic((curve.control[0], curve.control[1] * factor))
    if isinstance(curve, Cubic):
        (x1, y1), (x2, y2) = curve.control_1, curve.control_2
        return Cubic((x1, y1 * factor), (x2, y2 * factor))
    half = float(np.hypot(*(chord[1] - chord[0]))) / 2
    if not isinstance(curve, Arc) or curve.large or half == 0.0:
        return None
    radius = max(curve.radius, half)
    sagitta = factor * (radius - np.sqrt(radius**2 - half**2))
    return replace(curve, radius=float((half**2 + sagitta**2) / (2 * sagitta))) if sagitta > 0 else None


def _corner_moves(panel: Panel, crossing: Crossing, largest_move: float) -> Iterator[tuple[int, Floats]]:
    """Corners and where to try putting them."""
    count = len(panel.edges)
    first, second = crossing.edges
    shared = {first, (first + 1) % count} & {second, (second + 1) % count}
    for corner in sorted(shared):
        yield corner, np.array(crossing.point)
    lines = {k: shapely.linestrings(panel.flatten_edge(k, 0.001)) for k in (first, second)}
    for own, other in ((first, second), (second, first)):
        for corner in (own, (own + 1) % count):
            if corner in (other, (other + 1) % count):
                continue
            here = panel.vertices[corner]
            target = shapely.get_coordinates(shapely.shortest_line(shapely.points(here), lines[other]))[1]
            way = target - here
            distance = float(np.hypot(*way))
            if distance > largest_move:
                continue
            direction = way / distance if distance > 1e-9 else _across(panel, other, target)
            for sign in (1.0, -1.0):
                for clearance in (CLEARANCE_CM, 5 * CLEARANCE_CM):
                    yield corner, here + sign * direction * ((distance if sign > 0 else 0.0) + clearance)


def _across(panel: Panel, edge: int, point: Floats) -> Floats:
    """Unit normal (2,) of an edge's polyline at the segment nearest to a point."""
    line = panel.flatten_edge(edge, 0.001)
    middle = (line[1:] + line[:-1]) / 2
    k = int(np.argmin(np.hypot(*(middle - point).T)))
    step = line[k + 1] - line[k]
    return np.array([-step[1], step[0]]) / max(float(np.hypot(*step)), 1e-300)
