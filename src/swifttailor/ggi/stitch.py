"""Sews the panels of a pixel grid together along the sides of the stitching image (paper, Alg. 6)."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components

from swifttailor.arrays import Floats, Longs
from swifttailor.ggi.remesh import PixelGrid
from swifttailor.ggi.slits import OpenGrid, SeamSides
from swifttailor.ggi.stitching import StitchingImage
from swifttailor.ggi.warping import warp

_BORROWED = 1e-9
"""Weight of a position that belongs to the other side of a slit: it counts where there is no other."""

_PINHOLE = 12
"""Holes of at most this many edges, all sewn, are closed; longer ones would be pulled out of shape."""


@dataclass(frozen=True, eq=False)
class SewnGrid:
    """One mesh of all panels, its vertices at the pixels of an image."""

    resolution: int
    """Pixels along each side of the image."""
    vertices: Floats
    """(v, 3) cm."""
    faces: Longs
    """(f, 3) vertices, right side outward."""
    face_panel: Longs
    """(f,) panel index of each face."""
    flat_pixels: Longs
    """(m,) pixel, row * resolution + column, of every flat vertex: the mesh cut open along its seams."""
    flat_faces: Longs
    """(f, 3) the same faces over the flat vertices."""
    weld: Longs
    """(m,) vertex of each flat vertex."""
    seams: tuple[Longs, ...]
    """For every stitch the vertices along its seam."""

    @property
    def uv(self) -> Floats:
        """(m, 2) texture coordinates of the flat vertices: where their pixels are in the image."""
        size = self.resolution
        return (np.stack([self.flat_pixels % size, self.flat_pixels // size], axis=1) + 0.5) / size


def sew(
    grid: PixelGrid, positions: Floats, mesh: OpenGrid, sides: SeamSides, stitching: StitchingImage
) -> SewnGrid:
    """Merges what the stitches bring together (Alg. 6).

    Both sides of each stitch are paired by dynamic time warping, pairs become sets, sets become one vertex in
    the middle of theirs, and faces that have lost a corner go.

    Args:
        grid: The pixels.
        positions: (n, 3) of each, cm.
        mesh: The panels, unsewn.
        sides: The sewn pixels of `mesh`.
        stitching: The same, as the image has them.
    """
    label, entry_label = _sets(grid, mesh, sides, stitching.fraction)
    corners = label[mesh.faces]
    a, b, c = corners.T
    sound = (a != b) & (b != c) & (c != a)
    kept = np.flatnonzero(sound)
    sound[kept[_folded(corners[kept], np.bincount(label))]] = False
    flat, flat_faces = _compacted(mesh.faces[sound], len(label))
    present = np.zeros(int(max(label.max(initial=-1), entry_label.max(initial=-1))) + 1, np.bool_)
    present[label[flat]] = True
    vertex_of = np.where(present, np.cumsum(present) - 1, -1)
    count = int(present.sum())

    # Every member of a set counts, those of faces that are gone included.
    place = vertex_of[label]
    kept = np.flatnonzero(place >= 0)
    weight = _ownership(grid, mesh, sides, stitching)[kept]
    share = weight / np.bincount(place[kept], weight, count)[place[kept]]
    seen = positions[mesh.vertex_pixel[kept]]
    vertices = np.zeros((count, 3))
    for axis in range(3):
        vertices[:, axis] = np.bincount(place[kept], share * seen[:, axis], count)
    return SewnGrid(
        resolution=grid.resolution,
        vertices=vertices,
        faces=vertex_of[corners[sound]],
        face_panel=grid.panel[mesh.vertex_pixel[flat[flat_faces[:, 0]]]],
        flat_pixels=grid.pixels[mesh.vertex_pixel[flat]],
        flat_faces=flat_faces,
        weld=place[flat],
        seams=_seams(vertex_of[entry_label], sides.start),
    )


def _sets(
    grid: PixelGrid, mesh: OpenGrid, sides: SeamSides, fraction: NDArray[np.floating]
) -> tuple[Longs, Longs]:
    """The set to which each vertex (v,) and each entry of the seam sides (n,) belongs."""
    count, entries = mesh.rim_count, len(sides.pixel)
    pairs = [count + warp(fraction.astype(np.float64), sides.start)]
    for column in mesh.entry_vertices.T:
        there = np.flatnonzero(column >= 0)
        pairs.append(np.stack([count + there, column[there]], axis=1))
    # Where a panel is thinner than a pixel there are no faces; what is sewn to its sides meets in its pixels.
    bare = np.ones(len(grid.pixels), np.bool_)
    bare[mesh.vertex_pixel[mesh.faces.ravel()]] = False
    on_bare = np.flatnonzero(bare[sides.pixel])
    order = on_bare[np.argsort(sides.pixel[on_bare], kind="stable")]
    same = sides.pixel[order[1:]] == sides.pixel[order[:-1]]
    pairs.append(count + np.stack([order[1:][same], order[:-1][same]], axis=1))

    joined = np.concatenate(pairs)
    graph = coo_array(
        (np.ones(len(joined), np.int8), (joined[:, 0], joined[:, 1])), shape=(count + entries,) * 2
    )
    label = _without_pinholes(mesh, connected_components(graph, directed=False)[1].astype(np.int64))
    # What is not at the rim of its panel is a set of its own.
    inner = len(mesh.vertex_pixel) - count
    return np.concatenate([label[:count], count + entries + np.arange(inner)]), label[count:]


def _folded(corners: Longs, members: Longs) -> Longs:
    """Faces that sewing has laid upon another with the same corners: two such faces enclose nothing.

    Args:
        corners: (f, 3) sets at the corners of each face.
        members: How many vertices each set has.
    """
    merged = members > 1
    near = np.flatnonzero(merged[corners[:, 0]] | merged[corners[:, 1]] | merged[corners[:, 2]])
    triple = np.sort(corners[near], axis=1)
    _, pair = np.unique(triple[:, 0] * len(members) + triple[:, 1], return_inverse=True)
    key = pair * len(members) + triple[:, 2]
    order = np.argsort(key, kind="stable")
    twin = np.flatnonzero(key[order[1:]] == key[order[:-1]])
    return near[order[np.concatenate([twin, twin + 1])]]


def _compacted(faces: Longs, count: int) -> tuple[Longs, Longs]:
    """The vertices that faces use, ascending, and the faces over them."""
    used = np.zeros(count, np.bool_)
    used[faces.ravel()] = True
    return np.flatnonzero(used), (np.cumsum(used) - 1)[faces]


def _without_pinholes(mesh: OpenGrid, label: Longs) -> Longs:
    """Draws together what sewing has left open although every edge around it is sewn.

    Such holes are left where several seams meet at a tip that is narrower than a pixel.
    """
    edges = label[mesh.open_edges]
    apart = edges[:, 0] != edges[:, 1]
    edges, sewn = np.sort(edges[apart], axis=1), mesh.sewn[apart]
    count = int(label.max(initial=-1)) + 1
    _, first, uses = np.unique(edges[:, 0] * count + edges[:, 1], return_index=True, return_counts=True)
    edges, sewn = edges[first[uses == 1]], sewn[first[uses == 1]]
    graph = coo_array((np.ones(len(edges), np.int8), (edges[:, 0], edges[:, 1])), shape=(count, count))
    loop = connected_components(graph, directed=False)[1]
    of_edge = loop[edges[:, 0]]
    size, unsewn = np.bincount(of_edge, minlength=count), np.bincount(of_edge, ~sewn, count)
    small = (unsewn == 0) & (size <= _PINHOLE)
    renamed = np.arange(count)
    inside = np.unique(edges[small[of_edge]])
    _, first, number = np.unique(loop[inside], return_index=True, return_inverse=True)
    renamed[inside] = inside[first][number]
    return renamed[label]


def _ownership(grid: PixelGrid, mesh: OpenGrid, sides: SeamSides, stitching: StitchingImage) -> Floats:
    """(v,) 1 for vertices that their pixel shows, next to nothing where it shows the slit's other side."""
    weight = np.ones(len(mesh.vertex_pixel))
    sharers = np.bincount(mesh.vertex_pixel, minlength=len(grid.pixels))
    split = sharers[mesh.vertex_pixel] > 1
    weight[split] = _BORROWED
    shown = stitching.ids.ravel()[grid.pixels[sides.pixel]].astype(np.int64) - 1
    own = shown == sides.side // 2
    for column in mesh.entry_vertices.T:
        weight[column[own & (column >= 0)]] = 1.0
    return weight


def _seams(vertex: Longs, start: Longs) -> tuple[Longs, ...]:
    """Vertices along the first side of each stitch, without repetition and without those that are gone."""
    seams = []
    for k in range(len(start) // 2):
        run = vertex[start[2 * k] : start[2 * k + 1]]
        run = run[run >= 0]
        seams.append(run[np.concatenate([[True], run[1:] != run[:-1]])[: len(run)]])
    return tuple(seams)
