"""How a body stands: the turns of its joints."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from types import MappingProxyType

import numpy as np

from swifttailor.arrays import Array
from swifttailor.body.rig import Rig, mirrored_name
from swifttailor.errors import InputError

Turn = tuple[float, float, float]


@dataclass(frozen=True)
class Pose:
    """Turns of joints against their parents, from the default body's standing pose."""

    turns: Mapping[str, Turn] = field(default_factory=dict)
    """Joint to rotation vector in degrees: its direction is the axis in the standing body's frame, its
    length the angle, anticlockwise seen from where it points. Joints left out do not turn."""

    def __post_init__(self) -> None:
        checked = {}
        for name, turn in self.turns.items():
            if len(turn) != 3 or not np.isfinite(turn).all():
                raise InputError(f"A joint turns by three finite numbers in degrees; {name!r} has {turn!r}.")
            checked[name] = (float(turn[0]), float(turn[1]), float(turn[2]))
        object.__setattr__(self, "turns", MappingProxyType(checked))

    def mirrored(self) -> Pose:
        """The same, left and right exchanged."""
        return Pose({mirrored_name(name): (x, -y, -z) for name, (x, y, z) in self.turns.items()})

    def rotations(self, rig: Rig, *, half: bool = False) -> Array:
        """(J, 3, 3) turn of each joint against its parent, or half of it."""
        vectors = np.zeros((rig.joint_count, 3))
        for name, turn in self.turns.items():
            vectors[rig.index(name)] = turn
        return rotation_matrices(np.deg2rad(vectors) * (0.5 if half else 1.0))


def rotation_matrices(vectors: Array) -> Array:
    """Rotation vectors (n, 3) in radians to matrices (n, 3, 3) (Rodrigues)."""
    angle = np.sqrt((vectors**2).sum(axis=1))
    safe = np.maximum(angle, 1e-12)
    x, y, z = (vectors / safe[:, None]).T
    zero = np.zeros_like(x)
    cross = np.stack([zero, -z, y, z, zero, -x, -y, x, zero], axis=1).reshape(-1, 3, 3)
    sin, cos = np.sin(angle)[:, None, None], np.cos(angle)[:, None, None]
    return np.eye(3) + sin * cross + (1.0 - cos) * (cross @ cross)


def rotation_vectors(matrices: Array) -> Array:
    """Rotations (n, 3, 3) to rotation vectors (n, 3) in radians, of at most half a turn."""
    from scipy.spatial.transform import Rotation

    return Rotation.from_matrix(matrices).as_rotvec()


def turn_from_to(start: Array, end: Array) -> Array:
    """(3, 3) the smallest rotation that brings one direction (3,) to another."""
    start, end = start / np.linalg.norm(start), end / np.linalg.norm(end)
    axis = np.cross(start, end)
    sine = float(np.linalg.norm(axis))
    if sine < 1e-9:
        if start @ end > 0:
            return np.eye(3)
        axis, sine = np.cross(start, np.eye(3)[np.abs(start).argmin()]), 1.0
    angle = np.arctan2(np.linalg.norm(np.cross(start, end)), float(start @ end))
    return rotation_matrices((axis / np.linalg.norm(axis) * angle)[None])[0]
