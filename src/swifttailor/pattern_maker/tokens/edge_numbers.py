"""The shape of an edge as points, all of which are read in the same frame.

GarmentCode stores control points relative to the chord, and arcs by radius and two flags. The network
predicts points in cm from the panel's first vertex instead (AIpparel): control points, and the middle of an
arc.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from swifttailor.pattern.curve import (
    Arc,
    Cubic,
    Curve,
    Line,
    Quadratic,
    control_polygon,
    evaluate,
    to_relative,
)
from swifttailor.pattern_maker.tokens.normalization import normalize_points, points_in_cm
from swifttailor.pattern_maker.tokens.vocabulary import CONTROL_1, CONTROL_2, END, MID, NUMBERS, curve_type

FLATTEST_ARC = 1e-5
"""Height over chord below which an arc is taken for a line; 1 mm over 100 m. AIpparel's."""
LARGEST_RADIUS = 1e6
"""In cm. An arc of a larger one is taken for a line."""
FARTHEST_POINT = 1e6
"""In chords. A curve that goes farther is taken for a line: so short a chord has no direction to speak of."""


def edge_numbers(curve: Curve, chord: NDArray[np.float64], closing: bool) -> NDArray[np.float32]:
    """The row of numbers of an edge.

    Args:
        curve: Its shape.
        chord: (2, 2) its ends, cm from the panel's first vertex.
        closing: Whether it ends there, and its end is not written.

    Returns:
        (8,) normalised.
    """
    row = np.zeros(NUMBERS, np.float32)
    if not closing:
        row[END] = normalize_points(chord[1])
    if isinstance(curve, Arc):
        row[MID] = normalize_points(evaluate(curve, chord, [0.5])[0])
    elif not isinstance(curve, Line):
        inner = normalize_points(control_polygon(curve, chord)[1:-1])
        row[CONTROL_1] = inner[0]
        if isinstance(curve, Cubic):
            row[CONTROL_2] = inner[1]
    return row


def edge_curve(command: int, row: NDArray[np.float32], chord: NDArray[np.float64]) -> Curve:
    """The shape of an edge from its numbers: the inverse of `edge_numbers`.

    Args:
        command: Of the edge.
        row: (8,) normalised.
        chord: (2, 2) its ends, cm from the panel's first vertex.
    """
    kind = curve_type(command)
    if kind is Line:
        return Line()
    points = [points_in_cm(row[slot]) for slot in ((MID,) if kind is Arc else (CONTROL_1, CONTROL_2))]
    if math.dist(*chord) * FARTHEST_POINT <= max(math.dist(chord[0], p) for p in points):
        return Line()
    relative = [to_relative(p, chord) for p in points]
    if kind is Arc:
        return _arc_through(relative[0], math.dist(*chord))
    return Quadratic(relative[0]) if kind is Quadratic else Cubic(relative[0], relative[1])


def _arc_through(point: tuple[float, float], length: float) -> Arc | Line:
    """The arc over a chord of that length which passes a point relative to the chord."""
    x, y = point
    if abs(y) < FLATTEST_ARC:
        return Line()
    # In units of the chord, from its middle: the centre of the circle is at (0, height).
    height = ((x - 0.5) ** 2 + y * y - 0.25) / (2 * y)
    radius = math.hypot(0.5, height) * length
    if radius > LARGEST_RADIUS:
        return Line()
    # Of half a circle, rounding alone would decide which half is the larger.
    return Arc(radius, large=height * y > 1e-6, right=y < 0)
