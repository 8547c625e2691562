"""Stitches between stretches of outlines become stitches between edges: outlines are cut where stretches end.

A stretch may end in the middle of an edge and run over several. GarmentCode's format joins whole edges, so
both sides are cut where either begins, ends or has a corner, at equal shares of their lengths.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import chain, pairwise

import numpy as np

from swifttailor.arrays import Floats
from swifttailor.data.released.style3d_pattern import Outline, Stretch, Style3DPattern
from swifttailor.pattern import Cubic, Edge, EdgeRef, Line, Stitch
from swifttailor.pattern.curve import Curve, to_relative

_SNAP_CM = 0.5
"""Ends closer to a corner than this are at the corner: the network places them on points 1 to 2 cm apart."""
_STRAIGHT_CM = 0.1
_MOST_TURN, _MOST_PARTS = np.deg2rad(100.0), 8
"""How far a curve may turn that one cubic follows."""
_ROUNDS = 6
_MAX_CUTS = 400


@dataclass(frozen=True)
class CutOutline:
    """Corners (n, 2) cm and the edges between them, cut where stitches end."""

    vertices: Floats
    edges: tuple[Edge, ...]


class _Loop:
    """An outline by arc length, with the places where it is cut."""

    def __init__(self, outline: Outline) -> None:
        self.points = np.concatenate([edge[:-1] for edge in outline.edges] + [outline.edges[0][:1]])
        steps = np.linalg.norm(np.diff(self.points, axis=0), axis=1)
        self.lengths = np.concatenate([[0.0], np.cumsum(steps)])
        counts = np.cumsum([0] + [len(edge) - 1 for edge in outline.edges])
        self.corners = self.lengths[counts]
        self.total = float(self.lengths[-1])
        bends = [self._bends(edge, at) for edge, at in zip(outline.edges, self.corners[:-1], strict=True)]
        self.cuts: list[float] = [0.0]
        for at in (*self.corners[1:-1].tolist(), *chain.from_iterable(bends)):
            self.cut(at)  # corners nearer than that to others are no corners

    @staticmethod
    def _bends(edge: Floats, at: float) -> list[float]:
        """Where an edge that turns far is cut, so that one cubic follows each part."""
        steps = np.diff(edge, axis=0)
        lengths = np.linalg.norm(steps, axis=1)
        steps = steps[lengths > 1e-9]
        if len(steps) < 2:
            return []
        angles = np.arctan2(steps[:, 1], steps[:, 0])
        turns = np.abs((np.diff(angles) + np.pi) % (2 * np.pi) - np.pi).sum()
        parts = min(int(turns / _MOST_TURN) + 1, _MOST_PARTS)
        return (at + lengths.sum() * np.arange(1, parts) / parts).tolist()

    def place(self, parameter: float) -> float:
        """Arc length, cm, of an edge's number plus a share of it."""
        edge = min(int(parameter), len(self.corners) - 2)
        low, high = self.corners[edge], self.corners[edge + 1]
        return float(low + (parameter - edge) * (high - low)) % self.total

    def cut(self, at: float) -> float:
        """Cuts there, or says which cut is so near that it is the same."""
        at %= self.total
        for near in self.cuts:
            gap = abs(near - at)
            if min(gap, self.total - gap) < _SNAP_CM:
                return near
        self.cuts = sorted([*self.cuts, at])
        return at

    def at(self, lengths: Floats) -> Floats:
        return np.stack([np.interp(lengths, self.lengths, self.points[:, axis]) for axis in (0, 1)], axis=1)

    def outline(self) -> CutOutline:
        bounds = [*self.cuts, self.cuts[0] + self.total]
        corners = self.at(np.array(self.cuts))
        edges = tuple(Edge(self._curve(a, b)) for a, b in pairwise(bounds))
        return CutOutline(corners, edges)

    def _curve(self, low: float, high: float) -> Curve:
        """The stretch between two cuts, as a straight line or one cubic through its points."""
        share = np.linspace(0.0, 1.0, 25)
        points = self.at((low + share * (high - low)) % self.total)
        points[-1] = self.at(np.array([high % self.total]))[0]
        chord = points[[0, -1]]
        along = chord[1] - chord[0]
        length = float(np.hypot(*along))
        if length < 1e-6:
            return Line()
        off = (points - chord[0]) @ np.array([-along[1], along[0]]) / length
        if np.abs(off).max() < _STRAIGHT_CM:
            return Line()
        ends = np.outer((1 - share) ** 3, chord[0]) + np.outer(share**3, chord[1])
        weights = np.stack([3 * share * (1 - share) ** 2, 3 * share**2 * (1 - share)], axis=1)
        controls = np.linalg.lstsq(weights, points - ends, rcond=None)[0]
        return Cubic(to_relative(controls[0], chord), to_relative(controls[1], chord))


@dataclass
class _Side:
    loop: _Loop
    panel: int
    start: float
    end: float
    forward: bool

    @property
    def length(self) -> float:
        run = self.end - self.start if self.forward else self.start - self.end
        return run % self.loop.total or self.loop.total

    def share(self, cut: float) -> float | None:
        """How far along a cut lies, from 0 to 1; None where it does not lie on the side."""
        run = (cut - self.start if self.forward else self.start - cut) % self.loop.total
        return run / self.length if run <= self.length + 1e-9 else None

    def cut(self, share: float) -> float:
        run = share * self.length
        return self.loop.cut(self.start + run if self.forward else self.start - run)

    def shares(self) -> list[float]:
        inner = [s for c in self.loop.cuts if (s := self.share(c)) is not None and 1e-9 < s < 1 - 1e-9]
        return sorted(inner)

    def edges(self) -> list[int]:
        """Numbers of the edges between the cuts, in the order in which the side runs over them."""
        count = len(self.loop.cuts)
        first, last = self.loop.cuts.index(self.start), self.loop.cuts.index(self.end)
        step = (last - first if self.forward else first - last) % count or count
        if self.forward:
            return [(first + k) % count for k in range(step)]
        return [(first - 1 - k) % count for k in range(step)]


def cut_at_stitches(pattern: Style3DPattern) -> tuple[list[CutOutline], list[Stitch], int]:
    """Cuts all outlines and pairs their edges.

    Returns:
        The outlines, the stitches between their edges, and how many stitches could not be kept, since their
        sides fall into unequal numbers of edges, or overlap others.
    """
    loops = [_Loop(outline) for outline in pattern.outlines]
    pairs = []
    lost = 0
    for sides in pattern.stitches:
        first, second = (_side(loops, stretch) for stretch in sides)
        if first is None or second is None:
            lost += 1
        else:
            pairs.append((first, second))
    for _ in range(_ROUNDS):
        before = sum(len(loop.cuts) for loop in loops)
        for first, second in pairs:
            for one, other in ((first, second), (second, first)):
                for share in one.shares():
                    if len(other.loop.cuts) < _MAX_CUTS:
                        other.cut(share)
        if sum(len(loop.cuts) for loop in loops) == before:
            break
    names = [outline.name for outline in pattern.outlines]
    stitches: list[Stitch] = []
    used: set[tuple[int, int]] = set()
    for first, second in pairs:
        edges = list(zip(first.edges(), second.edges(), strict=False))
        refs = {(first.panel, a) for a, _ in edges} | {(second.panel, b) for _, b in edges}
        even = len(first.edges()) == len(second.edges()) and len(refs) == 2 * len(edges)
        if not even or refs & used:
            lost += 1
            continue
        used |= refs
        stitches += [
            Stitch(
                EdgeRef(names[first.panel], a),
                EdgeRef(names[second.panel], b),
                first.forward == second.forward,
            )
            for a, b in edges
        ]
    return [loop.outline() for loop in loops], stitches, lost


def _side(loops: list[_Loop], stretch: Stretch) -> _Side | None:
    """The side of a stitch; None where it is too short to be sewn."""
    loop = loops[stretch.panel]
    start, end = loop.place(stretch.start), loop.place(stretch.end)
    if _Side(loop, stretch.panel, start, end, stretch.forward).length < 2 * _SNAP_CM:
        return None
    return _Side(loop, stretch.panel, loop.cut(start), loop.cut(end), stretch.forward)
