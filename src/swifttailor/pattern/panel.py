"""Panels, their edges and their place in space. Frame and winding: docs/conventions.md."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike

from swifttailor.arrays import Floats
from swifttailor.errors import PatternError
from swifttailor.pattern import curve as curves
from swifttailor.pattern.curve import Curve, Line

RotationReading = Literal["intrinsic", "extrinsic"]


@dataclass(frozen=True)
class Placement:
    """Where a flat panel stands in the world before draping."""

    translation: tuple[float, float, float] = (0.0, 0.0, 0.0)
    """Position of the panel's local origin, cm."""
    rotation: tuple[float, float, float] = (0.0, 0.0, 0.0)
    """Angles about x, y and z in degrees."""
    reading: RotationReading = "intrinsic"
    """``intrinsic``: R = Rx Ry Rz, as GarmentCode's generator writes them. ``extrinsic``: R = Rz Ry Rx, as
    GarmentCode's simulator and the older formats read the same numbers."""

    def matrix(self) -> Floats:
        """Rotation matrix (3, 3)."""
        rx, ry, rz = (_rotation(axis, np.deg2rad(a)) for axis, a in enumerate(self.rotation))
        return rx @ ry @ rz if self.reading == "intrinsic" else rz @ ry @ rx

    def moved(self, turn: Floats, shift: Floats) -> Placement:
        """The placement after a motion of the world: points x go to turn @ x + shift.

        Args:
            turn: Rotation matrix (3, 3).
            shift: (3,) cm.
        """
        x, y, z = (turn @ np.asarray(self.translation) + shift).tolist()
        return Placement((x, y, z), _angles(turn @ self.matrix(), self.reading), self.reading)

    def read_as(self, reading: RotationReading) -> Placement:
        """The same place in the world, with the angles written for the given reading."""
        return Placement(self.translation, _angles(self.matrix(), reading), reading)

    def apply(self, points: ArrayLike) -> Floats:
        """Carries panel-local points (n, 2) cm into the world (n, 3) cm."""
        points = np.asarray(points, float)
        return points @ self.matrix()[:, :2].T + np.asarray(self.translation)


@dataclass(frozen=True)
class Edge:
    """Edge k of a panel, from vertex k to vertex k + 1."""

    curve: Curve = field(default_factory=Line)
    label: str = ""
    """Attachment label of GarmentCode, such as ``lower_interface``; empty for most edges."""

    def drawn_as(self, curve: Curve) -> Edge:
        """The edge with another shape; itself where that is the shape that it has, as lines mostly do."""
        return self if curve is self.curve else replace(self, curve=curve)


@dataclass(frozen=True, eq=False)
class Panel:
    """One flat piece of cloth: a closed loop of edges.

    The right-hand normal of the loop, carried into the world, is the right side of the cloth.
    """

    name: str
    vertices: Floats
    """Corners (n, 2) in panel-local cm; edge k joins vertex k to vertex k + 1 modulo n."""
    edges: tuple[Edge, ...]
    placement: Placement = field(default_factory=Placement)
    label: str = ""
    """Body part of GarmentCode: ``body``, ``arm``, ``leg`` or empty."""

    def __post_init__(self) -> None:
        vertices = np.array(self.vertices, dtype=np.float64)
        if vertices.ndim != 2 or vertices.shape[1:] != (2,) or len(vertices) < 2:
            raise PatternError(
                f"Panel '{self.name}': vertices must be an (n, 2) array with n >= 2, "
                f"got shape {vertices.shape}."
            )
        if not np.isfinite(vertices).all():
            raise PatternError(f"Panel '{self.name}': every coordinate must be a finite number.")
        edges = tuple(self.edges)
        if len(edges) != len(vertices):
            raise PatternError(
                f"Panel '{self.name}': a closed loop has as many edges as vertices, "
                f"got {len(edges)} edges and {len(vertices)} vertices."
            )
        vertices.flags.writeable = False
        object.__setattr__(self, "vertices", vertices)
        object.__setattr__(self, "edges", edges)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Panel):
            return NotImplemented
        return (self.name, self.edges, self.placement, self.label) == (
            other.name,
            other.edges,
            other.placement,
            other.label,
        ) and np.array_equal(self.vertices, other.vertices)

    def __hash__(self) -> int:
        return self._hash

    @cached_property
    def _hash(self) -> int:
        return hash((self.name, self.edges, (self.vertices + 0.0).tobytes()))  # -0.0 equals 0.0

    def chord(self, edge: int) -> Floats:
        """Start and end (2, 2) of an edge, cm."""
        n = len(self.vertices)
        return self.vertices[[edge % n, (edge + 1) % n]]

    def edge_length(self, edge: int) -> float:
        """Arc length of an edge, cm."""
        return curves.length(self.edges[edge].curve, self.chord(edge))

    def sample_edge(self, edge: int, count: int) -> Floats:
        """Points (count, 2) on an edge, equally spaced by arc length, both ends included, cm."""
        return curves.sample_by_length(self.edges[edge].curve, self.chord(edge), count)

    def flatten_edge(self, edge: int, tolerance: float = 0.01) -> Floats:
        """Polyline (n, 2) within `tolerance` cm of an edge, both ends included."""
        return curves.flatten(self.edges[edge].curve, self.chord(edge), tolerance)

    def outline(self, tolerance: float = 0.01) -> Floats:
        """Closed polyline (n, 2) within `tolerance` cm of the loop; the first point is not repeated."""
        return np.concatenate([self.flatten_edge(k, tolerance)[:-1] for k in range(len(self.edges))])

    def signed_area(self) -> float:
        """Area in cm^2 enclosed by the loop, positive when it runs counter-clockwise."""
        return self._signed_area

    @cached_property
    def _signed_area(self) -> float:
        points = self.outline(0.001)
        x, y = (points - points.mean(axis=0)).T
        return float(x @ np.roll(y, -1) - np.roll(x, -1) @ y) / 2

    def perimeter(self) -> float:
        """Length of the whole loop, cm."""
        return sum(self.edge_length(k) for k in range(len(self.edges)))

    def bounding_box(self) -> Floats:
        """Tight local box [[min x, min y], [max x, max y]], cm."""
        boxes = np.array([curves.bounding_box(e.curve, self.chord(k)) for k, e in enumerate(self.edges)])
        return np.array([boxes[:, 0].min(axis=0), boxes[:, 1].max(axis=0)])

    def normal(self) -> Floats:
        """Unit vector (3,) out of the right side of the placed panel."""
        return self.placement.matrix()[:, 2] * (1.0 if self.signed_area() >= 0 else -1.0)

    def to_world(self, points: ArrayLike) -> Floats:
        """Carries local points (n, 2) cm to where the panel is placed (n, 3) cm."""
        return self.placement.apply(points)

    def reversed(self) -> Panel:
        """The same outline travelled the other way; edge k becomes edge n - 1 - k."""
        vertices = np.roll(self.vertices[::-1], 1, axis=0)
        edges = tuple(e.drawn_as(curves.reverse(e.curve)) for e in self.edges[::-1])
        return replace(self, vertices=vertices, edges=edges)

    def mirrored(self) -> Panel:
        """The outline reflected in the local y axis (x -> -x); edges keep their ids, the winding flips."""
        edges = tuple(e.drawn_as(curves.mirror(e.curve)) for e in self.edges)
        return replace(self, vertices=self.vertices * np.array([-1.0, 1.0]), edges=edges)


def _rotation(axis: int, angle: float) -> Floats:
    c, s = np.cos(angle), np.sin(angle)
    i, j = [(1, 2), (2, 0), (0, 1)][axis]
    matrix = np.eye(3)
    matrix[i, i], matrix[i, j], matrix[j, i], matrix[j, j] = c, -s, s, c
    return matrix


def _angles(matrix: Floats, reading: RotationReading) -> tuple[float, float, float]:
    """Angles about x, y and z in degrees of a rotation matrix; the third is 0 where it is not determined."""
    if reading == "extrinsic":  # (Rz Ry Rx)^T = Rx(-a) Ry(-b) Rz(-c)
        x, y, z = _angles(matrix.T, "intrinsic")
        return -x + 0.0, -y + 0.0, -z + 0.0
    across = float(np.hypot(matrix[0, 0], matrix[0, 1]))
    y = np.arctan2(matrix[0, 2], across)
    if across < 1e-9:
        x, z = np.arctan2(matrix[2, 1], matrix[1, 1]), 0.0
    else:
        x, z = np.arctan2(-matrix[1, 2], matrix[2, 2]), np.arctan2(-matrix[0, 1], matrix[0, 0])
    a, b, c = (round(float(np.rad2deg(angle)), 10) + 0.0 for angle in (x, y, z))
    return a, b, c
