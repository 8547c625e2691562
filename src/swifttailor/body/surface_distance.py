"""Exact signed distance from points to a triangle surface."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from swifttailor.arrays import Array
from swifttailor.errors import GeometryError

TRIANGLES_PER_LEAF = 4


@dataclass(frozen=True, eq=False)
class SurfaceTree:
    """A triangle surface prepared for distance queries.

    Build it with `SurfaceTree.build`; the arrays are described in `swifttailor.body.surface_kernels`.
    """

    corners: Array
    """(T, 9) float64 triangles in tree order, cm."""
    boxes: Array
    """(2 L, 6) float64 bounds of the tree's nodes, cm."""
    dipoles: Array
    """(2 L, 7) float64 area vector, centre and radius of each node."""
    face_of: Array
    """(T,) int64 index of each sorted triangle among the faces given."""

    @classmethod
    def build(cls, vertices: Array, faces: Array) -> SurfaceTree:
        """Prepares a surface.

        Args:
            vertices: (N, 3) positions, cm.
            faces: (M, 3) vertex indices. A closed surface turned inside out is turned back, so inside is
                always the bounded side.

        Raises:
            GeometryError: There are no faces, an index is out of range, or a position is not finite.
        """
        from swifttailor.body import surface_kernels

        vertices, faces = _checked(vertices, faces)
        corners = vertices[faces].reshape(-1, 9)
        if _volume(corners) < 0.0:
            corners = corners.reshape(-1, 3, 3)[:, ::-1].reshape(-1, 9)
        order = np.argsort(_morton_codes(corners), kind="stable")
        corners = np.ascontiguousarray(corners[order])
        leaves = 1
        while leaves * TRIANGLES_PER_LEAF < len(corners):
            leaves *= 2
        boxes = np.zeros((2 * leaves, 6))
        dipoles = np.zeros((2 * leaves, 7))
        surface_kernels.fill_tree(corners, boxes, dipoles)
        return cls(corners, boxes, dipoles, order)

    def signed_distance(self, points: Array) -> tuple[Array, Array]:
        """Distances of points to the surface; see the function `signed_distance`."""
        from swifttailor.body import surface_kernels

        points = np.ascontiguousarray(points, np.float64)
        if points.ndim != 2 or points.shape[1] != 3:
            raise GeometryError(f"points must have the shape (P, 3), received {points.shape}.")
        if not np.isfinite(points).all():
            raise GeometryError("points hold a NaN or an infinity; remove or mend those rows first.")
        distance, nearest = surface_kernels.signed_distances(points, self.corners, self.boxes, self.dipoles)
        return distance, self.face_of[nearest]

    def lattice(self, origin: Array, spacing: float, shape: tuple[int, int, int], band: float) -> Array:
        """Signed distances at the nodes ``origin + spacing * (i, j, k)``.

        Args:
            origin: (3,) position of node (0, 0, 0), cm.
            spacing: Distance between neighbouring nodes, cm.
            shape: Node counts.
            band: Nodes up to this far from the surface are exact, cm; the others are upper bounds.

        Returns:
            (nx, ny, nz) float32, cm, negative inside.
        """
        from swifttailor.body import surface_kernels

        origin = np.ascontiguousarray(origin, np.float64)
        counts = np.array(shape, np.int64)
        return surface_kernels.lattice_distances(
            origin, float(spacing), counts, float(band), self.corners, self.boxes, self.dipoles
        )


def signed_distance(vertices: Array, faces: Array, points: Array) -> tuple[Array, Array]:
    """Exact signed distance from points to a surface.

    Inside is where the generalised winding number exceeds one half, so small holes, overlapping limbs and
    closed shells within the body (eyes, a mouth cavity) are handled.

    Args:
        vertices: (N, 3) positions, cm.
        faces: (M, 3) vertex indices.
        points: (P, 3) positions, cm.

    Returns:
        Distances (P,) float64 in cm, negative inside, and the index of the nearest face (P,) int64.

    Raises:
        GeometryError: The surface is empty or an array has the wrong shape or a NaN.
    """
    return SurfaceTree.build(vertices, faces).signed_distance(points)


def _checked(vertices: Array, faces: Array) -> tuple[Array, Array]:
    """The arrays as (N, 3) float64 and (M, 3) int64, or a `GeometryError`."""
    vertices = np.asarray(vertices, np.float64)
    faces = np.asarray(faces)
    if vertices.ndim != 2 or vertices.shape[1] != 3:
        raise GeometryError(f"vertices must have the shape (N, 3), received {vertices.shape}.")
    if faces.ndim != 2 or faces.shape[1] != 3 or len(faces) == 0:
        raise GeometryError(f"faces must have the shape (M, 3) with M > 0, received {faces.shape}.")
    if faces.min() < 0 or faces.max() >= len(vertices):
        raise GeometryError(
            f"faces refer to vertices {faces.min()} to {faces.max()}, but there are {len(vertices)} vertices."
        )
    if not np.isfinite(vertices).all():
        raise GeometryError("vertices hold a NaN or an infinity.")
    return vertices, faces.astype(np.int64)


def _volume(corners: Array) -> float:
    """Signed volume enclosed by (T, 9) triangles, cm3."""
    a, b, c = corners[:, 0:3], corners[:, 3:6], corners[:, 6:9]
    middle = corners.reshape(-1, 3).mean(axis=0)
    return float(np.einsum("ij,ij->i", a - middle, np.cross(b - middle, c - middle)).sum() / 6.0)


def _morton_codes(corners: Array) -> Array:
    """Position of each triangle's centre along a Z-order curve, (T,) uint64."""
    centres = corners.reshape(-1, 3, 3).mean(axis=1)
    low = centres.min(axis=0)
    size = max(float(np.ptp(centres, axis=0).max()), 1e-12)
    cells = np.minimum((centres - low) / size * 2**20, 2**20 - 1).astype(np.uint64)
    codes = np.zeros(len(cells), np.uint64)
    for axis in range(3):
        codes |= _spread_bits(cells[:, axis]) << np.uint64(axis)
    return codes


def _spread_bits(values: Array) -> Array:
    """Puts two zero bits between the lowest 21 bits of each value."""
    for shift, mask in (
        (32, 0x1F00000000FFFF),
        (16, 0x1F0000FF0000FF),
        (8, 0x100F00F00F00F00F),
        (4, 0x10C30C30C30C30C3),
        (2, 0x1249249249249249),
    ):
        values = (values | (values << np.uint64(shift))) & np.uint64(mask)
    return values
