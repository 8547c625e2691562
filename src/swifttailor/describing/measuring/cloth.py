"""The sewn cloth as a graph: how far it is from one point of a garment to another, along the cloth.

Every edge is sampled, stitched samples are one node, and any two nodes of a panel that see each other
within it are joined by the straight way between them. Shortest paths over that graph are the ways a tape
measure lies, whatever the panels' shapes and wherever they have been placed.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property, lru_cache
from types import MappingProxyType

import numpy as np
import shapely
from numpy.typing import NDArray
from scipy.sparse import coo_array, csr_array
from scipy.sparse.csgraph import connected_components, dijkstra

from swifttailor.arrays import Floats, Longs, read_only
from swifttailor.errors import GeometryError
from swifttailor.pattern import EdgeRef, Pattern, Stitch
from swifttailor.pattern.check.stitch_checks import single_stitches, usable_stitches

SPACING_CM = 3.0
"""Distance between samples; a tape laid between them is at most a few millimetres too long."""
MAX_SAMPLES = 70
"""Samples per panel, about: the graph grows with their square."""
_MOST_TESTS, _AT_ONCE = 500_000_000, 2_000_000
"""Lines against sides, for all panels of a pattern and in one piece of memory."""
_ON_BORDER_CM = 0.05


@dataclass(frozen=True, eq=False)
class FreeLoop:
    """A closed border of the garment: edges without a partner that hang together."""

    edges: tuple[EdgeRef, ...]
    length: float
    """cm."""
    center: Floats
    """(3,) mean of its placed samples, cm."""


@dataclass(frozen=True, eq=False)
class Cloth:
    """A pattern's samples, nodes and the ways between them; nothing of it can be changed."""

    pattern: Pattern
    stitches: tuple[Stitch, ...]
    """Those that can be sewn: both edges exist, neither is in another stitch."""
    samples: Mapping[EdgeRef, Longs]
    """Samples along every edge, both ends included."""
    world: Floats
    """(n, 3) placed samples, cm."""
    node: Longs
    """(n,) node of every sample."""
    ways: csr_array
    """(nodes, nodes) lengths of the straight ways, cm."""
    lengths: Mapping[EdgeRef, float]
    """Arc length of every edge, cm."""

    @classmethod
    def of(cls, pattern: Pattern) -> Cloth:
        """Samples and sews a pattern."""
        stitches = tuple(pattern.stitches[k] for k in single_stitches(pattern, usable_stitches(pattern)))
        edges = [EdgeRef(p.name, k) for p in pattern.panels for k in range(len(p.edges))]
        lengths = {ref: pattern.edge_length(ref) for ref in edges}
        counts = _counts(pattern, stitches, lengths)
        samples: dict[EdgeRef, Longs] = {}
        local, world, spans = [], [], []
        first = 0
        for panel in pattern.panels:
            pieces = []
            start = first
            for k in range(len(panel.edges)):
                ref = EdgeRef(panel.name, k)
                pieces.append(panel.sample_edge(k, counts[ref] + 1)[:-1])
                samples[ref] = np.arange(first, first + counts[ref] + 1)
                first += counts[ref]
            samples[EdgeRef(panel.name, len(panel.edges) - 1)][-1] = start
            local.append(np.concatenate(pieces))
            world.append(panel.to_world(local[-1]))
            spans.append((start, first))
        node = _sew(samples, stitches, first)
        ways = _ways(local, spans, node)
        for array in (*samples.values(), ways.data, ways.indices, ways.indptr):
            read_only(array)
        return cls(
            pattern,
            stitches,
            MappingProxyType(samples),
            read_only(np.concatenate(world)),
            read_only(node),
            ways,
            MappingProxyType(lengths),
        )

    @cached_property
    def partner(self) -> Mapping[EdgeRef, EdgeRef]:
        """What every stitched edge is sewn to."""
        return MappingProxyType({a: b for s in self.stitches for a, b in (s.sides, s.sides[::-1])})

    @cached_property
    def loops(self) -> tuple[FreeLoop, ...]:
        """The borders, longest first."""
        free = [ref for ref in self.samples if ref not in self.partner]
        ends = np.array([self.node[self.samples[ref][[0, -1]]] for ref in free]).reshape(-1, 2)
        count = int(self.node.max()) + 1
        graph = coo_array((np.ones(len(ends)), (ends[:, 0], ends[:, 1])), shape=(count, count))
        labels = connected_components(graph, directed=False)[1]
        groups: dict[int, list[EdgeRef]] = {}
        for ref, (start, _) in zip(free, ends, strict=True):
            groups.setdefault(int(labels[start]), []).append(ref)
        loops = []
        for refs in groups.values():
            length = sum(self.lengths[ref] for ref in refs)
            loops.append(FreeLoop(tuple(refs), length, read_only(self.placed(refs).mean(axis=0))))
        return tuple(sorted(loops, key=lambda loop: (-loop.length, loop.edges)))

    def nodes(self, refs: Sequence[EdgeRef]) -> Longs:
        """Nodes on some edges, each once."""
        return np.unique(np.concatenate([self.node[self.samples[ref]] for ref in refs]))

    def placed(self, refs: Sequence[EdgeRef]) -> Floats:
        """Placed samples (k, 3) of some edges, cm."""
        return np.concatenate([self.world[self.samples[ref]] for ref in refs])

    def distances(self, sources: Longs, offsets: Floats | float = 0.0) -> Floats:
        """Shortest ways (nodes,) in cm along the cloth; infinite where no way leads.

        Args:
            sources: Nodes to start from.
            offsets: What has already been travelled at each source, cm; not negative.
        """
        count = self.ways.shape[0]
        lengths = np.broadcast_to(np.asarray(offsets, np.float64), sources.shape)
        lengths = np.maximum(lengths, 0.0) + 1.0  # a stored zero would be no way at all
        known = self.ways.tocoo()
        rows = np.concatenate([known.row, np.full(len(sources), count)])
        columns = np.concatenate([known.col, sources])
        graph = coo_array(
            (np.concatenate([known.data, lengths]), (rows, columns)), shape=(count + 1, count + 1)
        )
        return dijkstra(graph.tocsr(), directed=False, indices=count)[:count] - 1.0


def _counts(
    pattern: Pattern, stitches: Sequence[Stitch], lengths: dict[EdgeRef, float]
) -> dict[EdgeRef, int]:
    """Intervals per edge; the same for both edges of a stitch."""
    counts = {}
    for panel in pattern.panels:
        own = [EdgeRef(panel.name, k) for k in range(len(panel.edges))]
        spacing = max(SPACING_CM, sum(lengths[ref] for ref in own) / MAX_SAMPLES)
        counts.update({ref: max(1, math.ceil(lengths[ref] / spacing)) for ref in own})
    for s in stitches:
        counts[s.first] = counts[s.second] = max(counts[s.first], counts[s.second])
    return counts


def _sew(samples: dict[EdgeRef, Longs], stitches: Sequence[Stitch], count: int) -> Longs:
    """Node (count,) of every sample: stitched samples share one."""
    pairs = [np.zeros((0, 2), np.int64)]
    for s in stitches:
        second = samples[s.second]
        pairs.append(np.stack([samples[s.first], second if s.right_wrong else second[::-1]], axis=1))
    joined = np.concatenate(pairs)
    graph = coo_array((np.ones(len(joined)), (joined[:, 0], joined[:, 1])), shape=(count, count))
    return connected_components(graph, directed=False)[1].astype(np.int64)


def _ways(local: list[Floats], spans: list[tuple[int, int]], node: Longs) -> csr_array:
    """The straight ways within panels; of several between two nodes the shortest.

    Raises:
        GeometryError: There are so many corners that it would take minutes.
    """
    if sum(len(points) ** 3 // 2 for points in local) > _MOST_TESTS:
        raise GeometryError(
            f"A panel has {max(map(len, local))} corners and points of curves, which is too jagged to be "
            "measured: some hundreds are accepted. Smooth its outline."
        )
    starts, ends, lengths = [], [], []
    for points, (first, _) in zip(local, spans, strict=True):
        i, j = _remembered_ways(points.tobytes())
        starts.append(node[first + i])
        ends.append(node[first + j])
        lengths.append(np.hypot(*(points[i] - points[j]).T))
    a, b, length = np.concatenate(starts), np.concatenate(ends), np.concatenate(lengths)
    keep = a != b
    a, b, length = np.minimum(a, b)[keep], np.maximum(a, b)[keep], np.maximum(length[keep], 1e-9)
    count = int(node.max()) + 1
    key = a * count + b
    order = np.lexsort((length, key))
    key, first = np.unique(key[order], return_index=True)
    shape = (count, count)
    return coo_array((length[order][first], (key // count, key % count)), shape=shape).tocsr()


@lru_cache(maxsize=256)
def _remembered_ways(points: bytes) -> tuple[Longs, Longs]:
    """`mutually_visible`; most panels stay as they are while a pattern is altered."""
    i, j = mutually_visible(np.frombuffer(points, np.float64).reshape(-1, 2))
    return read_only(i), read_only(j)


def mutually_visible(points: Floats) -> tuple[Longs, Longs]:
    """Pairs (i, j), i < j, of a closed polygon's corners (n, 2) joined by a straight line inside it.

    Neighbours always count as visible. Lines along the border count as inside, also where they pass the
    mouth of a dart that opens into it.
    """
    n = len(points)
    i, j = np.triu_indices(n, 1)
    hollow = _hollow_sides(points)
    if not len(hollow):  # convex
        return i, j
    neighbours = (j - i == 1) | ((i == 0) & (j == n - 1))
    a, b = points[i], points[j]
    sides = points[hollow], np.roll(points, -1, axis=0)[hollow]
    rows = max(1, _AT_ONCE // len(hollow))
    parts = [_crosses(*sides, a[k : k + rows], b[k : k + rows]) for k in range(0, len(a), rows)]
    inside = ~np.concatenate(parts)
    polygon = shapely.make_valid(shapely.Polygon(points))
    shapely.prepare(polygon)
    for t in (0.5, 0.27, 0.79):  # more than one, since a line outside may pass close to the border
        between = a[inside] * (1 - t) + b[inside] * t
        within = shapely.contains_xy(polygon, between)
        doubtful = shapely.points(between[~within])
        within[~within] = shapely.distance(polygon.boundary, doubtful) < _ON_BORDER_CM
        inside[inside] = within
    visible = inside | neighbours
    return i[visible], j[visible]


def _hollow_sides(points: Floats) -> Longs:
    """Sides of a polygon (n, 2) that are not on its convex hull: only these can be crossed from within."""
    along = np.roll(points, -1, axis=0) - points
    to_others = points[None] - points[:, None]
    height = along[:, None, 0] * to_others[..., 1] - along[:, None, 1] * to_others[..., 0]
    small = 1e-9 * (1.0 + float(np.abs(points - points[0]).max()) ** 2)
    return np.flatnonzero((height.min(axis=1) < -small) & (height.max(axis=1) > small))


def _crosses(start: Floats, end: Floats, a: Floats, b: Floats) -> NDArray[np.bool_]:
    """(m,) whether the lines a to b (m, 2) properly cross one of the sides start to end (n, 2)."""
    along = end - start
    x, y = (b - a).T
    from_a_x = start[None, :, 0] - a[:, :1]
    from_a_y = start[None, :, 1] - a[:, 1:]
    side_of_start = x[:, None] * from_a_y - y[:, None] * from_a_x
    side_of_end = side_of_start + x[:, None] * along[None, :, 1] - y[:, None] * along[None, :, 0]
    side_of_a = along[None, :, 1] * from_a_x - along[None, :, 0] * from_a_y
    side_of_b = side_of_a + along[None, :, 0] * y[:, None] - along[None, :, 1] * x[:, None]
    # In cm^2; corners that lie on the line by rounding do not count.
    small = 1e-9 * (1.0 + float(np.abs(start - start[0]).max()) ** 2)
    return (
        (side_of_start * side_of_end < 0)
        & (side_of_a * side_of_b < 0)
        & (np.minimum(np.abs(side_of_start), np.abs(side_of_end)) > small)
        & (np.minimum(np.abs(side_of_a), np.abs(side_of_b)) > small)
    ).any(axis=1)
