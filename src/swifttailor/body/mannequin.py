"""A body as a shop mannequin, for pictures: smooth, without anatomy. What collides is the body itself."""

from __future__ import annotations

import functools
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from swifttailor.arrays import Array
from swifttailor.body.body import Body
from swifttailor.body.hands_in_sleeves import Arm, hands_in_sleeves
from swifttailor.body.measuring import arm_axis
from swifttailor.body.parts import ARMS

UNIT_CM = 0.01
"""Of the numbers in the file."""
_FILE = Path(__file__).with_name("mannequin.npz")
_NEAR_CM, _FAR_CM = 2.0, 4.0
"""Hollows are emptied where cloth is nearer than the first, and left filled where it is beyond the second."""
_NEIGHBOURS, _SOFT_CM = 24, 1.0
"""How many vertices of the default body carry one of its mannequin; how far off their share is halved, cm."""
_ROUNDS = 60
_OUTWARD_CM = 0.5
"""A smoothed body of somebody's own fills hollows by at most this much, so that cloth stays outside."""
_INWARD_CM = 0.4
"""Under cloth it lies so far inside the body: the triangles of the cloth cut its curves."""


def mannequin(body: Body, cloth: Array | None = None, sleeves: Array | None = None) -> tuple[Array, Array]:
    """The surface that stands for a body in pictures.

    The default body has one that is made with care (``scripts/make_mannequin.py``). Of people of other sizes,
    whose bodies are the default one in another shape, it is carried along. Any other body is smoothed, and
    pushed out nowhere by more than half a centimetre.

    Args:
        body: Who wears the garment.
        cloth: (k, 3) points of what is worn, cm. The mannequin fills some hollows of the body; under cloth
            they are empty again, so that it does not show through.
        sleeves: (s, 3) those of its sleeves, cm; hands stay inside these. None: hands are as they are.

    Returns:
        Vertices (n, 3) in cm and faces (m, 3), anticlockwise seen from outside.
    """
    if body is Body.default():
        made = _default()
    elif np.array_equal(body.faces, Body.default().faces):
        made = _carried_to(body)
    else:
        surface = smoothed(body.vertices, body.faces)
        return (surface if cloth is None else _under_cloth(surface, body, cloth)), body.faces
    if cloth is None or not len(cloth):
        return made.vertices, made.faces
    from scipy.spatial import KDTree

    filled = np.flatnonzero(made.over > 0.0)
    away, _ = KDTree(cloth).query(made.vertices[filled], distance_upper_bound=_FAR_CM)
    share = np.clip((_FAR_CM - away) / (_FAR_CM - _NEAR_CM), 0.0, 1.0)
    vertices = made.vertices.copy()
    vertices[filled] -= (share * made.over[filled])[:, None] * made.normals[filled]
    if sleeves is None or not len(sleeves):
        return vertices, made.faces
    return hands_in_sleeves(vertices, sleeves, _arms(body)), made.faces


@functools.lru_cache(maxsize=4)
def _arms(body: Body) -> list[Arm]:
    """The arms of a body that has the mesh of the default one."""
    found = []
    for part in sorted(ARMS):
        joint, axis = arm_axis(body.vertices, body.faces, body.vertex_part, part)
        along = (body.vertices[body.vertex_part == part] - joint) @ axis
        own = np.flatnonzero(_parts_of_mannequin() == part)
        found.append(Arm(joint, axis, float(along.max()), own))
    return found


@functools.cache
def _parts_of_mannequin() -> NDArray[np.uint8]:
    """(n,) `BodyPart` of each vertex of the mannequin: that of the nearest one of the default body."""
    near, _ = _neighbours()
    return Body.default().vertex_part[near[:, 0]]


def _under_cloth(surface: Array, body: Body, cloth: Array) -> Array:
    """A smoothed body (n, 3) that stays inside the body wherever cloth is near."""
    from scipy.spatial import KDTree

    if not len(cloth):
        return surface
    normals = _normals(body.vertices, body.faces)
    over = np.einsum("ij,ij->i", surface - body.vertices, normals) + _INWARD_CM
    away, _ = KDTree(cloth).query(body.vertices, distance_upper_bound=_FAR_CM)
    share = np.clip((_FAR_CM - away) / (_FAR_CM - _NEAR_CM), 0.0, 1.0)
    return surface - (share * np.maximum(over, 0.0))[:, None] * normals


@dataclass(frozen=True, eq=False)
class _Mannequin:
    vertices: Array
    """(n, 3) cm."""
    faces: Array
    """(m, 3)."""
    over: Array
    """(n,) how far above the body, cm; 0 inside."""
    normals: Array
    """(n, 3)."""


@functools.cache
def _default() -> _Mannequin:
    with np.load(_FILE, allow_pickle=False) as stored:
        vertices = stored["vertices"].astype(np.float64) * UNIT_CM
        faces = stored["faces"].astype(np.int32)
        return _Mannequin(vertices, faces, stored["over"] * UNIT_CM, _normals(vertices, faces))


@functools.lru_cache(maxsize=4)
def _carried_to(body: Body) -> _Mannequin:
    """The mannequin of the default body, moved as that is to become another.

    Bodies differ smoothly, faces and fingers apart, and the mean over neighbours leaves these out.
    """
    near, weights = _neighbours()
    made, default = _default(), Body.default()
    vertices = made.vertices + np.einsum("nk,nki->ni", weights, (body.vertices - default.vertices)[near])
    normals, closest = _normals(body.vertices, body.faces), near[:, 0]
    over = np.einsum("ij,ij->i", vertices - body.vertices[closest], normals[closest])
    return _Mannequin(
        vertices, made.faces, np.maximum(over + _INWARD_CM, 0.0), _normals(vertices, made.faces)
    )


@functools.cache
def _neighbours() -> tuple[NDArray[np.intp], Array]:
    """(n, k) the vertices of the default body next to each of its mannequin, nearest first; their shares."""
    from scipy.spatial import KDTree

    away, near = KDTree(Body.default().vertices).query(_default().vertices, k=_NEIGHBOURS)
    weights = 1 / (away + _SOFT_CM)
    return near, weights / weights.sum(axis=1, keepdims=True)


def smoothed(vertices: Array, faces: Array) -> Array:
    """Vertices (n, 3) of a closed mesh without its fine detail, by Taubin's filter (SIGGRAPH 1995).

    Args:
        vertices: (n, 3) cm.
        faces: (m, 3) vertex indices, anticlockwise seen from outside.
    """
    from scipy import sparse

    count = len(vertices)
    edges = faces[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2)
    links = sparse.coo_matrix((np.ones(len(edges)), (edges[:, 0], edges[:, 1])), (count, count)).tocsr()
    links = ((links + links.T) > 0).astype(np.float64)
    degree = np.asarray(links.sum(axis=1)).ravel()
    joined = degree > 0
    moved = vertices.astype(np.float64)
    for _ in range(_ROUNDS):
        for step in (0.6, -0.61):
            mean = (links @ moved)[joined] / degree[joined, None]
            moved[joined] += step * (mean - moved[joined])
    normals = _normals(vertices, faces)
    out = np.einsum("ij,ij->i", moved - vertices, normals)
    return moved - np.maximum(out - _OUTWARD_CM, 0.0)[:, None] * normals


def _normals(vertices: Array, faces: Array) -> Array:
    a, b, c = (vertices[faces[:, k]] for k in range(3))
    across = np.repeat(np.cross(b - a, c - a), 3, axis=0)
    corner = faces.ravel()
    summed = np.stack([np.bincount(corner, across[:, k], len(vertices)) for k in range(3)], axis=1)
    length = np.linalg.norm(summed, axis=1, keepdims=True)
    return np.divide(summed, length, out=np.zeros_like(summed), where=length > 1e-12)
