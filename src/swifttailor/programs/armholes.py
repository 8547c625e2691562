"""Shapes of the armhole, and of the sleeve's end that is sewn into it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from swifttailor.programs.curve_fits import curve_match_tangents
from swifttailor.programs.edge_sequence import EdgeSequence
from swifttailor.programs.edge_shapes import from_verts
from swifttailor.programs.edges import BezierEdge, to_vertex
from swifttailor.programs.planar_curves import CubicCurve


@dataclass(frozen=True)
class Armhole:
    """What the shapes are drawn from."""

    incl: float
    """How far the armhole reaches into the panel, cm."""
    width: float
    """How far it reaches down, cm."""
    smoothing: float = 0.2
    """Where an angular armhole has its corner, as a part of both."""


def armhole_square(hole: Armhole) -> EdgeSequence:
    """A right angle; for garments without sleeves."""
    return from_verts([0.0, 0.0], [hole.incl, 0.0], [hole.incl, hole.width])


def armhole_angle(hole: Armhole) -> EdgeSequence:
    """An obtuse angle; for garments without sleeves."""
    corner = [hole.incl * (1 - hole.smoothing), hole.smoothing * hole.width]
    return from_verts([0.0, 0.0], corner, [hole.incl, hole.width])


def armhole_curve(hole: Armhole) -> EdgeSequence:
    """The classic armhole, a cubic curve."""
    edge = BezierEdge([hole.incl, hole.width], [0.0, 0.0], [[0.5, 0.2], [0.8, 0.35]])
    return EdgeSequence(edge.reverse())


def sleeve_opening(hole: Armhole, angle: float, bottom_angle_mix: float = 0.0) -> EdgeSequence:
    """The end of half a sleeve, as long as the classic armhole.

    Args:
        hole: The armhole.
        angle: Of the arm below the horizontal, radians.
        bottom_angle_mix: How the opening arrives at the bottom: 0 along its own line, 1 upright, below 0
            towards the level.
    """
    armhole = armhole_curve(hole)[0]
    top = [hole.incl, hole.width]
    guess = BezierEdge(top, [hole.incl, hole.width - armhole.straight_length()], [[0.2, -0.35], [0.5, 0.2]])
    guess.rotate(-angle)
    chord = guess.chord()
    mix, other = bottom_angle_mix, -1j if bottom_angle_mix > 0 else -1 + 0j
    arrival = (1 - mix) * chord / abs(chord) + abs(mix) * other
    curve = guess.as_curve()
    assert isinstance(curve, CubicCurve), "the guess has two control points"
    opening = curve_match_tangents(curve, [0.0, -1.0], to_vertex(arrival), armhole.length())
    return EdgeSequence(opening.reverse())


ARMHOLES: dict[str, Callable[[Armhole], EdgeSequence]] = {
    "ArmholeSquare": armhole_square,
    "ArmholeAngle": armhole_angle,
    "ArmholeCurve": armhole_curve,
}
"""By the names that ``sleeve.armhole_shape`` accepts; all start from the side and end at the shoulder."""
