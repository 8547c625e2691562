"""The body: a closed mesh with labelled parts and its measurements."""

from __future__ import annotations

import functools
from collections.abc import Collection, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

from swifttailor.arrays import Array
from swifttailor.body.distance_field import DistanceField
from swifttailor.body.measurements import BodyMeasurements
from swifttailor.body.parts import BodyPart
from swifttailor.errors import InputError
from swifttailor.pattern.drafted_for import DraftedFor

DEFAULT_FILE = Path(__file__).with_name("default_body.npz")


@dataclass(frozen=True, eq=False, repr=False)
class Body:
    """A body standing on the floor, on the Y axis, facing +Z; centimetres.

    The arrays are copied on construction and read-only afterwards.
    """

    name: str
    """Short name for reports."""
    vertices: Array
    """(N, 3) float64 positions, cm."""
    faces: Array
    """(M, 3) int32 vertex indices, anticlockwise seen from outside."""
    vertex_part: Array
    """(N,) uint8 `BodyPart` of each vertex."""
    measurements: BodyMeasurements
    """GarmentCode's measurements of this body."""
    made_for: DraftedFor | None = None
    """The figure and measures that it was made to; None for the default body, and where it was not."""
    _made: dict[Any, Any] = field(default_factory=dict, init=False)

    def __post_init__(self) -> None:
        for name, kind, shape in (
            ("vertices", np.float64, (None, 3)),
            ("faces", np.int32, (None, 3)),
            ("vertex_part", np.uint8, (None,)),
        ):
            array = np.array(getattr(self, name), dtype=kind, order="C")
            if array.ndim != len(shape) or len(array) == 0 or array.shape[1:] != shape[1:]:
                raise InputError(f"A body's {name} must have the shape {shape}, received {array.shape}.")
            array.setflags(write=False)
            object.__setattr__(self, name, array)
        if not np.isfinite(self.vertices).all():
            raise InputError("A body's vertices must be finite; at least one is NaN or infinite.")
        if self.faces.min() < 0 or self.faces.max() >= len(self.vertices):
            raise InputError(
                f"A body's faces refer to vertices {self.faces.min()} to {self.faces.max()}, "
                f"but it has {len(self.vertices)} vertices."
            )
        if len(self.vertex_part) != len(self.vertices):
            raise InputError(
                f"A body needs one part label per vertex: {len(self.vertices)} vertices, "
                f"{len(self.vertex_part)} labels."
            )
        if self.vertex_part.max() > max(BodyPart):
            raise InputError(
                f"A body's part labels run from 0 to {int(max(BodyPart))}, received {self.vertex_part.max()}."
            )

    def __repr__(self) -> str:
        size = f"{len(self.vertices)} vertices, {len(self.faces)} faces"
        return f"Body({self.name!r}, {size}, {np.ptp(self.vertices[:, 1]):.1f} cm tall)"

    @staticmethod
    def default() -> Body:
        """The body that comes with the package, about the measurements of GarmentCode's mean body."""
        return _default_body()

    @staticmethod
    def load(path: Path | str, measurements_path: Path | str | None = None) -> Body:
        """Reads a user's own body.

        The mesh must stand upright along Y and face +Z, arms away from the sides. Metres, centimetres and
        millimetres are told apart by the height; the body is set on the floor and centred on the Y axis.
        Parts are labelled by the nearest vertices of the default body scaled to the same height, so the
        pose should be like its A-pose.

        Args:
            path: OBJ, PLY, GLB or STL file.
            measurements_path: GarmentCode body YAML, or JSON. What it leaves out, and everything without
                it, is measured on the mesh.

        Raises:
            InputError: A file cannot be read or is not such a body; the text says what to change.
        """
        from swifttailor.body.mesh_files import read_body

        read = read_body(path, measurements_path, _default_body())
        return Body(read.name, read.vertices, read.faces, read.vertex_part, read.measurements)

    @staticmethod
    def from_mesh(
        vertices: Array, faces: Array, *, name: str = "body", measurements: Mapping[str, float] | None = None
    ) -> Body:
        """Makes a body from arrays, as `load` does from a file.

        Args:
            vertices: (N, 3) in metres, centimetres or millimetres, standing upright along Y, facing +Z.
            faces: (M, 3) vertex indices.
            name: For reports.
            measurements: GarmentCode's, in cm, as far as they are known; the others are measured on the mesh.

        Raises:
            InputError: It is no such body; the text says what to change.
        """
        from swifttailor.body.mesh_files import fit_body

        points, triangles = np.asarray(vertices, float), np.asarray(faces, np.int64)
        shapes_fit = points.ndim == triangles.ndim == 2 and points.shape[1:] == triangles.shape[1:] == (3,)
        if not shapes_fit or not len(triangles) or not np.isfinite(points).all():
            raise InputError(
                f"A body is made from vertices (N, 3) and faces (M, 3), all of them finite; received "
                f"{points.shape} and {triangles.shape}."
            )
        if triangles.min() < 0 or triangles.max() >= len(points):
            raise InputError(
                f"A body's faces refer to vertices {triangles.min()} to {triangles.max()}, "
                f"but it has {len(points)} vertices."
            )
        read = fit_body(points, triangles, measurements or {}, _default_body(), name=name, source=name)
        return Body(read.name, read.vertices, read.faces, read.vertex_part, read.measurements)

    @functools.cached_property
    def extent(self) -> Array:
        """(2, 3) least and most of the vertices, cm."""
        rows = np.ascontiguousarray(self.vertices.T)  # several times faster than along the columns
        return np.stack([rows.min(axis=1), rows.max(axis=1)])

    @functools.cached_property
    def coarse(self) -> tuple[Array, Array]:
        """Vertices (n, 3) and faces (m, 3) for pictures whose pixels show a centimetre, see `coarse_body`."""
        from swifttailor.body.coarse_body import coarse_body

        return coarse_body(self.vertices, self.faces, _default_body().faces)

    def distance_field(
        self,
        spacing: float = 1.0,
        margin: float = 8.0,
        without: Collection[BodyPart] = frozenset(),
        *,
        covering: bool = False,
    ) -> DistanceField:
        """Signed distances to the body on a lattice, kept in memory and in the cache folder.

        Args:
            spacing: Distance between nodes, cm.
            margin: How far the lattice reaches beyond the surface, cm.
            without: Parts to cut off, the cut being closed flat: skirts and trousers leave out the arms.
            covering: Whether values are lowered until the whole surface samples as inside, thin parts
                included (see `cover_surface`); for collision.
        """
        from swifttailor.body.distance_field import cached_field
        from swifttailor.body.parts import surface_without

        parts = tuple(sorted({BodyPart(part) for part in without}))
        key = ("field", float(spacing), float(margin), parts, covering)
        if key not in self._made:
            vertices, faces = surface_without(self.vertices, self.faces, self.vertex_part, parts)
            if not len(faces):
                raise InputError("distance_field(without=...) leaves nothing of the body; keep some parts.")
            used = np.unique(faces)
            self._made[key] = cached_field(
                vertices[used], np.searchsorted(used, faces), spacing, margin, covering=covering
            )
        return self._made[key]

    def signed_distance(self, points: Array) -> tuple[Array, Array]:
        """Exact signed distance from points to the body.

        Args:
            points: (P, 3) positions, cm.

        Returns:
            Distances (P,) float64 in cm, negative inside, and the nearest face (P,) int64.
        """
        from swifttailor.body.surface_distance import SurfaceTree

        if "tree" not in self._made:
            self._made["tree"] = SurfaceTree.build(self.vertices, self.faces)
        return self._made["tree"].signed_distance(points)


@functools.cache
def _default_body() -> Body:
    """Reads the shipped body once."""
    with np.load(DEFAULT_FILE, allow_pickle=False) as stored:
        names = [str(name) for name in stored["measurement_names"]]
        values = [float(value) for value in stored["measurement_values"]]
        return Body(
            name="default",
            vertices=stored["vertices"],
            faces=stored["faces"],
            vertex_part=stored["vertex_part"],
            measurements=BodyMeasurements.from_mapping(dict(zip(names, values, strict=True))),
        )
