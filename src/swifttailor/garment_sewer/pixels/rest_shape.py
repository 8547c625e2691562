"""How much a mesh in space is stretched and turned against its flat panels, face by face."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import csr_array

from swifttailor.arrays import Floats
from swifttailor.errors import GeometryError
from swifttailor.panel_mesh.pattern_mesh import PatternMesh

_MIN_AREA = 1e-4
"""Square centimetres; smaller faces have no usable directions and are left out."""


@dataclass(frozen=True, eq=False)
class RestShape:
    """The flat panels as a linear operator: vertices in space to the gradient of every face.

    The gradient of a face is the (3, 2) matrix that takes steps in its flat panel to steps in space. Where
    the cloth is neither stretched nor sheared its columns are orthonormal.
    """

    gradient: csr_array
    """(2 f, v): both columns of each face's gradient from the welded vertices, x, y or z at a time."""
    area: Floats
    """(f,) flat area, cm^2."""
    corners: NDArray[np.int64]
    """(f, 3) flat vertices of the faces that count."""
    slope: Floats
    """(f, 2, 3): both columns of a face's gradient from its corners."""
    vertex_area: Floats
    """(v,) a third of the area of the faces around each welded vertex, cm^2."""

    def gradients(self, vertices: Floats) -> Floats:
        """(f, 2, 3) gradients, transposed, of vertices (v, 3)."""
        return (self.gradient @ vertices).reshape(-1, 2, 3)

    @property
    def weighted(self) -> csr_array:
        """(v, 2 f): the operator's transpose, each face weighted by its area."""
        return csr_array(self.gradient.T.multiply(np.repeat(self.area, 2)[None, :]))


def rest_shape(mesh: PatternMesh) -> RestShape:
    """The rest shape of a mesh whose seams are closed. Faces that a seam has closed up are left out."""
    flat, faces = mesh.flat_vertices, mesh.flat_faces.astype(np.int64)
    welded = mesh.weld[faces].astype(np.int64)
    (ux, uy), (vx, vy) = (flat[faces[:, 1]] - flat[faces[:, 0]]).T, (flat[faces[:, 2]] - flat[faces[:, 0]]).T
    doubled = ux * vy - uy * vx
    open_face = (welded != np.roll(welded, 1, axis=1)).all(axis=1)
    kept = np.flatnonzero((np.abs(doubled) > 2 * _MIN_AREA) & open_face)
    ux, uy, vx, vy, doubled = (a[kept] for a in (ux, uy, vx, vy, doubled))
    # Rows: the derivatives of the last two barycentric coordinates along local x and y.
    slope = np.stack([np.stack([vy, -uy], 1), np.stack([-vx, ux], 1)], axis=1) / doubled[:, None, None]
    share = np.concatenate([-slope.sum(axis=2, keepdims=True), slope], axis=2)
    corners = np.repeat(welded[kept][:, None, :], 2, axis=1)
    starts = np.arange(0, corners.size + 1, 3)
    gradient = csr_array((share.ravel(), corners.ravel(), starts), shape=(2 * len(kept), mesh.vertex_count))
    area = np.abs(doubled) / 2
    weights = np.repeat(area / 3, 3)
    vertex_area = np.bincount(welded[kept].ravel(), weights, mesh.vertex_count).astype(np.float64)
    return RestShape(gradient, area, faces[kept], share, vertex_area)


def flat_gradients(mesh: PatternMesh, shape: RestShape, flat_positions: Floats) -> Floats:
    """(f, 2, 3) gradients of panels that are not joined yet, from the positions (m, 3) of flat vertices."""
    if flat_positions.shape != (len(mesh.weld), 3):
        raise GeometryError(
            f"A mesh of {len(mesh.weld)} flat vertices was given positions of shape {flat_positions.shape}."
        )
    return np.einsum("fgc,fck->fgk", shape.slope, flat_positions[shape.corners])


def limit_stretch(gradients: Floats, longest: float) -> Floats:
    """Gradients (f, 2, 3) whose largest stretch is brought down to `longest` where it is larger.

    The other direction, along which a gradient stretches least, stays; cloth may be shortened, by buckling.
    """
    a = (gradients[:, 0] * gradients[:, 0]).sum(axis=1)
    b = (gradients[:, 0] * gradients[:, 1]).sum(axis=1)
    c = (gradients[:, 1] * gradients[:, 1]).sum(axis=1)
    # Singular values squared are the eigenvalues of [a b; b c]; the turn to its axes has angle phi.
    phi = 0.5 * np.arctan2(2 * b, a - c)
    cos, sin = np.cos(phi)[:, None], np.sin(phi)[:, None]
    along = cos * gradients[:, 0] + sin * gradients[:, 1]
    across = cos * gradients[:, 1] - sin * gradients[:, 0]
    limited = []
    for axis in (along, across):
        size = np.linalg.norm(axis, axis=1, keepdims=True)
        limited.append(axis * np.minimum(1.0, longest / np.maximum(size, 1e-12)))
    along, across = limited
    return np.stack([cos * along - sin * across, sin * along + cos * across], axis=1)


def nearest_unstretched(gradients: Floats) -> Floats:
    """The nearest gradients (f, 2, 3) without stretch and shear: the orthonormal part of the polar split.

    Faces without any extent in space get some orthonormal pair or zero, never NaN.
    """
    a = (gradients[:, 0] * gradients[:, 0]).sum(axis=1)
    b = (gradients[:, 0] * gradients[:, 1]).sum(axis=1)
    c = (gradients[:, 1] * gradients[:, 1]).sum(axis=1)
    # Square root of the symmetric 2 x 2 matrix C = [a b; b c]: (C + s I) / t with s = sqrt(det C).
    s = np.sqrt(np.maximum(a * c - b * b, 1e-12))
    t = np.sqrt(a + c + 2 * s)
    first = ((c + s)[:, None] * gradients[:, 0] - b[:, None] * gradients[:, 1]) / (s * t)[:, None]
    second = ((a + s)[:, None] * gradients[:, 1] - b[:, None] * gradients[:, 0]) / (s * t)[:, None]
    return np.stack([first, second], axis=1)
