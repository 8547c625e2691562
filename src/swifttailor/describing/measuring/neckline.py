"""Necklines and armholes: depth, width and shape."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Literal

import numpy as np

from swifttailor.describing.facts import Armhole, ArmholeShape, NeckHalf, Neckline, NeckShape
from swifttailor.describing.measuring.anatomy import Anatomy, Border
from swifttailor.describing.measuring.chain import Line, edge_runs
from swifttailor.describing.measuring.parts import Face, Part, Side
from swifttailor.describing.measuring.shoulders import as_cut, sleeve_neck
from swifttailor.pattern import EdgeRef, Panel

_LEVEL_DEGREES = 22.0
"""What leaves the middle this flat is level there."""
_STRAIGHT_DEGREES = 30.0
"""A line that turns less in all looks straight."""
_SHALLOW_DEGREES = 12.0
_STEEP_DEGREES = 20.0
_UNDERARM_CM = 3.0
"""A back that ends so little above the armpits has no shoulders."""
_STRAIGHT_LEG = 0.985
"""Chord over length of a leg beside a corner that looks straight."""


def measure_neckline(anatomy: Anatomy, face: Face, shoulders: tuple[bool, bool]) -> Neckline | None:
    """Measures the neckline of one face; None where both shoulders are bare or there is no torso.

    Args:
        anatomy: The garment.
        face: Front or back.
        shoulders: Whether the left and the right shoulder are covered.
    """
    if not any(shoulders):
        return None
    halves: dict[str, NeckHalf] = {}
    edges = _neck_edges(anatomy)
    panels = anatomy.panels(Part.TORSO, face=face)
    if face == "back" and (below := below_strap(anatomy, panels)):
        return _bare_back(anatomy, below)
    for panel in panels:
        runs = edge_runs(panel, [r.edge for r in edges if r.panel == panel.name])
        if not runs:
            continue
        lines = [Line.along(panel, run) for run in runs]
        side = anatomy.parts[panel.name].side
        if side == "middle" and len(lines) == 1:
            for line in _halves(lines[0]):
                name = "left" if line.points[-1, 0] > line.points[0, 0] else "right"
                halves[name] = _measure_half(line)
        else:
            line = max(lines, key=lambda each: each.length)
            name: Side = "left" if line.points[:, 0].mean() > 0 else "right"
            halves[name] = _measure_half(_on_sleeve(anatomy, name, face, _outward(line)))
    left, right = (
        halves.get(s) if covered else None for s, covered in zip(("left", "right"), shoulders, strict=True)
    )
    return Neckline(left, right) if left or right else None


def below_strap(anatomy: Anatomy, panels: Sequence[Panel]) -> list[Panel]:
    """The back of a halter, above which there are but straps at the neck; nothing of other garments."""
    armpit = anatomy.figure.armpit_y
    highest = {p.name: float(p.to_world(p.vertices)[:, 1].max()) for p in panels}
    straps = [p for p in panels if p.to_world(p.vertices)[:, 1].min() > armpit]
    below = [p for p in panels if p not in straps]
    held = straps and all(highest[p.name] < armpit + _UNDERARM_CM for p in below)
    return below if held else []


def bare_back_edges(anatomy: Anatomy, panels: Sequence[Panel]) -> list[EdgeRef]:
    """The upper edges of a back that ends below the arms."""
    hem = {r for loop in anatomy.loops(Border.HEM) for r in loop.edges}
    names = {p.name for p in panels}
    return [r for r in anatomy.free_edges(Part.TORSO) if r.panel in names and r not in hem]


def _bare_back(anatomy: Anatomy, panels: Sequence[Panel]) -> Neckline | None:
    """What is bare above a back that ends below the arms, as deep as from the neck to its middle."""
    free = bare_back_edges(anatomy, panels)
    halves: dict[str, NeckHalf] = {}
    for panel in panels:
        runs = edge_runs(panel, [r.edge for r in free if r.panel == panel.name])
        if not runs:
            continue
        half = _measure_half(_outward(Line.along(panel, max(runs, key=len))))
        low = float(panel.to_world(panel.vertices)[:, 1].max()) - half.depth
        depth = anatomy.figure.neck_y - low
        halves["left" if anatomy.parts[panel.name].side == "left" else "right"] = replace(half, depth=depth)
    left, right = halves.get("left"), halves.get("right")
    return Neckline(left, right) if left and right else None


def _neck_edges(anatomy: Anatomy) -> set[EdgeRef]:
    """Edges of the torso that border the neckline or carry a collar or hood."""
    sewn = anatomy.seam(Part.TORSO, {Part.COLLAR, Part.HOOD}).own
    free = anatomy.top.edges if anatomy.top is not None else ()
    return {r for r in (*sewn, *free) if anatomy.part_of(r) is Part.TORSO}


def _outward(line: Line) -> Line:
    """The line from the middle of the body to the shoulder."""
    first, last = np.abs(line.points[[0, -1], 0])
    return line if first < last else line.turned_round()


def _on_sleeve(anatomy: Anatomy, side: Side, face: Face, line: Line) -> Line:
    """Half a neckline that may go on along the edge of a raglan sleeve, to its shoulder."""
    for ref in sleeve_neck(anatomy, side, face):
        more = Line.along(anatomy.pattern.panel(ref.panel), [ref.edge])
        flat = np.column_stack([more.points, np.zeros(len(more.points))])
        points = as_cut(anatomy, ref, flat)[:, :2]
        near = [float(np.hypot(*(end - line.points[-1]))) for end in points[[0, -1]]]
        points = points if near[0] < near[1] else points[::-1]
        line = Line(np.concatenate([line.points, points[1:]]), line.joints)
    return line


def _halves(line: Line) -> tuple[Line, Line]:
    """A neckline in one piece, cut where it is nearest the middle, each half led outward."""
    first, second = line.cut_at_middle()
    return first.turned_round(), second


def _measure_half(line: Line) -> NeckHalf:
    shoulder, low = line.points[-1], float(line.points[:, 1].min())
    if shoulder[0] < line.points[0, 0]:
        line = line.mirrored()
    width = float(abs(shoulder[0]))
    return NeckHalf(neck_shape(line), float(shoulder[1]) - low, width)


def neck_shape(line: Line) -> NeckShape:
    """The shape of half a neckline that runs from the middle to the shoulder, outward being +x."""
    corners = line.corners()
    if len(corners) == 1:
        return _cornered_shape(line, corners[0][0])
    if corners:
        return "other"
    left, right = line.turns()
    start = float(line.directions()[0])
    if left + right < _STRAIGHT_DEGREES:
        if line.chord_angle < _SHALLOW_DEGREES:
            return "straight"
        return "v" if line.chord_angle > _STEEP_DEGREES else "other"
    if min(left, right) > _STRAIGHT_DEGREES:
        return "s-curve"
    if right > _LEVEL_DEGREES:
        return "other"
    if abs(start) <= _LEVEL_DEGREES:
        return "round"
    return "pointed" if start > _STRAIGHT_DEGREES else "other"


def _cornered_shape(line: Line, corner: int) -> NeckShape:
    lower, upper = line.split(corner)
    for leg in (lower, upper):
        if float(np.hypot(*(leg.points[-1] - leg.points[0]))) < _STRAIGHT_LEG * leg.length:
            return "other"
    if abs(lower.chord_angle) > 15.0:
        return "other"
    if 76.0 <= upper.chord_angle <= 104.0:
        return "square"
    return "trapezoid" if 40.0 <= upper.chord_angle <= 130.0 else "other"


def measure_armhole(anatomy: Anatomy, side: Literal["left", "right"]) -> Armhole | None:
    """Measures the armhole of a side without sleeve, on its front panel; None where there is none."""
    border = {r for loop in anatomy.loops(Border.ARM) for r in loop.edges}
    for panel in anatomy.panels(Part.TORSO, side=side, face="front"):
        runs = edge_runs(panel, [r.edge for r in border if r.panel == panel.name])
        if not runs:
            continue
        line = Line.along(panel, max(runs, key=len))
        if line.points[0, 1] > line.points[-1, 1]:
            line = line.turned_round()
        depth = float(line.points[-1, 1] - line.points[0, 1])
        return Armhole(_armhole_shape(line), depth)
    return None


def _armhole_shape(line: Line) -> ArmholeShape:
    corners = line.corners()
    if not corners:
        return "round" if sum(line.turns()) > _STRAIGHT_DEGREES else "angled"
    if len(corners) > 1:
        return "other"
    at, turn = corners[0]
    for leg in line.split(at):
        if float(np.hypot(*(leg.points[-1] - leg.points[0]))) < _STRAIGHT_LEG * leg.length:
            return "other"
    return "square" if 70.0 <= abs(turn) <= 110.0 else "angled"
