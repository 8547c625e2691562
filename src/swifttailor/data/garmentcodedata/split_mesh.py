"""The meshes of GarmentCodeData: cut open along seams when they were stored, and joined again here.

They were written as OBJ, with one vertex where panels meet and one texture coordinate for each panel there,
and then stored as PLY by a program that gives every pair of the two a vertex. So the vertices of a file are
those of the single panels, in the order of the OBJ's vertices; equal positions are one vertex of the garment.
Vertices that no face uses are lost.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components

from swifttailor.arrays import Floats, Ints
from swifttailor.errors import InputError

MAX_FILE_BYTES = 200_000_000
_SEAM = "stitch_"


@dataclass(frozen=True, eq=False)
class SplitMesh:
    """A simulated garment whose vertices belong to one panel each."""

    vertices: Floats
    """(n, 3) cm."""
    uv: Floats
    """(n, 2) texture coordinates: each panel's own shape, moved, and scaled differently in u and v."""
    faces: Ints
    """(f, 3)."""

    @cached_property
    def weld(self) -> Ints:
        """(n,) vertex of the garment, numbered in the order in which they first occur."""
        _, first, inverse = np.unique(self.vertices, axis=0, return_index=True, return_inverse=True)
        rank = np.argsort(np.argsort(first, kind="stable"), kind="stable")
        return rank[inverse.ravel()].astype(np.int32)

    @cached_property
    def island(self) -> Ints:
        """(n,) which connected piece each vertex belongs to; pieces in the order of their last vertices.

        GarmentCode numbers the vertices of seams first and then those of each panel, so this is the order of
        the panels.
        """
        count = len(self.vertices)
        joined = np.concatenate([self.faces[:, [0, 1]], self.faces[:, [1, 2]]])
        graph = coo_array((np.ones(len(joined)), (joined[:, 0], joined[:, 1])), shape=(count, count))
        pieces, label = connected_components(graph, directed=False)
        last = np.zeros(pieces, np.int64)
        np.maximum.at(last, label, np.arange(count))
        rank = np.argsort(np.argsort(last, kind="stable"), kind="stable")
        return rank[label].astype(np.int32)


def read_split_mesh(path: Path) -> SplitMesh:
    """Reads a `_sim.ply` or `_boxmesh.ply`.

    Raises:
        InputError: It is missing, damaged, holds no texture coordinates, or a vertex that is nowhere.
    """
    mesh = _read_ply(path)
    vertices, faces = np.array(mesh.vertices, np.float64), np.array(mesh.faces)
    uv = getattr(mesh.visual, "uv", None)
    if not len(faces):
        raise InputError(f"'{path}' holds no triangles.")
    if uv is None or np.shape(uv) != (len(vertices), 2):
        raise InputError(
            f"'{path}' has no texture coordinates (s, t), which say where on the panels its vertices lie. "
            "GarmentCodeData's own files have them."
        )
    if faces.min() < 0 or faces.max() >= len(vertices):
        raise InputError(f"'{path}' is damaged: its faces refer to more than its {len(vertices)} vertices.")
    uv = np.array(uv, np.float64)
    used = np.unique(faces)
    if not np.isfinite(vertices[used]).all() or not np.isfinite(uv[used]).all():
        raise InputError(f"'{path}' has vertices that are nowhere (NaN); its simulation has failed.")
    return SplitMesh(vertices[used], uv[used], np.searchsorted(used, faces).astype(np.int32))


def read_segmentation(path: Path) -> list[str]:
    """The panel of each vertex of the garment; empty text for those on seams.

    Raises:
        InputError: The file cannot be read.
    """
    try:
        lines = path.read_text(encoding="utf-8").splitlines()
    except (OSError, UnicodeDecodeError) as error:
        why = getattr(error, "strerror", None) or error
        raise InputError(f"Cannot read '{path}': {why}.") from error
    return ["" if line.startswith(_SEAM) else line.strip() for line in lines if line.strip()]


def _read_ply(path: Path) -> Any:
    import trimesh

    try:
        if path.stat().st_size > MAX_FILE_BYTES:
            raise InputError(f"'{path}' has more than {MAX_FILE_BYTES / 1e6:.0f} MB; is it the right file?")
        with path.open("rb") as stream:
            return trimesh.load_mesh(stream, file_type="ply", process=False)
    except OSError as error:
        raise InputError(f"Cannot read '{path}': {error.strerror or error}.") from error
    except InputError:
        raise
    except Exception as error:  # whatever the reader makes of damaged files
        raise InputError(
            f"'{path}' is no PLY file that can be read: {type(error).__name__} {error}."
        ) from error
