"""The panels of a pattern as flat triangle meshes, and the seams between them."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from swifttailor.arrays import Floats, Ints
from swifttailor.pattern import Pattern


@dataclass(frozen=True)
class Seam:
    """The 3D line in which a stitch joined two edges."""

    stitch: int
    """Index into `Pattern.stitches` of the garment's pattern."""
    vertices: Ints
    """(n,) vertices of the garment along the seam, in the travel order of the stitch's first edge."""


@dataclass(frozen=True, eq=False)
class PatternMesh:
    """The panels of a pattern as flat triangle meshes whose seam edges are sampled in matching pairs.

    It is fixed by the pattern and the edge length alone. Flat vertices belong to one panel each; welded
    vertices are what remains after every stitch has been closed.
    """

    pattern: Pattern
    flat_vertices: Floats
    """(m, 2) panel-local cm; the panels follow each other in pattern order."""
    flat_panel: Ints
    """(m,) panel index of each flat vertex."""
    flat_faces: Ints
    """(f, 3) flat vertex indices, wound like the panel's loop: the right side of the cloth is outward."""
    weld: Ints
    """(m,) welded vertex of each flat vertex."""
    seams: tuple[Seam, ...]
    edge_vertices: tuple[tuple[Ints, ...], ...]
    """``edge_vertices[panel][edge]``: flat vertices along the edge, both corners included."""

    @cached_property
    def faces(self) -> Ints:
        """(f, 3) welded vertex indices of the faces."""
        return np.ascontiguousarray(self.weld[self.flat_faces])

    @cached_property
    def face_panel(self) -> Ints:
        """(f,) panel index of each face."""
        return np.ascontiguousarray(self.flat_panel[self.flat_faces[:, 0]])

    @cached_property
    def vertex_count(self) -> int:
        """Number of welded vertices."""
        return int(self.weld.max()) + 1 if len(self.weld) else 0

    def welded_mean(self, values: Floats) -> Floats:
        """(v, k): of the values (m, k) of the flat vertices that each welded vertex is made of."""
        count = np.bincount(self.weld, minlength=self.vertex_count)
        sums = [np.bincount(self.weld, column, self.vertex_count) for column in values.T]
        return np.stack(sums, axis=1) / count[:, None]

    @cached_property
    def representative(self) -> Ints:
        """(v,) one flat vertex of each welded vertex (the first)."""
        first = np.full(self.vertex_count, len(self.weld), dtype=np.int32)
        np.minimum.at(first, self.weld, np.arange(len(self.weld), dtype=np.int32))
        return first
