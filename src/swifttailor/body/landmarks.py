"""Landmarks that ride on the default body's mesh, and the measures that are taken between them.

A level such as the waist is the mean height of the vertices that lie there on the default body, so it goes
where these go when the body changes its shape. Girths are those of a tape (`measuring.girth`), at the levels.
All landmarks are drawn in docs/sizes.md.
"""

from __future__ import annotations

import functools
from dataclasses import dataclass, field

import numpy as np

from swifttailor.arrays import Array
from swifttailor.body.body import Body
from swifttailor.body.measuring import girth, slice_girth, slice_points, split_girth
from swifttailor.body.parts import BodyPart, face_parts

_BAND_CM = 1.6
"""Half height of the band of vertices that a level rides on."""
_REACH_CM = 9.0
"""Faces further from a level on the default body are not asked for its girth."""

LEVELS: dict[str, tuple[float, str]] = {
    "throat": (150.0, "trunk"),
    "neck": (145.66, "trunk"),
    "shoulder": (142.18, "shoulder"),
    "armpit": (132.80, "trunk"),
    "bust": (124.53, "trunk"),
    "underbust": (116.45, "trunk"),
    "waist": (108.77, "trunk"),
    "hips": (85.29, "trunk"),
    "crotch": (76.47, "leg"),
    "thigh": (74.75, "leg"),
    "knee": (47.5, "leg"),
    "calf": (34.0, "leg"),
    "ankle": (9.5, "leg"),
}
"""Heights on the default body in cm (GarmentCode's where it has one), and what of the body lies there."""

POINTS: dict[str, tuple[float, float, float]] = {
    "neck point": (9.466, 145.66, -3.5),
    "shoulder point": (18.23, 142.18, -3.5),
    "bust point": (8.473, 124.53, 12.0),
    "waist point": (8.473, 108.77, 10.0),
    "seat point": (9.117, 87.5, -13.0),
    "waist side": (14.0, 108.77, 0.0),
    "hip side": (18.0, 85.29, 0.0),
    "chest side": (16.6, 124.53, -0.8),
}
"""Near these places, on the wearer's left, cm; the surface next to them is taken."""
SIDES = {"bust": "chest side", "waist": "waist side", "hips": "hip side"}
"""Level: the point that divides its front from its back."""
RINGS: dict[str, tuple[tuple[float, float, float], tuple[float, float, float]]] = {
    "upper arm": ((17.2, 136.3, -2.8), (35.4, 116.9, -0.9)),
    "elbow": ((17.2, 136.3, -2.8), (54.8, 101.2, 3.0)),
    "wrist": ((35.4, 116.9, -0.9), (54.8, 101.2, 3.0)),
}
"""Rings around the left arm: the bone (from, to) that the tape is laid across."""
_RING_AT = {"upper arm": 0.45, "elbow": 0.5, "wrist": 0.93}
_RING_CENTER = {"elbow": (35.4, 116.9, -0.9)}


@dataclass(frozen=True, eq=False)
class Landmarks:
    """Where the landmarks lie on a mesh with the default body's vertices; everything in cm."""

    vertices: Array
    """(N, 3) of the body."""
    _found: dict[str, float] = field(default_factory=dict, init=False)

    def level(self, name: str) -> float:
        """Height of a level above the floor."""
        if name == "thigh":  # as `measure_body` takes it
            return self.level("crotch") - 0.01 * float(np.ptp(self.vertices[:, 1]))
        riders, offset = _riders()[name]
        return float(self.vertices[riders, 1].mean()) + offset

    def point(self, name: str) -> Array:
        """(3,) of a point on the wearer's left."""
        return self.vertices[_point_riders()[name]].mean(axis=0)

    def ring(self, name: str) -> tuple[Array, Array]:
        """Centre (3,) of a ring around the left arm, and the direction (3,) of the bone there."""
        riders, before, after = _ring_riders()[name]
        axis = self.vertices[after].mean(axis=0) - self.vertices[before].mean(axis=0)
        return self.vertices[riders].mean(axis=0), axis / np.linalg.norm(axis)

    def girth(self, name: str) -> float:
        """Girth at a level of the trunk, of the left leg or across a ring of the left arm."""
        if name not in self._found:
            self._found[name] = self._girth(name)
        return self._found[name]

    def _girth(self, name: str) -> float:
        if name in RINGS:
            center, axis = self.ring(name)
            return slice_girth(self.vertices, ring_faces()[name], axis, float(center @ axis))
        return girth(self.vertices, level_faces()[name], self.level(name))

    def widths(self, name: str) -> tuple[float, float]:
        """Front and back part of a girth of the trunk, divided at its sides."""
        cut = slice_points(self.vertices, level_faces()[name], np.array([0.0, 1.0, 0.0]), self.level(name))
        return split_girth(cut[:, [0, 2]], float(self.point(SIDES[name])[2]))


@functools.cache
def _trunk() -> Array:
    """Faces of the default body without arms."""
    body = Body.default()
    return body.faces[~np.isin(face_parts(body.faces, body.vertex_part), [2, 3])]


@functools.cache
def _riders() -> dict[str, tuple[Array, float]]:
    body = Body.default()
    x, y, _ = body.vertices.T
    arms = np.isin(body.vertex_part, [BodyPart.LEFT_ARM, BodyPart.RIGHT_ARM])
    where = {
        "trunk": ~arms,
        "leg": ~arms,
        "shoulder": (np.abs(np.abs(x) - 18.23) < 2.5) & (y > 139.0),
    }
    found = {}
    for name, (level, part) in LEVELS.items():
        chosen = where[part] & (np.abs(y - level) < _BAND_CM)
        if name == "crotch":  # between the legs, not at their outer sides
            chosen = (~arms) & (np.abs(x) < 2.0) & (np.abs(y - level) < 2.5)
        if name == "armpit":  # under the arms: thick ones begin lower
            chosen = _joint_vertices() & (y < level - 1.5)
        riders = np.flatnonzero(chosen)
        found[name] = riders, level - float(y[riders].mean())
    return found


def _joint_vertices() -> Array:
    """(N,) bool: where arms begin."""
    body = Body.default()
    labels = body.vertex_part[body.faces]
    arms = np.isin(labels, [BodyPart.LEFT_ARM, BodyPart.RIGHT_ARM])
    mixed = arms.any(axis=1) & ~arms.all(axis=1)
    found = np.zeros(len(body.vertices), np.bool_)
    found[body.faces[mixed][arms[mixed]]] = True
    return found


@functools.cache
def level_faces() -> dict[str, Array]:
    """Faces near each level, on one leg below the crotch."""
    body = Body.default()
    faces = _trunk()
    middle = body.vertices[faces].mean(axis=1)
    found = {}
    for name, (level, part) in LEVELS.items():
        near = np.abs(middle[:, 1] - level) < _REACH_CM
        if part == "leg":
            near &= middle[:, 0] > 0
        found[name] = faces[near]
    return found


@functools.cache
def _point_riders() -> dict[str, Array]:
    from scipy.spatial import KDTree

    body = Body.default()
    arms = np.isin(body.vertex_part, [BodyPart.LEFT_ARM, BodyPart.RIGHT_ARM])
    kept = np.flatnonzero((body.vertices[:, 0] > 0) & ~(arms & (body.vertices[:, 1] < 139.0)))
    tree = KDTree(body.vertices[kept])
    return {name: kept[tree.query(place, k=4)[1]] for name, place in POINTS.items()}


@functools.cache
def _ring_riders() -> dict[str, tuple[Array, Array, Array]]:
    """Vertices at each ring, and those of two rings before and after it, which give the bone's direction."""
    body = Body.default()
    arm = np.flatnonzero(body.vertex_part == BodyPart.LEFT_ARM)
    found = {}
    for name, (start, end) in RINGS.items():
        bone = np.subtract(end, start)
        long = float(np.linalg.norm(bone))
        middle = _RING_CENTER.get(name)
        center = np.array(middle) if middle is not None else start + _RING_AT[name] * bone
        along = (body.vertices[arm] - center) @ bone / long
        away = np.linalg.norm(body.vertices[arm] - center - along[:, None] * bone / long, axis=1)
        rings = [arm[(np.abs(along - place) < 0.9) & (away < 9.0)] for place in (0.0, -5.0, 3.0)]
        found[name] = rings[0], rings[1], rings[2]
    return found


@functools.cache
def ring_faces() -> dict[str, Array]:
    """Faces (m, 3) of the left arm near each ring."""
    body = Body.default()
    own = body.faces[face_parts(body.faces, body.vertex_part) == BodyPart.LEFT_ARM]
    middle = body.vertices[own].mean(axis=1)
    return {
        name: own[np.linalg.norm(middle - body.vertices[riders].mean(axis=0), axis=1) < _REACH_CM]
        for name, (riders, _, _) in _ring_riders().items()
    }
