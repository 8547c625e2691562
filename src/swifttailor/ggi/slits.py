"""Cuts the grid of pixels open where two sewn edges of a panel come so near that pixels would join them.

Between the two sides of a dart, or of a slit for a godet, there may be less than a pixel. The squares of
Alg. 5 then reach across, and a pixel may belong to both sides. What the sides of the stitching image say
about the cloth undoes that: it lies on the left of a side that runs anticlockwise around its panel.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components

from swifttailor.arrays import Bools, Longs
from swifttailor.ggi.remesh import PixelGrid
from swifttailor.ggi.stitching import StitchingImage

_MOST = 0.5
_CRUMB = 0.05
"""Pieces that hang on to their panel by single pixels only, and have less than this share of the vertices of
its largest piece, are left out: tips that are narrower than a pixel further in."""


@dataclass(frozen=True, eq=False)
class SeamSides:
    """All sides of the stitching image as one row of entries, with the cloth on a known hand."""

    pixel: Longs
    """(n,) number of the pixel of each entry."""
    start: Longs
    """(2 s + 1,) where each side begins, as in `StitchingImage`."""
    link: Longs
    """(l,) entries that the next entry of the same side touches."""
    cloth_on_left: Bools
    """(2 s,) on which hand the cloth lies for who walks along each side."""

    @property
    def links(self) -> Longs:
        """(l, 2) pixels of each link, in the direction that has the cloth on its left."""
        pairs = np.stack([self.pixel[self.link], self.pixel[self.link + 1]], axis=1)
        turned = ~self.cloth_on_left[self.side[self.link]]
        return np.where(turned[:, None], pairs[:, ::-1], pairs)

    @property
    def side(self) -> Longs:
        """(n,) side of each entry."""
        return np.repeat(np.arange(len(self.start) - 1), np.diff(self.start))


def seam_sides(grid: PixelGrid, stitching: StitchingImage) -> SeamSides:
    """Tells on which hand of each side the cloth lies.

    The first side of a stitch runs anticlockwise around its panel. The second runs clockwise in plain
    stitches; it is taken to run anticlockwise, as in ``right_wrong`` ones, where most of it has pixels on its
    left and none on its right. In a narrow dart there are pixels on both hands.
    """
    start = stitching.start.astype(np.int64)
    pixel = grid.numbers.ravel()[stitching.pixels]
    count = len(start) - 1
    side = np.repeat(np.arange(count), np.diff(start))
    if not len(pixel):
        return SeamSides(pixel, start, np.zeros(0, np.int64), np.arange(count) % 2 == 0)
    x, y = grid.steps(pixel[:-1], pixel[1:])
    touching = (np.maximum(np.abs(x), np.abs(y)) == 1) & (side[1:] == side[:-1])
    link = np.flatnonzero(touching)
    x, y = x[link], y[link]
    # The square on the left of a straight link, and the corner on the left of a diagonal one.
    vote = _occupied(grid, pixel[link], _turned(x, y, 1)).astype(np.int64)
    vote -= _occupied(grid, pixel[link], _turned(x, y, -1))
    on_left = np.bincount(side[link], vote, count) > _MOST * np.bincount(side[link], minlength=count)
    on_left[::2] = True
    return SeamSides(pixel, start, link, on_left)


def _turned(x: Longs, y: Longs, hand: int) -> tuple[Longs, Longs]:
    """The step by which to reach the pixel beside a link: a quarter turn, an eighth for diagonal ones."""
    straight = (x == 0) | (y == 0)
    across = np.where(straight, -hand * y, np.clip(x - hand * y, -1, 1))
    return across, np.where(straight, hand * x, np.clip(y + hand * x, -1, 1))


def _occupied(grid: PixelGrid, pixel: Longs, step: tuple[Longs, Longs]) -> Bools:
    column = grid.pixels[pixel] % grid.resolution + step[0]
    row = grid.pixels[pixel] // grid.resolution + step[1]
    within = (column >= 0) & (column < grid.resolution) & (row >= 0) & (row < grid.resolution)
    number = grid.numbers[np.where(within, row, 0), np.where(within, column, 0)]
    return within & (number >= 0) & (grid.panel[number] == grid.panel[pixel])


@dataclass(frozen=True, eq=False)
class OpenGrid:
    """Triangles whose corners are parted where the cloth is."""

    faces: Longs
    """(f, 3) vertices, anticlockwise."""
    vertex_pixel: Longs
    """(v,) number of the pixel of each vertex. A pixel that has cloth on several sides has several."""
    rim_count: int
    """The first so many vertices are at the rim of their panel or sewn; the others are inside."""
    entry_vertices: Longs
    """(n, 2) for every entry of the seam sides its vertex at the face beside the link to the next entry, and
    at the one beside the link from the entry before; -1 where there is no face on the cloth's hand."""
    open_edges: Longs
    """(b, 2) vertices of the edges that have one face only."""
    sewn: Bools
    """(b,) which of them a stitch is to close."""


def open_grid(grid: PixelGrid, faces: Longs, sides: SeamSides) -> OpenGrid:
    """Removes what bridges slits, parts the two sides of each, and leaves out what hangs by a single pixel.

    Args:
        grid: The pixels.
        faces: (f, 3) of `remesh`, which must have been given the links as diagonals.
        sides: Of the stitching image.
    """
    links = _step_key(grid, *sides.links.T)
    is_link = np.zeros(9 * len(grid.pixels), np.bool_)
    is_link[links] = True
    inner, rim, rim_pixel = _without_bridges(grid, faces, is_link, sides.pixel)
    ahead, back = _half_edges(grid, rim)
    half_edge = np.full(9 * len(grid.pixels), -1, np.int32)
    half_edge[ahead] = np.arange(len(ahead))
    cut = is_link[ahead] & is_link[back]

    # Vertices: the fans of faces around the pixels at the rim, then one for each pixel inside.
    fan, fan_pixel = _fans(rim.ravel(), rim_pixel, half_edge[back], cut)
    whole = np.flatnonzero(~rim_pixel)
    of_pixel = np.full(len(grid.pixels), -1, np.int64)
    of_pixel[whole] = len(fan_pixel) + np.arange(len(whole))
    corners = np.where(fan >= 0, fan, of_pixel[rim.ravel()]).reshape(-1, 3)
    inner, vertex_pixel = of_pixel[inner], np.concatenate([fan_pixel, whole])
    large = _of_large_pieces(grid, corners, vertex_pixel, len(fan_pixel), ~rim_pixel)

    twinless = (half_edge[back] < 0) | cut
    # Between two pixels inside there is a face on the other side too, if not one at the rim.
    twinless &= rim_pixel[rim.ravel()] & rim_pixel[rim[:, [1, 2, 0]].ravel()]
    single = np.flatnonzero(twinless & np.repeat(large[corners[:, 0]], 3))
    return OpenGrid(
        np.concatenate([inner[large[inner[:, 0]]], corners[large[corners[:, 0]]]]),
        vertex_pixel,
        len(fan_pixel),
        _entry_vertices(sides, half_edge[links], corners, large),
        np.stack([corners.ravel()[single], corners[:, [1, 2, 0]].ravel()[single]], axis=1),
        is_link[ahead[single]],
    )


def _without_bridges(
    grid: PixelGrid, faces: Longs, is_link: Bools, sewn_pixels: Longs
) -> tuple[Longs, Longs, Bools]:
    """Removes faces on the other hand of a link than the cloth.

    Returns:
        Faces (f, 3) all of whose pixels are inside, the other faces, and which pixels (n,) are at the rim:
        beside another panel or none, sewn, or at a face that was removed.
    """
    rim_pixel = _at_the_rim(grid)
    rim_pixel[sewn_pixels] = True
    near = np.flatnonzero(_any_corner(rim_pixel, faces))
    ahead, back = _half_edges(grid, faces[near])
    bridging = near[(is_link[back] & ~is_link[ahead]).reshape(-1, 3).any(axis=1)]
    rim_pixel[faces[bridging].ravel()] = True
    at_rim = _any_corner(rim_pixel, faces)
    inner = faces[~at_rim]
    at_rim[bridging] = False
    return inner, faces[at_rim], rim_pixel


def _entry_vertices(sides: SeamSides, at: NDArray[np.int32], corners: Longs, large: Bools) -> Longs:
    """`OpenGrid.entry_vertices`, from the half-edge (l,) at which each link is, or -1."""
    at = at.astype(np.int64)
    begin, finish = corners.ravel()[at], corners.ravel()[at - at % 3 + (at + 1) % 3]
    missing = (at < 0) | ~large[begin]
    begin, finish = np.where(missing, -1, begin), np.where(missing, -1, finish)
    along = sides.cloth_on_left[sides.side[sides.link]]
    vertices = np.full((len(sides.pixel), 2), -1, np.int64)
    vertices[sides.link, 0] = np.where(along, begin, finish)
    vertices[sides.link + 1, 1] = np.where(along, finish, begin)
    return vertices


def _any_corner(marked: Bools, faces: Longs) -> Bools:
    """(f,) whether a corner of each face is marked (n,)."""
    return marked[faces[:, 0]] | marked[faces[:, 1]] | marked[faces[:, 2]]


def _step_key(grid: PixelGrid, start: Longs, end: Longs) -> Longs:
    """A number for each step from a pixel to one of the eight around it."""
    x, y = grid.steps(start, end)
    return 9 * start + 3 * (y + 1) + x + 1


def _half_edges(grid: PixelGrid, faces: Longs) -> tuple[Longs, Longs]:
    """Keys (3 f,) of the half-edges of faces, the j-th beginning at corner j, and of their other halves."""
    start, end = faces.ravel(), faces[:, [1, 2, 0]].ravel()
    return _step_key(grid, start, end), _step_key(grid, end, start)


def _at_the_rim(grid: PixelGrid) -> Bools:
    """(n,) whether one of the eight pixels around is of another panel or of none."""
    size = grid.resolution
    panel = np.full((size + 2, size + 2), -1, np.int64)
    panel[1 + grid.pixels // size, 1 + grid.pixels % size] = grid.panel
    same = np.ones((size, size), np.bool_)
    middle = panel[1:-1, 1:-1]
    for row in range(3):
        for column in range(3):
            same &= panel[row : row + size, column : column + size] == middle
    return ~same.ravel()[grid.pixels]


def _fans(pixel: Longs, rim_pixel: Bools, twin: NDArray[np.int32], cut: Bools) -> tuple[Longs, Longs]:
    """Makes one vertex of the corners at a pixel that faces join without a gap.

    Args:
        pixel: (3 f,) pixel of each corner of the faces at the rim.
        rim_pixel: Which pixels (n,) may have several vertices.
        twin: (3 f,) the other half of each half-edge, or -1.
        cut: (3 f,) half-edges along which the faces on both sides are parted.

    Returns:
        Vertex (3 f,) of each corner, -1 where its pixel is none of the rim, and the pixel of each vertex.
    """
    joined = np.flatnonzero((twin >= 0) & ~cut & rim_pixel[pixel])
    other = twin[joined].astype(np.int64)
    other += np.where(other % 3 == 2, -2, 1)  # the other half ends where this one begins
    graph = coo_array((np.ones(len(joined), np.int8), (joined, other)), shape=(len(pixel), len(pixel)))
    fan = connected_components(graph, directed=False)[1]
    at_rim = np.flatnonzero(rim_pixel[pixel])
    _, first, number = np.unique(fan[at_rim], return_index=True, return_inverse=True)
    vertex = np.full(len(pixel), -1, np.int64)
    vertex[at_rim] = number
    return vertex, pixel[at_rim[first]]


def _of_large_pieces(
    grid: PixelGrid, corners: Longs, vertex_pixel: Longs, fan_count: int, inside: Bools
) -> Bools:
    """Which vertices (v,) belong to what hangs together with a good part of their panel.

    Args:
        grid: The pixels.
        corners: (f, 3) vertices of the faces at the rim.
        vertex_pixel: (v,) pixel of each vertex.
        fan_count: The first so many vertices are at the rim.
        inside: (n,) pixels all of whose neighbours are of their panel; each is a vertex.
    """
    # Pixels inside hang together wherever they touch, so that only the faces at the rim need to be walked.
    image = np.zeros(grid.resolution**2, np.bool_)
    image[grid.pixels[inside]] = True
    from scipy import ndimage  # takes a twentieth of a second to load

    blobs, blob_count = ndimage.label(image.reshape(grid.numbers.shape), np.ones((3, 3)))
    blob = blobs.ravel()[grid.pixels[vertex_pixel]].astype(np.int64) - 1
    node = np.where(np.arange(len(vertex_pixel)) < fan_count, np.arange(len(vertex_pixel)), fan_count + blob)
    at = node[corners]
    pairs = np.concatenate([at[:, [0, 1]], at[:, [1, 2]]])
    count = fan_count + blob_count
    graph = coo_array((np.ones(len(pairs), np.int8), (pairs[:, 0], pairs[:, 1])), shape=(count, count))
    part = connected_components(graph, directed=False)[1][node]
    size = np.bincount(part)[part]
    largest = np.zeros(int(grid.panel.max(initial=0)) + 1, np.int64)
    np.maximum.at(largest, grid.panel[vertex_pixel], size)
    return size >= _CRUMB * largest[grid.panel[vertex_pixel]]
