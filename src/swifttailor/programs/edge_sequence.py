"""A sequence of edges, mostly a chain: each edge starts from the very vertex at which the one before ends."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import overload

from swifttailor.programs.edges import Edge, Vertex, to_complex, to_vertex


class EdgeSequence:
    """Edges in order. Methods that change it return it."""

    def __init__(self, *items: Edge | EdgeSequence | Sequence[Edge | EdgeSequence]) -> None:
        """Makes a sequence of the edges themselves, none of them copied."""
        self.edges: list[Edge] = []
        for item in items:
            self.append(item)

    # what it is

    @overload
    def __getitem__(self, i: int) -> Edge: ...
    @overload
    def __getitem__(self, i: slice) -> EdgeSequence: ...
    def __getitem__(self, i: int | slice) -> Edge | EdgeSequence:
        return EdgeSequence(self.edges[i]) if isinstance(i, slice) else self.edges[i]

    def __len__(self) -> int:
        return len(self.edges)

    def __iter__(self) -> Iterator[Edge]:
        return iter(self.edges)

    def __contains__(self, edge: object) -> bool:
        return any(edge is e for e in self.edges)

    def index(self, edge: Edge) -> int:
        """Where that very edge stands."""
        return next(i for i, e in enumerate(self.edges) if e is edge)

    def length(self) -> float:
        """Length of all edges together, cm."""
        return sum(e.length() for e in self.edges)

    def lengths(self) -> list[float]:
        """Length of each edge, cm."""
        return [e.length() for e in self.edges]

    def fractions(self) -> list[float]:
        """Each edge's part of the whole length."""
        lengths = self.lengths()
        total = sum(lengths)
        return [part / total for part in lengths]

    def is_loop(self) -> bool:
        """Whether the last edge ends at the vertex from which the first one starts."""
        return len(self) > 1 and self.edges[0].start is self.edges[-1].end

    def is_chained(self) -> bool:
        """Whether each edge starts from the vertex at which the one before ends."""
        pairs = zip(self.edges[:-1], self.edges[1:], strict=True)
        return len(self) > 1 and all(after.start is before.end for before, after in pairs)

    def verts(self) -> list[Vertex]:
        """The vertices themselves, in order; those that neighbours share once."""
        verts = [self.edges[0].start]
        for e in self.edges:
            if e.start is not verts[-1]:
                verts.append(e.start)
            verts.append(e.end)
        if verts[0] is verts[-1]:
            verts.pop()
        return verts

    def points(self, inside: int | None = None) -> list[Vertex]:
        """The vertices and, between them, points on the edges (see `Edge.points_inside`)."""
        points = [self.edges[0].start]
        for e in self.edges:
            if e.start is not points[-1]:
                points.append(e.start)
            points.extend(e.points_inside(inside))
            points.append(e.end)
        if points[0] is points[-1]:
            points.pop()
        return points

    def shortcut(self) -> tuple[Vertex, Vertex]:
        """Copies of the first start and the last end."""
        return list(self.edges[0].start), list(self.edges[-1].end)

    def bbox(self) -> tuple[float, float, float, float]:
        """Least x, largest x, least y, largest y of the points on it, cm."""
        return _box(self.points())

    # lists of edges

    def append(self, item: Edge | EdgeSequence | Sequence[Edge | EdgeSequence]) -> EdgeSequence:
        """Adds edges at the end."""
        if isinstance(item, Edge):
            self.edges.append(item)
        elif isinstance(item, EdgeSequence):
            self.edges += item.edges
        else:
            for each in item:
                self.append(each)
        return self

    def insert(self, i: int, item: Edge | EdgeSequence | Sequence[Edge]) -> EdgeSequence:
        """Adds edges before the i-th one."""
        self.edges[i:i] = [item] if isinstance(item, Edge) else list(item)
        return self

    def pop(self, i: int | Edge) -> EdgeSequence:
        """Takes out an edge."""
        self.edges.pop(self.index(i) if isinstance(i, Edge) else i)
        return self

    def substitute(self, orig: int | Edge, new: Edge | EdgeSequence | Sequence[Edge]) -> EdgeSequence:
        """Puts edges in the place of one."""
        i = self.index(orig) if isinstance(orig, Edge) else orig % len(self)
        self.edges[i : i + 1] = [new] if isinstance(new, Edge) else list(new)
        return self

    def close_loop(self) -> EdgeSequence:
        """Adds a straight edge from the end to the start if they are not the same vertex."""
        if not self.is_loop():
            self.append(Edge(self[-1].end, self[0].start))
        return self

    # changes of shape

    def reverse(self) -> EdgeSequence:
        """Travels all edges the other way."""
        self.edges.reverse()
        for e in self.edges:
            e.reverse()
        return self

    def translate_by(self, shift: Sequence[float]) -> EdgeSequence:
        """Moves all vertices."""
        for v in self.verts():
            v[0] += shift[0]
            v[1] += shift[1]
        return self

    def snap_to(self, origin: Sequence[float] = (0.0, 0.0)) -> EdgeSequence:
        """Moves all vertices until the first one is at a point."""
        x, y = self[0].start
        return self.translate_by((origin[0] - x, origin[1] - y))

    def rotate(self, angle: float) -> EdgeSequence:
        """Turns all vertices about the first one, radians."""
        turn = complex(math.cos(angle), math.sin(angle))
        fixed = to_complex(self[0].start)
        for v in self.verts():
            v[:] = to_vertex(fixed + (to_complex(v) - fixed) * turn)
        return self

    def extend(self, factor: float) -> EdgeSequence:
        """Stretches along the line from the first start, which stays, to the last end."""
        chained = self
        if not self.is_chained():
            chained = self.chained_order()
            if chained.is_loop():
                return self
        line = to_complex(chained[-1].end) - to_complex(chained[0].start)
        line /= abs(line)
        verts = self.verts()
        fixed = to_complex(verts[0])
        for v in verts:
            along = ((to_complex(v) - fixed) * line.conjugate()).real
            v[:] = to_vertex(to_complex(v) - (1 - factor) * along * line)
        return self

    def reflect(self, v0: Sequence[float], v1: Sequence[float]) -> EdgeSequence:
        """Mirrors everything across the line through two points."""
        fixed = to_complex(v0)
        line = to_complex(v1) - fixed
        turn = (line / abs(line)) ** 2
        for v in self.verts():
            v[:] = to_vertex(fixed + (to_complex(v) - fixed).conjugate() * turn)
        for e in self.edges:
            e.reflect_features()
        return self

    def propagate_label(self, label: str) -> None:
        """Gives all edges a label."""
        for e in self.edges:
            e.label = label

    # new sequences

    def copy(self) -> EdgeSequence:
        """Copies of the edges over copies of the vertices, which are shared where they were."""
        verts: dict[int, Vertex] = {}
        copies: dict[int, Edge] = {}
        for e in self.edges:
            if id(e) not in copies:
                start = verts.setdefault(id(e.start), list(e.start))
                end = verts.setdefault(id(e.end), list(e.end))
                copies[id(e)] = e.copy_between(start, end)
        new = EdgeSequence()
        new.edges = [copies[id(e)] for e in self.edges]
        return new

    def chained_order(self) -> EdgeSequence:
        """A copy with edges reversed where that makes a chain."""
        chained = self.copy()
        for i, edge in enumerate(chained.edges):
            follows = i > 0 and edge.end is chained[i - 1].end
            after = chained[i + 1] if i + 1 < len(chained) else None
            leads = after is not None and (edge.start is after.start or edge.start is after.end)
            if follows or leads:
                edge.reverse()
        return chained


def _box(points: Sequence[Sequence[float]]) -> tuple[float, float, float, float]:
    xs, ys = [p[0] for p in points], [p[1] for p in points]
    return min(xs), max(xs), min(ys), max(ys)
