"""From a pattern to one mesh: panels triangulated, stitched vertices welded."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components

from swifttailor.errors import GeometryError, InputError, PatternError
from swifttailor.garment import PatternMesh, Seam
from swifttailor.panel_mesh.edge_sampling import edge_segments, stitched_pairs
from swifttailor.panel_mesh.triangulate import triangulate_polygon
from swifttailor.pattern import EdgeRef, Panel, Pattern

Floats = NDArray[np.float64]
Ints = NDArray[np.int32]

MAX_VERTICES = 400_000
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
        PatternError: A stitch is impossible (dangling, used twice, closing an edge onto a point).
        GeometryError: A panel crosses itself.
    """
    if not (np.isfinite(edge_length) and 0.05 <= edge_length <= 50):
        raise InputError(f"The edge length must lie between 0.05 and 50 cm, got {edge_length!r}.")
    area = sum(abs(p.signed_area()) for p in pattern.panels)
    expected = area / (edge_length**2 * 0.866)
    if expected > MAX_VERTICES:
        raise InputError(
            f"{area:.0f} cm2 of cloth at an edge length of {edge_length:g} cm needs about "
            f"{expected:.0f} vertices; "
            f"at most {MAX_VERTICES} are accepted. Choose a longer edge length."
        )
    segments = edge_segments(pattern, edge_length)
    for _ in range(_MAX_ROUNDS):
        mesh = _build(pattern, segments, edge_length)
        collapsed = _collapsed_edges(mesh)
        if not collapsed:
            return _separate_coincident_edges(mesh)
        _refine(pattern, segments, collapsed)
    names = ", ".join(f"'{r.panel}' edge {r.edge}" for r in collapsed[:3])
    raise PatternError(
        f"The stitches close these edges onto a single point: {names}. "
        "Check the direction of their stitches with: swifttailor check PATTERN"
    )


def _build(pattern: Pattern, segments: dict[EdgeRef, int], edge_length: float) -> PatternMesh:
    vertices, panel_ids, faces, edges = [], [], [], []
    offset = 0
    for index, panel in enumerate(pattern.panels):
        boundary, panel_edges = _boundary(panel, segments)
        try:
            points, triangles = triangulate_polygon(boundary, edge_length)
        except GeometryError as error:
            raise GeometryError(f"Panel '{panel.name}': {error}") from error
        vertices.append(points)
        panel_ids.append(np.full(len(points), index, dtype=np.int32))
        faces.append(triangles + offset)
        edges.append(tuple((e + offset).astype(np.int32) for e in panel_edges))
        offset += len(points)
    flat = np.concatenate(vertices)
    weld, seams = _weld(pattern, edges, len(flat))
    return PatternMesh(
        pattern,
        flat,
        np.concatenate(panel_ids),
        np.ascontiguousarray(np.concatenate(faces), dtype=np.int32),
        weld,
        seams,
        tuple(edges),
    )


def _boundary(panel: Panel, segments: dict[EdgeRef, int]) -> tuple[Floats, list[Ints]]:
    """Sampled outline (n, 2) and, per edge, the outline points it runs through."""
    pieces, counts = [], []
    for k in range(len(panel.edges)):
        count = segments[EdgeRef(panel.name, k)]
        pieces.append(panel.sample_edge(k, count + 1)[:-1])
        counts.append(count)
    total = sum(counts)
    starts = np.concatenate([[0], np.cumsum(counts)])
    runs = [np.arange(starts[k], starts[k + 1] + 1, dtype=np.int32) % total for k in range(len(counts))]
    return np.concatenate(pieces), runs


def _weld(pattern: Pattern, edges: list[tuple[Ints, ...]], count: int) -> tuple[Ints, tuple[Seam, ...]]:
    pairs = []
    for stitch in pattern.stitches:
        first, second = (edges[pattern.panel_index(r.panel)][r.edge] for r in stitch.sides)
        pairs.append(stitched_pairs(first, second, stitch.right_wrong))
    joined = np.concatenate(pairs) if pairs else np.zeros((0, 2), dtype=np.int32)
    graph = coo_array((np.ones(len(joined)), (joined[:, 0], joined[:, 1])), shape=(count, count))
    _, labels = connected_components(graph, directed=False)
    weld = _numbered_by_first_use(labels)
    seams = tuple(Seam(k, weld[p[:, 0]]) for k, p in enumerate(pairs))
    return weld, seams


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


def _collapsed_edges(mesh: PatternMesh) -> list[EdgeRef]:
    """Edges with a segment whose two ends a seam has welded together."""
    found = []
    for panel, runs in zip(mesh.pattern.panels, mesh.edge_vertices, strict=True):
        for k, run in enumerate(runs):
            welded = mesh.weld[run]
            if (welded[1:] == welded[:-1]).any():
                found.append(EdgeRef(panel.name, k))
    return found


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


def _coincident_inner_edges(mesh: PatternMesh) -> NDArray[np.int64]:
    """Flat vertex pairs (n, 2), ascending, of inner edges that are not unique after welding."""
    faces = mesh.flat_faces
    halves = np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]]).astype(np.int64)
    flat, uses = np.unique(np.sort(halves, axis=1), axis=0, return_counts=True)
    flat = flat.astype(np.int64)
    welded = np.sort(mesh.weld[flat].astype(np.int64), axis=1)
    _, inverse = np.unique(welded, axis=0, return_inverse=True)
    total = np.bincount(inverse.ravel(), weights=uses)[inverse.ravel()]
    inner = uses == 2
    bad = inner & ((total > 2) | (welded[:, 0] == welded[:, 1]))
    return flat[bad]


def _split_edges(mesh: PatternMesh, edges: NDArray[np.int64]) -> PatternMesh:
    """Puts a vertex in the middle of each given inner edge; faces around it become two."""
    vertices, panels, weld = list(mesh.flat_vertices), list(mesh.flat_panel), list(mesh.weld)
    faces = [tuple(int(v) for v in f) for f in mesh.flat_faces]
    next_weld = mesh.vertex_count
    for a, b in edges:
        touching = [k for k, f in enumerate(faces) if a in f and b in f]
        if len(touching) != 2:  # an earlier split in this round has already changed the edge
            continue
        middle = len(vertices)
        vertices.append((mesh.flat_vertices[a] + mesh.flat_vertices[b]) / 2)
        panels.append(int(mesh.flat_panel[a]))
        weld.append(next_weld)
        next_weld += 1
        for k in touching:
            face = faces[k]
            faces[k] = tuple(middle if v == b else v for v in face)
            faces.append(tuple(middle if v == a else v for v in face))
    return PatternMesh(
        mesh.pattern,
        np.array(vertices),
        np.array(panels, dtype=np.int32),
        np.array(faces, dtype=np.int32),
        np.array(weld, dtype=np.int32),
        mesh.seams,
        mesh.edge_vertices,
    )
