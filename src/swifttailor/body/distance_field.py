"""The signed distance to a body, sampled on a regular lattice and kept between runs."""

from __future__ import annotations

import hashlib
import os
import zipfile
import zlib
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from swifttailor.arrays import Array
from swifttailor.atomic_files import write_atomically
from swifttailor.errors import GeometryError, InputError, SwiftTailorError

MAX_NODES = 100_000_000
EXACT_BAND = 5.0
"""Nodes up to this far from the surface hold exact distances, cm."""

_CACHE_FORMAT = 2
_COVERING_ROUNDS = 4


@dataclass(frozen=True, eq=False)
class DistanceField:
    """Signed distances to a surface at the nodes of a regular lattice.

    Exact within `EXACT_BAND` of the surface, good to a few millimetres further away.
    """

    values: Array
    """(nx, ny, nz) float32, cm, negative inside the body."""
    origin: Array
    """(3,) float64 position of node (0, 0, 0), cm."""
    spacing: float
    """Distance between neighbouring nodes, cm."""

    def sample(self, points: Array) -> tuple[Array, Array]:
        """Distance and direction away from the body at arbitrary points.

        Between nodes the distance is interpolated trilinearly. Outside the lattice it is the value at the
        nearest point of the lattice plus the way to it: never less than the lattice's margin.

        Args:
            points: (P, 3) positions, cm.

        Returns:
            Distances (P,) float64 in cm and unit gradients (P, 3) float64, which point outwards; the
            gradient is zero where the field has none.

        Raises:
            GeometryError: `points` has another shape, or holds a NaN or an infinity.
        """
        points = np.asarray(points, np.float64)
        if points.ndim != 2 or points.shape[1] != 3:
            raise GeometryError(f"points must have the shape (P, 3), received {points.shape}.")
        if not np.isfinite(points).all():
            raise GeometryError("points hold a NaN or an infinity; remove or mend those rows first.")
        top = np.array(self.values.shape) - 1
        place = (points - self.origin) / self.spacing
        inside = np.clip(place, 0.0, top)
        cell = np.minimum(inside.astype(np.int64), np.maximum(top - 1, 0))
        f = inside - cell
        x0, y0, z0 = cell.T
        x1, y1, z1 = np.minimum(cell + 1, top).T
        v = self.values
        c000, c001 = v[x0, y0, z0].astype(np.float64), v[x0, y0, z1].astype(np.float64)
        c010, c011 = v[x0, y1, z0].astype(np.float64), v[x0, y1, z1].astype(np.float64)
        c100, c101 = v[x1, y0, z0].astype(np.float64), v[x1, y0, z1].astype(np.float64)
        c110, c111 = v[x1, y1, z0].astype(np.float64), v[x1, y1, z1].astype(np.float64)
        fx, fy, fz = f.T
        c00, c01 = c000 + fx * (c100 - c000), c001 + fx * (c101 - c001)
        c10, c11 = c010 + fx * (c110 - c010), c011 + fx * (c111 - c011)
        c0, c1 = c00 + fy * (c10 - c00), c01 + fy * (c11 - c01)
        distance = c0 + fz * (c1 - c0)
        slope_x0 = (c100 - c000) * (1 - fy) + (c110 - c010) * fy
        slope_x1 = (c101 - c001) * (1 - fy) + (c111 - c011) * fy
        gradient = np.stack(
            [slope_x0 * (1 - fz) + slope_x1 * fz, (c10 - c00) * (1 - fz) + (c11 - c01) * fz, c1 - c0], axis=1
        )
        away = (place - inside) * self.spacing
        gap = np.linalg.norm(away, axis=1)
        outside = gap > 0
        gradient[outside] = away[outside]
        length = np.linalg.norm(gradient, axis=1, keepdims=True)
        unit = np.divide(gradient, length, out=np.zeros_like(gradient), where=length > 1e-12)
        return distance + gap, unit


def build_field(vertices: Array, faces: Array, spacing: float, margin: float) -> DistanceField:
    """Computes the field of a surface.

    Nodes lie at whole multiples of `spacing`, so a body that is symmetric about x = 0 has a symmetric field.

    Args:
        vertices: (N, 3) positions, cm.
        faces: (M, 3) vertex indices.
        spacing: Distance between nodes, cm.
        margin: How far the lattice reaches beyond the surface, cm.

    Raises:
        InputError: `spacing` or `margin` is out of range, or the lattice would be too large.
    """
    from swifttailor.body.surface_distance import SurfaceTree

    if not (np.isfinite(spacing) and spacing > 0):
        raise InputError(f"spacing must be above zero (cm), received {spacing!r}; 1.0 suits most garments.")
    if not (np.isfinite(margin) and margin >= 0):
        raise InputError(f"margin must be zero or more (cm), received {margin!r}; 8.0 suits most garments.")
    low = np.floor((vertices.min(axis=0) - margin) / spacing)
    high = np.ceil((vertices.max(axis=0) + margin) / spacing)
    counts = (high - low).astype(np.float64) + 1
    if counts.prod() > MAX_NODES:
        raise InputError(
            f"A lattice with spacing {spacing} cm has {counts.prod():.3g} nodes here; at most {MAX_NODES} "
            "are accepted. Choose a larger spacing or a smaller margin."
        )
    shape = (int(counts[0]), int(counts[1]), int(counts[2]))
    origin = low * spacing
    values = SurfaceTree.build(vertices, faces).lattice(origin, spacing, shape, EXACT_BAND)
    return DistanceField(values, origin, float(spacing))


def cover_surface(field: DistanceField, vertices: Array, faces: Array) -> DistanceField:
    """Lowers a field until no point of the surface that it was made of samples as outside.

    Between the nodes of a coarse lattice, parts thinner than a cell (fingers, ears) are smoothed away and
    cloth would hang through them. Held against vertices, middles of edges and middles of faces.

    Args:
        field: What `build_field` made of the surface.
        vertices: (N, 3) positions, cm.
        faces: (M, 3) vertex indices.
    """
    corners = vertices[faces]
    middles = [(corners[:, k] + corners[:, (k + 1) % 3]) / 2 for k in range(3)]
    points = np.concatenate([vertices, corners.mean(axis=1), *middles])
    values = field.values.copy()
    strides = np.array([values.shape[1] * values.shape[2], values.shape[2], 1])
    corner_steps = np.array([[i, j, k] for i in (0, 1) for j in (0, 1) for k in (0, 1)]) @ strides
    for _ in range(_COVERING_ROUNDS):
        above, _ = DistanceField(values, field.origin, field.spacing).sample(points)
        bare = above > 0
        if not bare.any():
            break
        cells = np.floor((points[bare] - field.origin) / field.spacing).astype(np.int64) @ strides
        lower = np.zeros(values.size, np.float32)
        nodes = cells[:, None] + corner_steps
        np.maximum.at(lower, nodes.ravel(), np.repeat(above[bare] + 1e-4, 8).astype(np.float32))
        values -= lower.reshape(values.shape)
    return DistanceField(values, field.origin, field.spacing)


def cached_field(
    vertices: Array, faces: Array, spacing: float, margin: float, *, covering: bool = False
) -> DistanceField:
    """Like `build_field`, and `cover_surface` when `covering`, but keeps the result in the cache folder.

    The file's name is a hash of all arguments. A file that cannot be read is computed again, and a folder
    that cannot be written is no error.
    """
    key = _content_key(vertices, faces, spacing, margin, covering)
    path = cache_folder() / f"body-distance-{key}.npz"
    field = _read_field(path, spacing)
    if field is None:
        field = build_field(vertices, faces, spacing, margin)
        if covering:
            field = cover_surface(field, vertices, faces)
        _keep_field(path, field)
    return field


def cache_folder() -> Path:
    """Folder for files that can be made again: ``SWIFTTAILOR_CACHE``, else the user's cache folder."""
    if chosen := os.environ.get("SWIFTTAILOR_CACHE"):
        return Path(chosen)
    base = os.environ.get("XDG_CACHE_HOME") or os.path.join(os.path.expanduser("~"), ".cache")
    return Path(base) / "swifttailor"


def _content_key(vertices: Array, faces: Array, spacing: float, margin: float, covering: bool) -> str:
    """Hash of everything the field depends on."""
    digest = hashlib.sha256()
    numbers = (_CACHE_FORMAT, float(spacing), float(margin), covering, vertices.shape, faces.shape)
    digest.update(repr(numbers).encode())
    digest.update(np.ascontiguousarray(vertices, "<f8").tobytes())
    digest.update(np.ascontiguousarray(faces, "<i4").tobytes())
    return digest.hexdigest()[:32]


def _read_field(path: Path, spacing: float) -> DistanceField | None:
    """The field in `path`, or None when there is none or it is damaged."""
    try:
        with np.load(path, allow_pickle=False) as stored:
            values, origin = stored["values"], stored["origin"]
    except (OSError, ValueError, KeyError, EOFError, MemoryError, zipfile.BadZipFile, zlib.error):
        return None
    sound = (
        values.dtype == np.float32
        and values.ndim == 3
        and min(values.shape) >= 1
        and origin.shape == (3,)
        and origin.dtype == np.float64
        and np.isfinite(origin).all()
        and np.isfinite(values).all()
    )
    return DistanceField(values, origin, float(spacing)) if sound else None


def _keep_field(path: Path, field: DistanceField) -> None:
    """Writes the field to `path` if that is possible."""

    def write(temporary: Path) -> None:
        with temporary.open("wb") as stream:
            np.savez(stream, values=field.values, origin=field.origin)

    try:
        write_atomically(path, write, overwrite=True)
    except (SwiftTailorError, OSError):
        return
