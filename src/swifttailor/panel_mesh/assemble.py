"""From a pattern to one mesh: panels triangulated, stitched vertices welded."""

from __future__ import annotations

from itertools import accumulate, pairwise

import numpy as np
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components

from swifttailor.arrays import Floats, Ints, Longs
from swifttailor.errors import GeometryError, InputError, PatternError
from swifttailor.panel_mesh.edge_sampling import edge_segments, measured_edges, stitched_pairs
from swifttailor.panel_mesh.pattern_mesh import PatternMesh, Seam
from swifttailor.panel_mesh.triangulate import signed_area, triangulate_polygons
from swifttailor.pattern import EdgeRef, Pattern

MAX_VERTICES = 400_000
MAX_AREA_M2 = 60.0
"""More cloth than a gown with a train; a garment of more is in other units, or damaged."""
_MAX_ROUNDS = 8


def mesh_pattern(pattern: Pattern, edge_length: float = 2.0) -> PatternMesh:
    """Triangulates every panel and closes every stitch.

    The result is an edge-manifold surface: inner edges that would coincide with another edge once the
    seams are closed, or whose ends a seam joins, get a vertex in their middle. No boundary edge is lost.

    Args:
        pattern: Its order is kept; `Pattern.canonical` makes the result independent of file order.
        edge_length: Target edge length, cm.

    Raises:
        InputError: `edge_length` is not positive or would need more than `MAX_VERTICES` vertices.
        PatternError: There are no panels, or more than `MAX_AREA_M2` of cloth, or a stitch is impossible
            (dangling, used twice, closing an edge onto a point).
        GeometryError: A panel crosses itself or has no area.
    """
    if not (np.isfinite(edge_length) and 0.05 <= edge_length <= 50):
        raise InputError(f"The edge length must lie between 0.05 and 50 cm, got {edge_length!r}.")
    if not pattern.panels:
        raise PatternError("The pattern has no panels, so there is nothing to mesh. Give one with panels.")
    edges = measured_edges(pattern)
    segments = edge_segments(pattern, edge_length, edges)
    for _ in range(_MAX_ROUNDS):
        _refuse_too_many(sum(segments.values()), f"outlines of {edges.lengths.sum():.0f} cm", edge_length)
        runs = _edge_runs(pattern, segments)
        pairs, labels = _weld_boundary(pattern, runs)
        collapsed = _collapsed_edges(pattern, runs, labels)
        if not collapsed:
            break
        _refine(pattern, segments, collapsed)
    else:
        names = ", ".join(f"'{r.panel}' edge {r.edge}" for r in collapsed[:3])
        raise PatternError(
            f"The stitches close these edges onto a single point: {names}. "
            "Check the direction of their stitches with: swifttailor check PATTERN"
        )
    points = edges.sample(list(segments.values()))
    starts = np.array([r[0][0] for r in runs] + [len(points)])
    boundaries = [points[a:b] for a, b in pairwise(starts.tolist())]
    area = sum(abs(signed_area(b)) for b in boundaries)
    if area > MAX_AREA_M2 * 1e4:
        raise PatternError(
            f"The panels are {area / 1e4:.0f} m2 of cloth; at most {MAX_AREA_M2:.0f} are accepted. Are their "
            "measures in cm? Scale the pattern, or remove the panel that is too large."
        )
    _refuse_too_many(area / (edge_length**2 * 0.866), f"{area:.0f} cm2 of cloth", edge_length)
    mesh = _fill(pattern, boundaries, edge_length, runs, pairs, labels)
    return _separate_coincident_edges(mesh)


def _refuse_too_many(expected: float, what: str, edge_length: float) -> None:
    if expected > MAX_VERTICES:
        raise InputError(
            f"{what} at an edge length of {edge_length:g} cm need about {expected:.0f} vertices; "
            f"at most {MAX_VERTICES} are accepted. Choose a longer edge length."
        )


def _edge_runs(pattern: Pattern, segments: dict[EdgeRef, int]) -> list[list[Longs]]:
    """Per panel and edge, the outline points it runs through, the outlines numbered one after the other."""
    runs, start = [], 0
    for panel in pattern.panels:
        counts = [segments[EdgeRef(panel.name, k)] for k in range(len(panel.edges))]
        around = np.append(np.arange(start, start + sum(counts)), start)
        cuts = [0, *accumulate(counts)]
        runs.append([around[a : b + 1] for a, b in pairwise(cuts)])
        start += sum(counts)
    return runs


def _weld_boundary(pattern: Pattern, runs: list[list[Longs]]) -> tuple[list[Longs], Longs]:
    """Pairs (n, 2) of outline points that each stitch joins, and a label of what each point becomes."""
    pairs = []
    for stitch in pattern.stitches:
        first, second = (runs[pattern.panel_index(r.panel)][r.edge] for r in stitch.sides)
        pairs.append(stitched_pairs(first, second, stitch.right_wrong))
    joined = np.concatenate(pairs) if pairs else np.zeros((0, 2), np.int64)
    count = int(runs[-1][-1][-2]) + 1
    graph = coo_array((np.ones(len(joined), np.int8), (joined[:, 0], joined[:, 1])), shape=(count, count))
    return pairs, connected_components(graph, directed=False)[1].astype(np.int64)


def _fill(
    pattern: Pattern,
    boundaries: list[Floats],
    edge_length: float,
    runs: list[list[Longs]],
    pairs: list[Longs],
    labels: Longs,
) -> PatternMesh:
    """Triangulates the outlines and numbers outline points as vertices of the result."""
    flat, faces, starts = triangulate_polygons(boundaries, edge_length, [p.name for p in pattern.panels])
    panel = np.repeat(np.arange(len(boundaries), dtype=np.int32), np.diff(starts))
    filled = np.bincount(panel[faces[:, 0]], minlength=len(boundaries)) > 0
    if not filled.all():
        name = pattern.panels[int(np.argmin(filled))].name
        raise GeometryError(f"Panel '{name}' has no area to mesh. Run: swifttailor check PATTERN")
    sizes = np.array([len(b) for b in boundaries])
    vertex = np.arange(len(labels)) + np.repeat(starts[:-1] - np.cumsum(sizes) + sizes, sizes)
    all_labels = len(labels) + np.arange(len(flat))
    all_labels[vertex] = labels
    weld = _numbered_by_first_use(all_labels)
    return PatternMesh(
        pattern,
        flat,
        panel,
        faces,
        weld,
        tuple(Seam(k, weld[vertex[p[:, 0]]]) for k, p in enumerate(pairs)),
        tuple(tuple(vertex[run].astype(np.int32) for run in panel) for panel in runs),
    )


def _numbered_by_first_use(labels: Ints) -> Ints:
    """Renames labels to 0, 1, 2, ... in the order in which they first occur."""
    _, first, inverse = np.unique(labels, return_index=True, return_inverse=True)
    rank = np.argsort(np.argsort(first, kind="stable"), kind="stable")
    return rank[inverse].astype(np.int32)


def _in_panel_order(mesh: PatternMesh) -> PatternMesh:
    """Moves vertices that splitting has put at the end back to their panels."""
    order = np.argsort(mesh.flat_panel, kind="stable")
    if (order[1:] > order[:-1]).all():
        return mesh
    position = np.argsort(order).astype(np.int32)
    faces = position[mesh.flat_faces]
    weld = _numbered_by_first_use(mesh.weld[order])
    renamed = np.zeros(mesh.vertex_count, dtype=np.int32)
    renamed[mesh.weld[order]] = weld
    return PatternMesh(
        mesh.pattern,
        mesh.flat_vertices[order],
        mesh.flat_panel[order],
        np.ascontiguousarray(faces[np.argsort(mesh.face_panel, kind="stable")]),
        weld,
        tuple(Seam(s.stitch, renamed[s.vertices]) for s in mesh.seams),
        tuple(tuple(position[e] for e in edges) for edges in mesh.edge_vertices),
    )


def _collapsed_edges(pattern: Pattern, runs: list[list[Longs]], labels: Longs) -> list[EdgeRef]:
    """Edges with a segment whose two ends a seam has welded together."""
    return [
        EdgeRef(panel.name, k)
        for panel, own in zip(pattern.panels, runs, strict=True)
        for k, run in enumerate(own)
        if (labels[run[1:]] == labels[run[:-1]]).any()
    ]


def _refine(pattern: Pattern, segments: dict[EdgeRef, int], edges: list[EdgeRef]) -> None:
    """Adds segments to the given edges and to what they are stitched to."""
    partner = {}
    for s in pattern.stitches:
        partner[s.first], partner[s.second] = s.second, s.first
    for ref in set(edges) | {partner[r] for r in edges if r in partner}:
        count = segments[ref] + 1
        for r in (ref, partner.get(ref, ref)):
            segments[r] = max(segments[r], count)


def _separate_coincident_edges(mesh: PatternMesh) -> PatternMesh:
    """Splits inner edges that welding has folded onto another edge or onto a point."""
    for _ in range(_MAX_ROUNDS):
        doubled = _coincident_inner_edges(mesh)
        if not len(doubled):
            return _in_panel_order(mesh)
        mesh = _split_edges(mesh, doubled)
    raise GeometryError(
        "The stitched panels do not form a surface: the same seam line is used by more than two of them. "
        "Run: swifttailor check PATTERN"
    )


def _coincident_inner_edges(mesh: PatternMesh) -> Longs:
    """Flat vertex pairs (n, 2), ascending, of inner edges that are not unique after welding."""
    shared = np.bincount(mesh.weld, minlength=mesh.vertex_count)[mesh.weld] > 1
    faces = mesh.flat_faces.astype(np.int64)
    start, end = faces.ravel(), faces[:, [1, 2, 0]].ravel()
    # Only edges at a vertex that a seam has joined with another can have become like another edge.
    near = shared[start] | shared[end]
    start, end = start[near], end[near]
    count = len(mesh.weld)
    keys, uses = np.unique(np.minimum(start, end) * count + np.maximum(start, end), return_counts=True)
    flat = np.stack([keys // count, keys % count], axis=1)
    low, high = np.sort(mesh.weld[flat].astype(np.int64), axis=1).T
    _, inverse = np.unique(low * count + high, return_inverse=True)
    total = np.bincount(inverse, weights=uses)[inverse]
    return flat[(uses == 2) & ((total > 2) | (low == high))]


def _split_edges(mesh: PatternMesh, edges: Longs) -> PatternMesh:
    """Puts a vertex in the middle of each given inner edge; faces around it become two."""
    vertices, panels, weld = list(mesh.flat_vertices), list(mesh.flat_panel), list(mesh.weld)
    faces = [tuple(int(v) for v in f) for f in mesh.flat_faces]
    next_weld = mesh.vertex_count
    around: dict[int, set[int]] = {int(v): set() for v in edges.ravel()}
    for v, k in zip(
        mesh.flat_faces.ravel().tolist(), np.repeat(np.arange(len(faces)), 3).tolist(), strict=True
    ):
        if v in around:
            around[v].add(k)
    for a, b in edges.tolist():
        touching = sorted(around[a] & around[b])
        if len(touching) != 2:  # an earlier split in this round has already changed the edge
            continue
        middle = len(vertices)
        vertices.append((mesh.flat_vertices[a] + mesh.flat_vertices[b]) / 2)
        panels.append(int(mesh.flat_panel[a]))
        weld.append(next_weld)
        next_weld += 1
        for k in touching:
            face, new = faces[k], len(faces)
            faces[k] = tuple(middle if v == b else v for v in face)
            faces.append(tuple(middle if v == a else v for v in face))
            around[b].discard(k)
            for v in face:
                if v != a and v in around:
                    around[v].add(new)
    return PatternMesh(
        mesh.pattern,
        np.array(vertices),
        np.array(panels, dtype=np.int32),
        np.array(faces, dtype=np.int32),
        np.array(weld, dtype=np.int32),
        mesh.seams,
        mesh.edge_vertices,
    )
