"""What can be drawn: a triangle mesh with its colours and lines."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Protocol

import numpy as np

from swifttailor.arrays import Array
from swifttailor.errors import InputError


@dataclass(frozen=True, eq=False)
class LineSet:
    """Edges of a surface drawn as thin lines on it."""

    edges: Array
    """(n, 2) vertex indices of the surface."""
    strength: float = 0.5
    """Share of the surface's light that the line takes away, up to 1; below 0, that it adds."""
    width: float = 1.2
    """Pixels of the finished picture."""


class Print(Protocol):
    """What is printed on or woven into a cloth (`render.prints`)."""

    def colors(self, at: Array) -> Array:
        """Linear-light colours (n, 3) float32 at points (n, 2) of the cloth, cm."""
        ...


@dataclass(frozen=True, eq=False)
class Surface:
    """A triangle mesh as the renderer sees it; checked on construction."""

    vertices: Array
    """(n, 3) cm."""
    faces: Array
    """(m, 3) vertex indices, anticlockwise seen from the right side."""
    color: Array
    """(3,) or (m, 3) linear-light colour of the right side."""
    back_color: Array | None = None
    """(3,) or (m, 3) linear-light colour of the other side. None: closed surface, its inside is not drawn."""
    lines: tuple[LineSet, ...] = ()
    lift: float = 0.0
    """Centimetres by which it is drawn nearer than it is, so that what lies just under it stays hidden."""
    sheen: float = 0.0
    """Light caught at grazing angles, as by the fibres of cloth."""
    gloss: float = 0.0
    """Strength of the highlight, as on a mannequin."""
    print: Print | None = None
    """Takes the place of `color` on the right side, where given."""
    print_at: Array | None = None
    """(m, 3, 2) where on the cloth the corners of the faces lie, cm; goes with `print`."""
    rest: Array | None = None
    """(n, 3) where the vertices lie on a standing body, cm, for what is put on a place of the garment. None:
    where they are."""
    trusted: bool = False
    """Whether the arrays are known to be sound; then nothing is checked or copied, and what should be an
    array is one."""

    def __post_init__(self) -> None:
        if self.trusted:
            return
        vertices = np.array(self.vertices, dtype=np.float64)
        faces = np.asarray(self.faces)
        if vertices.ndim != 2 or vertices.shape[1] != 3:
            raise InputError(f"Vertices to draw must have the shape (n, 3), got {vertices.shape}.")
        if not np.isfinite(vertices).all():
            bad = int((~np.isfinite(vertices).all(axis=1)).sum())
            raise InputError(
                f"Vertices to draw must be finite numbers; {bad} of {len(vertices)} are NaN or infinite."
            )
        if faces.size == 0:
            faces = np.zeros((0, 3), np.int32)
        if faces.ndim != 2 or faces.shape[1] != 3 or not np.issubdtype(faces.dtype, np.integer):
            raise InputError(
                f"Faces to draw must be integers of shape (m, 3), got {faces.shape} {faces.dtype}."
            )
        _require_indices("Faces", faces, len(vertices))
        object.__setattr__(self, "vertices", vertices)
        object.__setattr__(self, "faces", faces.astype(np.int32))
        for name in ("color", "back_color"):
            color = getattr(self, name)
            if color is not None:
                color = np.asarray(color, np.float64)
                if color.shape not in ((3,), (len(faces), 3)):
                    raise InputError(
                        f"A surface's {name} has the shape (3,) or ({len(faces)}, 3), got {color.shape}."
                    )
                object.__setattr__(self, name, color)
        if self.print is not None:
            shape = () if self.print_at is None else self.print_at.shape
            if shape != (len(faces), 3, 2):
                raise InputError(
                    f"A surface with a print needs print_at of shape ({len(faces)}, 3, 2), got {shape}."
                )
        if self.rest is not None and self.rest.shape != vertices.shape:
            raise InputError(f"A surface's rest has the shape {vertices.shape}, got {self.rest.shape}.")
        for line in self.lines:
            _require_indices("Lines", np.asarray(line.edges).reshape(-1, 2), len(vertices))

    @cached_property
    def vertex_normals(self) -> Array:
        """(n, 3) unit normals, area-weighted; zero where a vertex has no face of any area."""
        return vertex_normals(self.vertices, self.faces)


def vertex_normals(vertices: Array, faces: Array) -> Array:
    """Unit normals (n, 3) of vertices (n, 3), area-weighted over faces (m, 3); zero without any area."""
    a, b, c = (vertices[faces[:, k]] for k in range(3))
    face_normals = np.cross(b - a, c - a)
    corner = faces.ravel()
    normals = np.stack(
        [np.bincount(corner, np.repeat(face_normals[:, k], 3), len(vertices)) for k in range(3)],
        axis=1,
        dtype=np.float64,
        casting="unsafe",
    )
    norm = np.linalg.norm(normals, axis=1, keepdims=True)
    return np.divide(normals, norm, out=np.zeros_like(normals), where=norm > 1e-12)


def _require_indices(what: str, indices: Array, count: int) -> None:
    if indices.size and (indices.min() < 0 or indices.max() >= count):
        raise InputError(
            f"{what} to draw must refer to vertices 0 to {count - 1}, "
            f"got {int(indices.min())} to {int(indices.max())}."
        )
