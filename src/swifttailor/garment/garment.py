"""A stitched garment: one mesh, its panels, its seams and its flat pattern."""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from swifttailor.arrays import Floats, Ints
from swifttailor.errors import GeometryError
from swifttailor.panel_mesh.pattern_mesh import PatternMesh, Seam
from swifttailor.pattern import Pattern

if TYPE_CHECKING:
    from swifttailor.body import Body
    from swifttailor.garment.cloth_print import ClothPrint
    from swifttailor.garment.part_looks import PartLook


@dataclass(frozen=True, eq=False)
class Garment:
    """A garment in space: welded vertices over a `PatternMesh`. Frame: docs/conventions.md."""

    mesh: PatternMesh
    vertices: Floats
    """(v, 3) welded vertex positions, cm."""
    report: dict[str, Any] = field(default_factory=dict)
    """What made it and how well: JSON values, written as report.json."""
    color: str | None = None
    """Of the right side of the cloth, ``#rrggbb``; what its pattern has by itself (`cloth_color`) if None."""

    cloth: str | None = None
    """What it is of, a name of `draping.FABRICS` or satin, for how it shines; of cotton if None."""
    print: ClothPrint | None = None
    """Of the right side of the cloth; one colour if None."""
    looks: tuple[PartLook, ...] = ()
    """Of parts that look otherwise than the rest."""

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
        from swifttailor.garment.cloth_color import stated_color
        from swifttailor.garment.cloth_print import stated_print
        from swifttailor.garment.folder_reader import read_folder
        from swifttailor.garment.part_looks import stated_looks

        mesh, vertices, report = read_folder(folder)
        looks = stated_looks(report)
        return cls(mesh, vertices, report, stated_color(report), print=stated_print(report), looks=looks)

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
        from swifttailor.panel_mesh.uv_layout import lay_out_uv

        return lay_out_uv(self.mesh)[0]

    @cached_property
    def uv_scale(self) -> float:
        """Centimetres of cloth per unit of `uv`."""
        from swifttailor.panel_mesh.uv_layout import lay_out_uv

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

    def save(
        self,
        folder: Path | str,
        *,
        body: Body | None = None,
        preview: bool = True,
        overwrite: bool = False,
    ) -> Path:
        """Writes pattern.json, pattern.svg, garment.glb, garment.obj, report.json and preview.png.

        All of them or none. A garment that was saved there before is replaced, with its preview.

        Args:
            folder: Created when missing; other files in it are left alone.
            body: Drawn in the preview; the default body when None.
            preview: Whether to render preview.png.
            overwrite: Whether files of these names are replaced that SwiftTailor has not written, or that
                were changed since.

        Returns:
            The folder.

        Raises:
            InputError: The folder cannot be written, or there are such files and not `overwrite`.
        """
        from swifttailor.garment.folder import names_written, save_garment
        from swifttailor.output_folder import OutputFolder

        with OutputFolder(folder, overwrite=overwrite) as output:
            output.require_own(names_written(preview=preview))
            return save_garment(self, output, body=body, preview=preview)
