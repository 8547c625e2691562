"""A stitched garment: one mesh, its panels, its seams and its flat pattern."""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from swifttailor.errors import GeometryError
from swifttailor.pattern import Pattern

if TYPE_CHECKING:
    from swifttailor.body import Body

Floats = NDArray[np.float64]
Ints = NDArray[np.int32]


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

    @cached_property
    def representative(self) -> Ints:
        """(v,) one flat vertex of each welded vertex (the first)."""
        first = np.full(self.vertex_count, len(self.weld), dtype=np.int32)
        np.minimum.at(first, self.weld, np.arange(len(self.weld), dtype=np.int32))
        return first


@dataclass(frozen=True, eq=False)
class Garment:
    """A garment in space: welded vertices over a `PatternMesh`. Frame: docs/conventions.md."""

    mesh: PatternMesh
    vertices: Floats
    """(v, 3) welded vertex positions, cm."""
    report: dict[str, Any] = field(default_factory=dict)
    """What made it and how well: JSON values, written as report.json."""

    def __post_init__(self) -> None:
        vertices = np.array(self.vertices, dtype=np.float64)
        if vertices.shape != (self.mesh.vertex_count, 3):
            raise GeometryError(
                f"A garment over this pattern has vertices of shape ({self.mesh.vertex_count}, 3), "
                f"got {vertices.shape}."
            )
        if not np.isfinite(vertices).all():
            raise GeometryError("Garment vertices must be finite numbers.")
        vertices.flags.writeable = False
        object.__setattr__(self, "vertices", vertices)

    @classmethod
    def load(cls, folder: Path | str) -> Garment:
        """Reads back what `save` has written.

        Raises:
            InputError: The folder's files are missing, unreadable, or do not belong together.
        """
        from swifttailor.garment_files.folder_reader import load_folder

        return load_folder(folder)

    @property
    def pattern(self) -> Pattern:
        """The pattern it was sewn from."""
        return self.mesh.pattern

    @property
    def faces(self) -> Ints:
        """(f, 3) vertex indices; the right side of the cloth is outward."""
        return self.mesh.faces

    @property
    def seams(self) -> tuple[Seam, ...]:
        """One polyline of vertices per stitch."""
        return self.mesh.seams

    @cached_property
    def flat_positions(self) -> Floats:
        """(m, 3) position of every flat vertex, cm: the mesh cut open along its seams, as UVs need it."""
        return self.vertices[self.mesh.weld]

    @cached_property
    def uv(self) -> Floats:
        """(m, 2) texture coordinates of the flat vertices.

        All panels are laid out side by side at one scale in the unit square, row 0 at the bottom;
        `uv_scale` gives the cm per unit.
        """
        from swifttailor.garment_files.uv_layout import lay_out_uv

        return lay_out_uv(self.mesh)[0]

    @cached_property
    def uv_scale(self) -> float:
        """Centimetres of cloth per unit of `uv`."""
        from swifttailor.garment_files.uv_layout import lay_out_uv

        return lay_out_uv(self.mesh)[1]

    @cached_property
    def vertex_normals(self) -> Floats:
        """(v, 3) unit normals, area-weighted over the faces around each welded vertex."""
        corners = self.vertices[self.faces]
        face_normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        normals = np.zeros_like(self.vertices)
        for k in range(3):
            np.add.at(normals, self.faces[:, k], face_normals)
        norm = np.linalg.norm(normals, axis=1, keepdims=True)
        return np.divide(normals, norm, out=np.tile([0.0, 1.0, 0.0], (len(normals), 1)), where=norm > 1e-12)

    def save(self, folder: Path | str, *, body: Body | None = None, preview: bool = True) -> Path:
        """Writes pattern.json, pattern.svg, garment.glb, garment.obj, report.json and preview.png.

        Args:
            folder: Created when missing; files of these names in it are replaced, others left alone.
            body: Drawn in the preview; the default body when None.
            preview: Whether to render preview.png.

        Returns:
            The folder.
        """
        from swifttailor.garment_files.folder import save_folder

        return save_folder(self, folder, body=body, preview=preview)
