"""What every mesh file holds: triangles over shared vertices, with texture coordinates, groups and lines."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from swifttailor.arrays import Array
from swifttailor.errors import InputError
from swifttailor.garment.cloth_color import PALETTE, cloth_color
from swifttailor.garment.cloth_print import texture
from swifttailor.garment.seam_names import seam_name
from swifttailor.garment.trim_parts import TrimPart, trim_parts
from swifttailor.render.png import encode_png

if TYPE_CHECKING:
    from swifttailor.garment.garment import Garment


ROUGHNESS = {
    "cotton": 0.85,
    "linen": 0.9,
    "twill": 0.9,
    "denim": 0.95,
    "silk": 0.6,
    "satin": 0.35,
    "chiffon": 0.6,
    "wool": 0.95,
    "leather": 0.45,
    "polyester": 0.55,
    "jersey": 0.9,
    "rib-knit": 0.95,
    "sweatshirt": 0.95,
    "ponte": 0.9,
    "fleece": 1.0,
    "swimwear": 0.5,
}
"""Of cloths, as materials of files state it."""
_LARGEST = float(np.finfo(np.float32).max)
"""What lies beyond is infinite in the files that meshes are written to."""


@dataclass(frozen=True, eq=False)
class PrintedPicture:
    """A picture on the cloth, once over the square of texture coordinates or repeating."""

    png: bytes
    """The picture, a PNG file."""
    repeats: Array | None = None
    """(k, 2) where each texture vertex of the mesh lies on the cloth, in repeats of the picture; origin at
    its lower left corner. None: where its texture coordinates say."""


@dataclass(frozen=True)
class GroupLook:
    """How the faces of a group look, where that is otherwise than the rest of the cloth."""

    color: str
    """``#rrggbb``."""
    opacity: float = 1.0
    """Share of what lies beneath that they hide; of lace about the mean."""
    picture: bytes | None = None
    """A PNG file over the square of texture coordinates, with opacity where it is sheer; None: one colour."""


@dataclass(frozen=True, eq=False)
class TriangleMesh:
    """A mesh between a file and a garment; checked on construction.

    Texture coordinates have vertices of their own, because a stitched garment has one vertex where several
    panels meet and each panel has its own place in the texture.
    """

    vertices: Array
    """(n, 3) cm; shared by all groups."""
    faces: Array
    """(m, 3) vertex indices."""
    uv: Array | None = None
    """(k, 2) texture coordinates, origin at the lower left; None without any."""
    uv_faces: Array | None = None
    """(m, 3) indices into `uv`; None without any."""
    groups: tuple[str, ...] = ()
    """Names of the groups of faces: the panels."""
    face_group: Array | None = None
    """(m,) index into `groups`; None when there are no groups."""
    lines: tuple[Array, ...] = ()
    """Polylines of vertex indices: the seams."""
    color: str = PALETTE[0]
    """Of the cloth, ``#rrggbb``; for formats with materials."""
    roughness: float = ROUGHNESS["cotton"]
    """How matt the cloth is, 0 to 1."""
    line_names: tuple[str, ...] = ()
    """A name for each line, or none at all; names of seams: `seam_names`."""
    print: PrintedPicture | None = None
    """A picture on the cloth; for formats with textures. Needs `uv`."""
    wearer: tuple[Array, Array] | None = None
    """Vertices (n, 3) in cm and faces (m, 3) of the body that wears it; for formats with several objects."""
    trims: tuple[TrimPart, ...] = ()
    """What is put on the cloth; for formats with several objects."""
    looks: tuple[GroupLook | None, ...] = ()
    """One for each group, None where it looks as the rest; or none at all. For formats with materials."""

    def __post_init__(self) -> None:
        object.__setattr__(self, "vertices", _floats("vertices", self.vertices, 3))
        object.__setattr__(self, "faces", _indices("faces", self.faces, len(self.vertices)))
        if (self.uv is None) != (self.uv_faces is None):
            raise InputError("A mesh has uv and uv_faces, or neither.")
        if self.uv is not None:
            object.__setattr__(self, "uv", _floats("uv", self.uv, 2))
            object.__setattr__(self, "uv_faces", _indices("uv_faces", self.uv_faces, len(self.uv)))
            self._require_length("uv_faces")
        if (self.face_group is None) != (not self.groups):
            raise InputError("A mesh has groups and face_group, or neither.")
        if self.face_group is not None:
            group = np.array(self.face_group, np.int32)
            object.__setattr__(self, "face_group", group)
            self._require_length("face_group")
            if len(group) and (group.min() < 0 or group.max() >= len(self.groups)):
                raise InputError(
                    f"face_group refers to groups {group.min()} to {group.max()}, "
                    f"but there are {len(self.groups)}."
                )
        object.__setattr__(
            self, "lines", tuple(_indices("lines", line, len(self.vertices), 1) for line in self.lines)
        )
        if self.line_names and len(self.line_names) != len(self.lines):
            raise InputError(f"A mesh of {len(self.lines)} lines has {len(self.line_names)} names of lines.")
        if self.looks and len(self.looks) != len(self.groups):
            raise InputError(f"A mesh of {len(self.groups)} groups has {len(self.looks)} looks of groups.")
        repeats = None if self.print is None else self.print.repeats
        if self.print is not None and (
            self.uv is None or (repeats is not None and len(repeats) != len(self.uv))
        ):
            raise InputError("A print needs a place on it for every texture coordinate of the mesh.")

    def _require_length(self, name: str) -> None:
        if len(getattr(self, name)) != len(self.faces):
            raise InputError(
                f"{name} has {len(getattr(self, name))} rows, but there are {len(self.faces)} faces."
            )

    @cached_property
    def vertex_normals(self) -> Array:
        """(n, 3) unit normals, area-weighted; +Y where a vertex has no face of any area."""
        a, b, c = (self.vertices[self.faces[:, k]] for k in range(3))
        normals = np.zeros_like(self.vertices)
        across = np.cross(b - a, c - a)
        for k in range(3):
            np.add.at(normals, self.faces[:, k], across)
        norm = np.linalg.norm(normals, axis=1, keepdims=True)
        return np.divide(normals, norm, out=np.tile([0.0, 1.0, 0.0], (len(normals), 1)), where=norm > 1e-12)

    @cached_property
    def flat(self) -> FlatMesh:
        """The mesh cut open wherever texture coordinates or groups part, for formats with one index."""
        group = np.zeros(len(self.faces), np.int32) if self.face_group is None else self.face_group
        uv_index = np.zeros_like(self.faces) if self.uv_faces is None else self.uv_faces
        corners = np.stack([np.repeat(group, 3), uv_index.ravel(), self.faces.ravel()], axis=1)
        unique, inverse = np.unique(corners, axis=0, return_inverse=True)
        repeats = None if self.print is None else self.print.repeats
        return FlatMesh(
            weld=unique[:, 2].astype(np.int32),
            uv=None if self.uv is None else self.uv[unique[:, 1]],
            repeats=None if repeats is None else repeats[unique[:, 1]],
            faces=inverse.reshape(-1, 3).astype(np.int32),
            group=unique[:, 0].astype(np.int32),
        )


@dataclass(frozen=True, eq=False)
class FlatMesh:
    """A mesh in which each vertex has one place in the texture and belongs to one group."""

    weld: Array
    """(k,) vertex of the `TriangleMesh`; sorted by group, so that every group is one run."""
    uv: Array | None
    """(k, 2) texture coordinates or None."""
    faces: Array
    """(m, 3) indices from 0 to k - 1, faces in the order of the `TriangleMesh`."""
    group: Array
    """(k,) group of each vertex."""
    repeats: Array | None = None
    """(k, 2) places on the print or None."""


def mesh_of_garment(garment: Garment) -> TriangleMesh:
    """The garment as every writer takes it: welded vertices, a group per panel, a line per seam."""
    mesh = garment.mesh
    return TriangleMesh(
        garment.vertices,
        mesh.faces,
        garment.uv,
        mesh.flat_faces,
        tuple(p.name for p in garment.pattern.panels),
        mesh.face_panel if len(garment.pattern.panels) else None,
        tuple(seam.vertices for seam in garment.seams),
        garment.color or cloth_color(garment.pattern),
        ROUGHNESS.get(garment.cloth or "cotton", ROUGHNESS["cotton"]),
        tuple(seam_name(seam.stitch, garment.pattern.stitches[seam.stitch]) for seam in garment.seams),
        None if garment.print is None else PrintedPicture(encode_png(texture(garment))),
        trims=trim_parts(garment),
        looks=_looks(garment),
    )


def _looks(garment: Garment) -> tuple[GroupLook | None, ...]:
    """How each panel looks; nothing where all look alike."""
    if not garment.looks:
        return ()
    from swifttailor.garment.lace import lace_picture, mean_opacity
    from swifttailor.garment.part_looks import USUAL_LOOK, PanelLook, looks_of_panels

    own = garment.color or cloth_color(garment.pattern)
    looks = looks_of_panels(garment)
    shown: dict[PanelLook, GroupLook | None] = {USUAL_LOOK: None}
    for look in looks:
        if look in shown:
            continue
        color, opacity, picture = look.color or own, look.opacity, None
        if look.lace:
            picture = lace_picture(garment, color, opacity)
            opacity = mean_opacity(opacity) if look.is_sheer else 1.0
        shown[look] = GroupLook(color, opacity, picture)
    return tuple([shown[look] for look in looks])


def _floats(name: str, values: Any, columns: int) -> Array:
    array = np.array(values, np.float64)
    if array.ndim != 2 or array.shape[1] != columns:
        raise InputError(f"A mesh's {name} have the shape (n, {columns}), got {array.shape}.")
    if not (np.abs(array) <= _LARGEST).all():
        raise InputError(f"A mesh's {name} must be finite numbers; at least one is NaN or infinite.")
    array.flags.writeable = False
    return array


def _indices(name: str, values: Any, count: int, dimensions: int = 2) -> Array:
    array = np.array(values)
    if array.size == 0:
        array = np.zeros((0, 3) if dimensions == 2 else 0, np.int32)
    if array.ndim != dimensions or (dimensions == 2 and array.shape[1] != 3):
        raise InputError(
            f"A mesh's {name} must be triangles, rows of 3 indices; got the shape {array.shape}."
        )
    if not np.issubdtype(array.dtype, np.integer):
        raise InputError(f"A mesh's {name} must be whole numbers, got {array.dtype}.")
    if array.size and (array.min() < 0 or array.max() >= count):
        raise InputError(
            f"A mesh's {name} must refer to 0 to {count - 1}, got {int(array.min())} to {int(array.max())}."
        )
    array = array.astype(np.int32)
    array.flags.writeable = False
    return array
