"""Shapes of half of the neckline, from the shoulder at (0, 0) to the middle at (width / 2, -depth)."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

from swifttailor.programs.curved_edges import arc_from_points_angle, arc_from_three_points
from swifttailor.programs.edge_sequence import EdgeSequence
from swifttailor.programs.edge_shapes import from_verts
from swifttailor.programs.edges import ArcEdge, BezierEdge, Edge, close_enough


@dataclass(frozen=True)
class Neckline:
    """What the shapes are drawn from; each uses what it needs."""

    depth: float
    """From the top of the neck to the lowest point, cm."""
    width: float
    """Of the whole neckline, cm."""
    angle: float = 90.0
    """Of the corner of a trapezoid or of the arc, degrees."""
    flip: bool = False
    """Bends the curve to the other side."""
    x: float = 0.5
    """Along the neckline, where its control point is."""
    y: float = 0.3
    """How far beside it the control point is."""


def v_neck_half(neck: Neckline) -> EdgeSequence:
    """A straight line."""
    return EdgeSequence(Edge([0.0, 0.0], [neck.width / 2, -neck.depth]))


def square_neck_half(neck: Neckline) -> EdgeSequence:
    """Straight down, then across."""
    return from_verts([0.0, 0.0], [0.0, -neck.depth], [neck.width / 2, -neck.depth])


def trapezoid_neck_half(neck: Neckline) -> EdgeSequence:
    """Down at an angle, then across; a straight line where the angle leaves nothing to go across."""
    if close_enough(neck.angle, 180, 1.0) or close_enough(neck.angle, 0, 1.0):
        return v_neck_half(neck)
    angle = math.radians(neck.angle)
    bottom_x = -neck.depth * math.cos(angle) / math.sin(angle)
    if bottom_x > neck.width / 2:
        return v_neck_half(neck)
    return from_verts([0.0, 0.0], [bottom_x, -neck.depth], [neck.width / 2, -neck.depth])


def curvy_neck_half(neck: Neckline) -> EdgeSequence:
    """A wave."""
    sign = -1 if neck.flip else 1
    controls = [[0.4, sign * 0.3], [0.8, sign * -0.3]]
    return EdgeSequence(BezierEdge([0.0, 0.0], [neck.width / 2, -neck.depth], controls))


def circle_arc_neck_half(neck: Neckline) -> EdgeSequence:
    """An arc of a given angle."""
    end = [neck.width / 2, -neck.depth]
    return EdgeSequence(arc_from_points_angle([0.0, 0.0], end, math.radians(neck.angle), right=not neck.flip))


def circle_neck_half(neck: Neckline) -> EdgeSequence:
    """Half of the one arc through both shoulders and the lowest point."""
    return EdgeSequence(circle_neck_arc(neck.depth, neck.width))


def circle_neck_arc(depth: float, width: float) -> ArcEdge:
    """The arc of `circle_neck_half`."""
    whole = arc_from_three_points([0.0, 0.0], [width, 0.0], [width / 2, -depth])
    half = whole.subdivide_len([0.5, 0.5])[0]
    assert isinstance(half, ArcEdge), "half of an arc is an arc"
    return half


def bezier_2_neck_half(neck: Neckline) -> EdgeSequence:
    """A curve with one control point."""
    controls = [[neck.x, neck.y if neck.flip else -neck.y]]
    return EdgeSequence(BezierEdge([0.0, 0.0], [neck.width / 2, -neck.depth], controls))


NECKLINES: dict[str, Callable[[Neckline], EdgeSequence]] = {
    "CircleNeckHalf": circle_neck_half,
    "CurvyNeckHalf": curvy_neck_half,
    "VNeckHalf": v_neck_half,
    "SquareNeckHalf": square_neck_half,
    "TrapezoidNeckHalf": trapezoid_neck_half,
    "CircleArcNeckHalf": circle_arc_neck_half,
    "Bezier2NeckHalf": bezier_2_neck_half,
}
"""By the names that ``collar.f_collar`` and ``collar.b_collar`` accept."""
