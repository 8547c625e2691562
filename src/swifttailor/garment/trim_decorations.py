"""Frills, fringe and bows of a garment as small meshes that follow its sewn edges."""

from __future__ import annotations

import itertools
from collections.abc import Iterator
from typing import TYPE_CHECKING

import numpy as np

from swifttailor.arrays import Array, Floats, Ints
from swifttailor.garment.trim_pieces import TrimMesh, ball, front_of
from swifttailor.pattern.trims.knit_bands import KNIT_BANDS
from swifttailor.pattern.trims.shapes import Bow, Frill

if TYPE_CHECKING:
    from swifttailor.garment.garment import Garment

_STEP = 0.45
"""Distance of the columns of a frill, cm."""
_EVENED_CM = 3.0
"""So far on both sides of a place a frill stands off as it does there, cm."""
_ROWS = 5
_WAVE, _SWING = 0.75, 0.22
"""Length of a frill's waves and how far they swing at its border, as parts of its depth."""
_LIFT = 0.25
"""A frill lies so far above the cloth where it is sewn on, cm."""
_FLAT_LIFT = 0.2
"""So much higher do flat strips lie, which bend less than the cloth, cm."""
_RIB_COLUMNS = 2
"""So many columns are between two furrows of a ribbed band."""
_NEAREST = 6
"""By so many vertices of the cloth the level of a flat strip on it is told."""
_HANGS = 0.7
"""How much of a strip's direction is down, of one that hangs."""
_STANDS_OUT = 0.6
"""How much of that of a frill around the neck is away from the body."""
_STRIPES = "stripes"
_LACES = ("lace trim", "neck lace")
_SCALLOPS, _SCALLOP_WIDTH = "scalloped edge", 5.0
"""A border of arcs alone, and how wide they are, cm."""
_ARC, _SCALLOP, _LACE_ROWS = 2.6, 0.3, 9
"""Of lace: width of the arcs of its border, how deep they are as a part of it, and its rows of meshes."""
_THREADS_APART, _THREAD = 0.5, 0.17
"""Of fringe: distance of its threads and half their width, cm."""
_FROM_LEVEL, _LEAST_POINTS, _DROOPS = 0.3, 4, 0.45
"""From which part of the height of an armhole on a frill lies over the shoulder, along so many points, and
how much of its way is down."""
_SHORT_THREADS, _FINE = 4.0, 0.6
"""Threads shorter than this, cm, are of the cloth itself: so much finer."""
_LOOP_HEIGHT, _LOOP_DEPTH, _RIBBON, _WIDER = 0.17, 1.0, 2.4, 0.19
"""Of a bow: height of a loop as a part of its width, its depth and the least width of its ends, cm, and the
latter as a part of the bow's width."""


def frill_meshes(garment: Garment, frill: Frill) -> list[TrimMesh]:
    """A strip along each run of its edges.

    Args:
        garment: What it is on.
        frill: Where it is sewn on.
    """
    found = []
    for line, away, normals in _runs(garment, frill):
        if frill.trim in _LACES:
            vertices, faces, lines = _lace(line + _FLAT_LIFT * normals, -away, normals, frill.depth)
            found.append(TrimMesh(frill.trim, "cloth", vertices, faces, lines))
            continue
        if frill.trim == _SCALLOPS:
            vertices, faces, lines = _lace(
                line, away, normals, frill.depth, arc=_SCALLOP_WIDTH, is_pierced=False
            )
            found.append(TrimMesh(frill.trim, "cloth", vertices, faces, lines))
            continue
        if frill.kind == "flat":
            vertices, faces, lines = _strip(
                line + _FLAT_LIFT * normals, -away, normals, frill.depth, swing=0.0
            )
            vertices = _laid_on(garment, {ref.panel for ref in frill.edges}, vertices)
            if frill.trim == KNIT_BANDS:
                lines = np.concatenate([lines, _ribs_across(len(line))])
            if frill.trim.endswith(_STRIPES):
                vertices, faces = _brought_down(vertices, faces, normals)
            found.append(TrimMesh(frill.trim, "cloth", vertices, faces, lines))
            continue
        if frill.trim == "shoulder frills":
            found += [
                TrimMesh(frill.trim, "cloth", *_strip(line[own], ways, normals[own], frill.depth))
                for own, ways in _over_shoulder(line, away, normals)
            ]
            continue
        around_neck = frill.trim == "neck frill"
        lean = _STANDS_OUT * normals if around_neck else np.array([0.0, -_HANGS, 0.0])
        ways = away + (lean if around_neck or "hem" in frill.trim else 0.0)
        ways /= np.maximum(np.linalg.norm(ways, axis=1, keepdims=True), 1e-9)
        make = _threads if frill.kind == "threads" else _strip
        vertices, faces, lines = make(line, ways, normals, frill.depth)
        found.append(TrimMesh(frill.trim, "cloth", vertices, faces, lines))
    return found


def _brought_down(vertices: Floats, faces: Ints, normals: Floats) -> tuple[Floats, Ints]:
    """A flat strip with its long borders brought down to the cloth: seen edge on, it would stand off it.

    Args:
        vertices: (m n, 3) of its rows of n columns.
        faces: Of the strip.
        normals: (n, 3) of the cloth at each column.
    """
    count, low = len(normals), (_FLAT_LIFT + _LIFT) * normals
    rows = vertices[:count], vertices[-count:]
    tops = np.arange(count), np.arange(len(vertices) - count, len(vertices))
    found = [faces]
    for k, top in enumerate(tops):
        below = len(vertices) + k * count + np.arange(count)
        quads = np.stack([top[:-1], top[1:], below[1:], below[:-1]], axis=-1)
        found += [quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]]
    return np.concatenate([vertices, *[row - low for row in rows]]), np.concatenate(found).astype(np.int32)


def _ribs_across(count: int) -> Ints:
    """(k, 2) lines across a strip of so many columns, as vertex indices: the furrows between its ribs."""
    columns = np.arange(_RIB_COLUMNS, count - 1, _RIB_COLUMNS)
    rows = columns + count * np.arange(_ROWS)[:, None]
    return np.stack([rows[:-1], rows[1:]], axis=-1).reshape(-1, 2).astype(np.int32)


def _over_shoulder(line: Floats, away: Floats, normals: Floats) -> list[tuple[Ints, Floats]]:
    """Which points of an armhole (n, 3) a frill over the shoulder runs along, and its ways (k, 3)."""
    height = line[:, 1]
    if np.allclose(line[0], line[-1]):  # begin a ring below
        turned = (np.arange(len(line) - 1) + int(height[:-1].argmin())) % (len(line) - 1)
    else:
        turned = np.arange(len(line))
    level = height.min() + _FROM_LEVEL * np.ptp(height)
    own = turned[height[turned] > level]
    ways = away[own] + _STANDS_OUT * normals[own] + (0.0, -_DROOPS, 0.0)
    ways /= np.maximum(np.linalg.norm(ways, axis=1, keepdims=True), 1e-9)
    return [(own.astype(np.int32), ways)] if len(own) > _LEAST_POINTS else []


def bow_meshes(garment: Garment, bow: Bow, at: Array, normal: Array) -> list[TrimMesh]:
    """Two loops, a knot and two ends.

    Args:
        garment: What it is on.
        bow: Its size.
        at: (3,) where on the cloth its knot is, cm.
        normal: (3,) of the cloth there.
    """
    middle = at + 1.1 * normal
    outward = -1.0 if normal[2] < 0.0 else 1.0
    found = []
    for side in (-1.0, 1.0):
        loop = middle + np.array([side * 0.27 * bow.width, 0.25, 0.0])
        radii = 0.25 * bow.width, _LOOP_HEIGHT * bow.width, _LOOP_DEPTH
        vertices, faces = ball(loop, radii)
        taper = 0.35 + 0.65 * np.clip(np.abs(vertices[:, 0] - middle[0]) / (0.45 * bow.width), 0.0, 1.0)
        vertices[:, 1] = loop[1] + taper * (vertices[:, 1] - loop[1])
        found.append(TrimMesh(bow.trim, "cloth", vertices, faces, _outline_of(vertices, loop)))
        found.append(_end(garment, bow, middle, side, outward))
    knot, faces = ball(
        middle + np.array([0.0, 0.0, 0.4 * outward]), (0.09 * bow.width, 0.10 * bow.width, 0.9)
    )
    return [*found, TrimMesh(bow.trim, "cloth", knot, faces, np.zeros((0, 2), np.int32))]


def _end(garment: Garment, bow: Bow, knot: Array, side: float, outward: float) -> TrimMesh:
    """A ribbon that hangs from the knot, before the cloth; behind it where that is outward: -1."""
    drops = np.linspace(0.0, bow.tail, 9)
    middle = knot[0] + side * (0.8 + 0.14 * drops)
    half = 0.5 * max(_RIBBON, _WIDER * bow.width) * (0.45 + 0.55 * np.clip(drops / 5.0, 0.0, 1.0))
    x = np.stack([middle - half, middle + half], axis=1)
    y = np.broadcast_to((knot[1] - drops)[:, None], x.shape)
    cloth = [
        outward * front_of(garment, at, knot[1] - drop, outward)
        for at, drop in zip(middle, drops, strict=True)
    ]
    depth = np.maximum(np.nan_to_num(cloth, nan=-np.inf), outward * knot[2] - 0.1 * drops) + 0.5
    z = np.broadcast_to(outward * np.maximum.accumulate(depth)[:, None], x.shape)
    vertices = np.stack([x, y, z], axis=-1).reshape(-1, 3)
    k = 2 * np.arange(len(drops) - 1)
    faces = np.concatenate([np.stack([k, k + 2, k + 3], axis=1), np.stack([k, k + 3, k + 1], axis=1)])
    edges = np.concatenate([np.stack([k, k + 2], axis=1), np.stack([k + 1, k + 3], axis=1)])
    lines = np.concatenate([edges, [[len(vertices) - 2, len(vertices) - 1]]])
    return TrimMesh(bow.trim, "cloth", vertices, faces.astype(np.int32), lines.astype(np.int32))


def _outline_of(vertices: Floats, middle: Array) -> Ints:
    """(k, 2) of a loop: its ring as it is seen from the front."""
    from scipy.spatial import ConvexHull

    ring = ConvexHull((vertices - middle)[:, :2]).vertices.astype(np.int32)
    return np.stack([ring, np.roll(ring, -1)], axis=1)


def _runs(garment: Garment, frill: Frill) -> Iterator[tuple[Floats, Floats, Floats]]:
    """Along each run of its edges, evenly spaced: points, ways away from the cloth, normals; (n, 3) each."""
    mesh = garment.mesh
    after: dict[int, set[int]] = {}
    for ref in frill.edges:
        flat = mesh.edge_vertices[mesh.pattern.panel_index(ref.panel)][ref.edge]
        welded = mesh.weld[flat].tolist()
        for a, b in itertools.pairwise(welded):
            if a != b:
                after.setdefault(a, set()).add(b)
                after.setdefault(b, set()).add(a)
    inside = _inward(garment, {ref.panel for ref in frill.edges})
    for run in _chains(after):
        points = garment.vertices[run]
        away = -inside[run]
        along = np.gradient(points, axis=0)
        along /= np.maximum(np.linalg.norm(along, axis=1, keepdims=True), 1e-9)
        away -= (away * along).sum(axis=1, keepdims=True) * along
        away /= np.maximum(np.linalg.norm(away, axis=1, keepdims=True), 1e-9)
        at = _travelled(points)
        if at[-1] < 2 * _STEP:
            continue
        even = np.linspace(0.0, at[-1], max(int(at[-1] / _STEP), 3) + 1)
        rows = [
            np.stack([np.interp(even, at, each[:, k]) for k in range(3)], axis=1)
            for each in (points, away, garment.vertex_normals[run])
        ]
        ways, normals = (_evened(row) for row in rows[1:]) if frill.kind == "gathered" else rows[1:]
        yield rows[0], ways, normals


def _laid_on(garment: Garment, panels: set[str], vertices: Floats) -> Floats:
    """(n, 3) those of a flat strip, moved onto the cloth of some panels: it would stand off a shoulder."""
    from scipy.spatial import KDTree

    numbers = [garment.mesh.pattern.panel_index(panel) for panel in panels]
    own = np.unique(garment.faces[np.isin(garment.mesh.face_panel, numbers)])
    cloth, normals = garment.vertices[own], garment.vertex_normals[own]
    far, near = KDTree(cloth).query(vertices, k=min(_NEAREST, len(own)))
    weights = 1.0 / np.maximum(far, 1e-3) ** 2
    weights /= weights.sum(axis=1, keepdims=True)
    ways = (weights[..., None] * normals[near]).sum(axis=1)
    ways /= np.maximum(np.linalg.norm(ways, axis=1, keepdims=True), 1e-9)
    off = (weights * ((vertices[:, None] - cloth[near]) * ways[:, None]).sum(axis=-1)).sum(axis=1)
    return vertices - (off - _FLAT_LIFT - _LIFT)[:, None] * ways


def _evened(ways: Floats) -> Floats:
    """Directions (n, 3) without what cloth that is sewn in folds turns them by from place to place."""
    beside = max(round(_EVENED_CM / _STEP), 1)
    closed = len(ways) > 2 * beside + 1 and bool(np.allclose(ways[0], ways[-1]))
    wrapped = [ways[-beside - 1 : -1], ways, ways[1 : beside + 1]] if closed else []
    ends = [np.repeat(ways[:1], beside, axis=0), ways, np.repeat(ways[-1:], beside, axis=0)]
    padded = np.concatenate(wrapped or ends)
    sums = np.cumsum(np.concatenate([np.zeros((1, 3)), padded]), axis=0)
    mean = sums[2 * beside + 1 :] - sums[: -2 * beside - 1]
    return mean / np.maximum(np.linalg.norm(mean, axis=1, keepdims=True), 1e-9)


def _travelled(line: Floats) -> Floats:
    """(n,) how far along a line (n, 3) each of its points is, cm."""
    return np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(line, axis=0), axis=1))])


def _inward(garment: Garment, panels: set[str]) -> Floats:
    """(v, 3) from every vertex to the middle of the faces around it that are of some panels."""
    numbers = [garment.mesh.pattern.panel_index(panel) for panel in panels]
    faces = garment.faces[np.isin(garment.mesh.face_panel, numbers)]
    centres = garment.vertices[faces].mean(axis=1)
    total, count = np.zeros_like(garment.vertices), np.zeros(len(garment.vertices))
    for corner in range(3):
        np.add.at(total, faces[:, corner], centres)
        np.add.at(count, faces[:, corner], 1.0)
    return total / np.maximum(count, 1.0)[:, None] - garment.vertices


def _chains(after: dict[int, set[int]]) -> Iterator[list[int]]:
    """Vertices of each connected run in order; of a closed one the first comes last again."""
    left = {vertex: set(others) for vertex, others in after.items()}
    for start in sorted(left, key=lambda vertex: (len(left[vertex]) != 1, vertex)):
        while left[start]:
            run = [start]
            while left[run[-1]]:
                here = run[-1]
                there = min(left[here])
                left[here].discard(there)
                left[there].discard(here)
                run.append(there)
            if len(run) > 2:
                yield run


def _strip(
    line: Floats, ways: Floats, normals: Floats, depth: float, swing: float = _SWING
) -> tuple[Floats, Ints, Ints]:
    """A gathered strip: waves that grow towards its border. Vertices, faces and lines that show."""
    at = _travelled(line)
    waves = max(round(float(at[-1]) / (_WAVE * depth)), 1)
    phase = 2 * np.pi * waves * at / at[-1]
    share = np.linspace(0.0, 1.0, _ROWS)[:, None, None]
    away = swing * depth * share * np.sin(phase)[:, None]
    rows = line + share * depth * ways + (_LIFT + away) * normals
    count = len(line)
    grid = np.arange(_ROWS * count).reshape(_ROWS, count)
    quads = np.stack([grid[:-1, :-1], grid[:-1, 1:], grid[1:, 1:], grid[1:, :-1]], axis=-1).reshape(-1, 4)
    faces = np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]]).astype(np.int32)
    lines = np.concatenate([np.stack([row[:-1], row[1:]], axis=1) for row in (grid[0], grid[-1])])
    return rows.reshape(-1, 3), faces, lines.astype(np.int32)


def _lace(
    line: Floats,
    ways: Floats,
    normals: Floats,
    depth: float,
    *,
    arc: float = _ARC,
    is_pierced: bool = True,
) -> tuple[Floats, Ints, Ints]:
    """A flat strip with a border of arcs, holes in rows, and lines around them; as `_strip` returns it."""
    at = _travelled(line)
    arcs = max(round(float(at[-1]) / arc), 1)
    share = np.linspace(0.0, 1.0, _LACE_ROWS)[:, None]
    reach = depth * (1.0 - _SCALLOP + _SCALLOP * np.abs(np.sin(np.pi * arcs * at / at[-1])))
    rows = line + (share * reach)[..., None] * ways + _LIFT * normals
    count = len(line)
    grid = np.arange(_LACE_ROWS * count).reshape(_LACE_ROWS, count)
    quads = np.stack([grid[:-1, :-1], grid[:-1, 1:], grid[1:, 1:], grid[1:, :-1]], axis=-1)
    row, column = np.indices(quads.shape[:2])
    holes = (row % 2 == 1) & ((column + row) % 4 == 0) & (row < _LACE_ROWS - 2) & is_pierced
    kept = quads[~holes]
    faces = np.concatenate([kept[:, [0, 1, 2]], kept[:, [0, 2, 3]]]).astype(np.int32)
    edges = [np.stack([one[:-1], one[1:]], axis=1) for one in (grid[0], grid[-1])]
    around = quads[holes]
    edges += [around[:, [k, (k + 1) % 4]] for k in range(4)]
    return rows.reshape(-1, 3), faces, np.concatenate(edges).astype(np.int32)


def _threads(line: Floats, ways: Floats, normals: Floats, depth: float) -> tuple[Floats, Ints, Ints]:
    """Threads that hang beside each other; vertices, faces, and no lines."""
    at = _travelled(line)
    fine = _FINE if depth < _SHORT_THREADS else 1.0
    apart, half = fine * _THREADS_APART, fine * _THREAD
    places = np.arange(0.5 * apart, at[-1], apart)
    index = np.clip(np.searchsorted(at, places) - 1, 0, len(line) - 2)
    along = line[index + 1] - line[index]
    along /= np.maximum(np.linalg.norm(along, axis=1, keepdims=True), 1e-9)
    root = line[index] + (places - at[index])[:, None] * along + _LIFT * normals[index]
    swing = 0.06 if fine == 1.0 else 0.25  # what frays is not cut even
    tip = root + depth * (1.0 - swing + swing * np.cos(7.0 * places))[:, None] * ways[index]
    corners = [root - half * along, root + half * along, tip + half * along, tip - half * along]
    vertices = np.stack(corners, axis=1).reshape(-1, 3)
    k = 4 * np.arange(len(places))
    faces = np.concatenate([np.stack([k, k + 1, k + 2], axis=1), np.stack([k, k + 2, k + 3], axis=1)])
    return vertices, faces.astype(np.int32), np.zeros((0, 2), np.int32)
