"""Rotations in space, small enough to be made by the hundred while a garment is placed."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

Row = tuple[float, float, float]


@dataclass(frozen=True, slots=True)
class Rotation:
    """A rotation, as the rows of its matrix."""

    rows: tuple[Row, Row, Row] = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))

    @classmethod
    def from_euler(cls, x: float, y: float, z: float) -> Rotation:
        """About x, y and z in degrees, each about the axis that the ones before have turned (Rx Ry Rz)."""
        turns = [_about(axis, math.radians(angle)) for axis, angle in enumerate((x, y, z))]
        return turns[0] * turns[1] * turns[2]

    @classmethod
    def aligning(cls, first: Sequence[float], second: Sequence[float]) -> Rotation:
        """The shortest rotation of one direction into another."""
        axis = _cross(first, second)
        sine = math.sqrt(_dot(axis, axis))
        if sine == 0.0:
            return cls()
        angle = math.atan2(sine, _dot(first, second))
        x, y, z = (a / sine for a in axis)
        c, s = math.cos(angle), math.sin(angle)
        d = 1 - c
        return cls(
            (
                (c + x * x * d, x * y * d - z * s, x * z * d + y * s),
                (y * x * d + z * s, c + y * y * d, y * z * d - x * s),
                (z * x * d - y * s, z * y * d + x * s, c + z * z * d),
            )
        )

    def __deepcopy__(self, memo: object) -> Rotation:
        return self  # it never changes

    def apply(self, point: Sequence[float]) -> list[float]:
        """The turned point, as three numbers."""
        return [_dot(row, point) for row in self.rows]

    def __mul__(self, other: Rotation) -> Rotation:
        """This rotation after another one."""
        columns = list(zip(*other.rows, strict=True))
        a, b, c = ((_dot(row, columns[0]), _dot(row, columns[1]), _dot(row, columns[2])) for row in self.rows)
        return Rotation((a, b, c))

    def as_euler(self) -> Row:
        """Degrees about x, y and z, read as `from_euler` does; z is 0 where it is not determined."""
        (r00, r01, r02), (_, r11, r12), (_, r21, r22) = self.rows
        across = math.hypot(r00, r01)
        y = math.atan2(r02, across)
        x, z = (
            (math.atan2(r21, r11), 0.0) if across < 1e-7 else (math.atan2(-r12, r22), math.atan2(-r01, r00))
        )
        return math.degrees(x) + 0.0, math.degrees(y) + 0.0, math.degrees(z) + 0.0

    def mirrored(self) -> Rotation:
        """What it looks like in a mirror across the plane x = 0."""
        x, y, z = self.as_euler()
        return Rotation.from_euler(x, -y, -z)


def _about(axis: int, angle: float) -> Rotation:
    c, s = math.cos(angle), math.sin(angle)
    if axis == 0:
        return Rotation(((1.0, 0.0, 0.0), (0.0, c, -s), (0.0, s, c)))
    if axis == 1:
        return Rotation(((c, 0.0, s), (0.0, 1.0, 0.0), (-s, 0.0, c)))
    return Rotation(((c, -s, 0.0), (s, c, 0.0), (0.0, 0.0, 1.0)))


def _dot(a: Sequence[float], b: Sequence[float]) -> float:
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def _cross(a: Sequence[float], b: Sequence[float]) -> Row:
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]
