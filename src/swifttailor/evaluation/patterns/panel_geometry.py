"""Numbers of a panel as AIpparel's evaluation compares them."""

from __future__ import annotations

import numpy as np
from scipy.spatial.transform import Rotation

from swifttailor.arrays import Floats
from swifttailor.pattern import Cubic, Line, Panel, Quadratic
from swifttailor.pattern.curve import Curve, evaluate, to_relative


def edge_vectors(panel: Panel) -> Floats:
    """One row per edge: from its start to its end in cm, and its first control point relative to that.

    The control point of a line is its start. A quadratic is taken for the cubic of the same shape; an arc has
    the point in its middle.

    Returns:
        (n, 4)
    """
    rows = []
    for k, edge in enumerate(panel.edges):
        chord = panel.chord(k)
        rows.append([*(chord[1] - chord[0]), *_control(edge.curve, chord)])
    return np.array(rows, np.float64).reshape(-1, 4)


def loop_points(edges: Floats, count: int) -> Floats:
    """The points of a loop that are compared: start, then control point and end of each edge, centred.

    Args:
        edges: (n, 4) from `edge_vectors`.
        count: Edges of zero length follow until there are so many.

    Returns:
        (2 count + 1, 2) in cm, their mean at the origin. The first corner counts three times, and edges of
        zero length pull the mean to it; that is how AIpparel has it.
    """
    padded = np.zeros((count, 4))
    padded[: len(edges)] = edges
    points = [np.zeros(2)]
    for x, y, along, across in padded:
        start, chord = points[-1], np.array([x, y])
        points += [start + along * chord + across * np.array([-y, x]), start + chord]
    found = np.stack(points)
    return found - found.mean(axis=0)


def vertex_distance(a: Panel, b: Panel) -> float:
    """Mean distance of corresponding `loop_points`, cm; the loop of fewer edges is padded."""
    first, second = edge_vectors(a), edge_vectors(b)
    count = max(len(first), len(second))
    difference = loop_points(first, count) - loop_points(second, count)
    return float(np.linalg.norm(difference, axis=1).mean())


def vertex_extent(panel: Panel) -> float:
    """`vertex_distance` from a panel of no size, cm: what a missing panel costs."""
    edges = edge_vectors(panel)
    return float(np.linalg.norm(loop_points(edges, len(edges)), axis=1).mean())


def universal_translation(panel: Panel) -> Floats:
    """(3,) where the middle of that side of the box around a panel's corners is which is highest, cm.

    Of sides equally high the first counts, in the order upper, lower, right, left of the flat panel. So a
    panel that lies flat has no definite one: rounding decides (docs/evaluation.md).
    """
    (left, low), (right, high) = panel.vertices.min(axis=0), panel.vertices.max(axis=0)
    x, y = (left + right) / 2, (low + high) / 2
    middles = panel.to_world(np.array([[x, high], [x, low], [right, y], [left, y]]))
    return middles[int(np.argmax(middles[:, 1]))]


def translation_distance(a: Panel, b: Panel) -> float:
    """Distance of the universal translations, cm."""
    return float(np.linalg.norm(universal_translation(a) - universal_translation(b)))


def rotation_distance(a: Panel, b: Panel) -> float:
    """Distance of the unit quaternions of both placements, the nearer sign taken; from 0 to the root of 2."""
    p, q = (Rotation.from_matrix(panel.placement.matrix()).as_quat() for panel in (a, b))
    return float(min(np.linalg.norm(p - q), np.linalg.norm(p + q)))


def _control(curve: Curve, chord: Floats) -> tuple[float, float]:
    if isinstance(curve, Line):
        return 0.0, 0.0
    if isinstance(curve, Quadratic):
        x, y = curve.control
        return 2 / 3 * x, 2 / 3 * y
    if isinstance(curve, Cubic):
        return curve.control_1
    return to_relative(evaluate(curve, chord, 0.5)[0], chord)
