"""Edges as exact SVG path commands, in millimetres with y down."""

from __future__ import annotations

import numpy as np

from swifttailor.arrays import Floats
from swifttailor.pattern.curve import Arc, Curve, Line, arc_geometry, control_polygon
from swifttailor.pattern.panel import Panel

MM_PER_CM = 10.0


def edge_path(panel: Panel, edge: int) -> str:
    """The path of one edge: a move to its start and one command to its end."""
    return f"M{_point(panel.chord(edge)[0])}{_command(panel.edges[edge].curve, panel.chord(edge))}"


def outline_path(panel: Panel) -> str:
    """The closed path of the whole panel."""
    commands = (_command(e.curve, panel.chord(k)) for k, e in enumerate(panel.edges))
    return f"M{_point(panel.vertices[0])}{''.join(commands)}Z"


def _command(curve: Curve, chord: Floats) -> str:
    if isinstance(curve, Line):
        return f"L{_point(chord[1])}"
    if isinstance(curve, Arc):
        if not np.any(chord[1] - chord[0]):
            return f"L{_point(chord[1])}"
        # Turning y over turns the sense of rotation over; a radius too small for the chord is raised to
        # half of it, as SVG itself would do.
        radius = number(arc_geometry(curve, chord).radius * MM_PER_CM)
        return f"A{radius} {radius} 0 {int(curve.large)} {int(not curve.right)} {_point(chord[1])}"
    letter = {3: "Q", 4: "C"}
    points = control_polygon(curve, chord)
    return letter[len(points)] + " ".join(_point(p) for p in points[1:])


def _point(point: Floats) -> str:
    return f"{number(point[0] * MM_PER_CM)},{number(-point[1] * MM_PER_CM)}"


def number(value: float) -> str:
    """A number with all its digits and no superfluous ones: ``3`` rather than ``3.0``, never ``-0``."""
    text = repr(float(value) + 0.0)
    return text.removesuffix(".0")
