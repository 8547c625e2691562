"""Recutting necklines: deeper, shallower, or of another shape."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Literal

import numpy as np

from swifttailor.arrays import Floats
from swifttailor.pattern import Arc, Cubic, EdgeRef, Line, Pattern
from swifttailor.pattern.curve import to_relative
from swifttailor.recutting.table.workbench import Workbench
from swifttailor.recutting.ways.ends import End, find_ends

NewShape = Literal["round", "v", "square", "trapezoid", "s-curve", "pointed"]

SHALLOWEST_CM = 3.0
_CURVES: dict[NewShape, tuple[tuple[float, float], tuple[float, float]]] = {
    # Two thirds of the way to the corner from either end is close to a quarter of an ellipse.
    "round": ((0.6, 0.0), (1.0, 0.4)),
    "s-curve": ((0.8, 0.05), (0.4, 0.95)),
    "pointed": ((0.6, 0.35), (1.0, 0.6)),
}
"""Control points from the middle to the shoulder, as parts of the way across and of the way up."""


def recut_neckline(
    pattern: Pattern,
    edges: Sequence[EdgeRef],
    distance: float,
    shape: NewShape | None,
    side: Literal["left", "right"] | None = None,
) -> Pattern | None:
    """Cuts a neckline deeper or shallower, and to another shape.

    Args:
        pattern: Any pattern.
        edges: The free edges of the neckline of one face.
        distance: How much lower its middle lies afterwards, cm; negative raises it.
        shape: Of the cut; as it is when None.
        side: The wearer's, where only that half gets another shape.

    Returns:
        The recut pattern; None where the neckline is not cut in two halves that meet at a straight seam.
    """
    bench = Workbench(pattern)
    halves = neckline_halves(bench, pattern, edges)
    if not halves:
        return None
    for end, seam in halves:
        x = float(bench.pieces[end.panel].panel.to_world(bench.run_chord(end.run))[:, 0].mean())
        own = shape if side is None or (x > 0) == (side == "left") else None
        if not _recut_half(bench, end, seam, distance, own):
            return None
    return bench.pattern()


def neckline_halves(bench: Workbench, pattern: Pattern, edges: Sequence[EdgeRef]) -> list[tuple[End, int]]:
    """Two halves of a neckline, each with its side of the straight centre seam; none where it has no such."""
    ends = find_ends(bench, pattern, edges)
    if len(ends) != 2 or len({e.panel for e in ends}) != 2:
        return []
    if any(bench.partner(s) is not None for e in ends for s in e.run):
        return []
    middles = {_middle(bench, e) for e in ends}
    centre = [
        e.before if which == "before" else e.after for e, which in ((e, _middle(bench, e)) for e in ends)
    ]
    if middles != {"before", "after"} or bench.partner(centre[0]) != centre[1]:
        return []
    if not all(isinstance(bench.side(c).edge.curve, Line) for c in centre):
        return []
    return list(zip(ends, centre, strict=True))


def _middle(bench: Workbench, end: End) -> str:
    """Whether the middle of the body is at the beginning or at the end of a run."""
    piece = bench.pieces[end.panel]
    x = np.abs(piece.panel.to_world(bench.run_chord(end.run))[:, 0])
    return "before" if x[0] < x[1] else "after"


def _recut_half(bench: Workbench, end: End, seam: int, distance: float, shape: NewShape | None) -> bool:
    piece = bench.pieces[end.panel]
    at_start = seam == end.before
    chord = piece.chord(seam)
    middle, far = (chord[1], chord[0]) if at_start else (chord[0], chord[1])
    down = (far - middle) / max(float(np.hypot(*(far - middle))), 1e-9)
    old = bench.run_chord(end.run)
    shoulder = old[1] if at_start else old[0]
    depth = float((middle - shoulder) @ down)
    if depth + distance < SHALLOWEST_CM or distance > float(np.hypot(*(far - middle))) - 4.0:
        return False
    new_middle = middle + distance * down
    if shape is None and distance == 0.0:
        return True
    if shape is None:
        return _stretch(bench, end, shoulder, down, (depth + distance) / depth)
    for id in end.run[1:]:
        bench.drop(id)
    bench.side(end.run[0]).start = new_middle if at_start else shoulder
    if not at_start:
        bench.side(bench.neighbour(end.run[0], 1)).start = new_middle
    side = bench.side(end.run[0])
    start, finish = (new_middle, shoulder) if at_start else (shoulder, new_middle)
    across = (shoulder - middle) - ((shoulder - middle) @ down) * down
    corner = new_middle + (0.6 if shape == "trapezoid" else 1.0) * across
    if shape == "v":
        side.edge = replace(side.edge, curve=Line())
    elif shape in _CURVES:
        up = shoulder - corner
        towards = [new_middle + a * across + b * up for a, b in _CURVES[shape]]
        ends = np.array([start, finish])
        controls = [to_relative(t, ends) for t in (towards if at_start else towards[::-1])]
        side.edge = replace(side.edge, curve=Cubic(controls[0], controls[1]))
    else:
        side.edge = replace(side.edge, curve=Line())
        upright = bench.insert_line(bench.neighbour(end.run[0], 1), corner)
        bench.relabel(upright, side.edge.label)
    return True


def _stretch(bench: Workbench, end: End, shoulder: Floats, down: Floats, factor: float) -> bool:
    """Stretches a run downward from the shoulder; arcs in one piece become arcs through the new middle."""
    old = bench.run_chord(end.run)

    def move(points: Floats) -> Floats:
        fall = (points - shoulder) @ down
        return points + np.outer(fall * (factor - 1.0), down)

    if len(end.run) == 1 and isinstance(bench.side(end.run[0]).edge.curve, Arc):
        bench.map_run(end.run, old, move(old))
        return True
    following = bench.neighbour(end.run[-1], 1)
    return bench.map_points(end.panel, move, {*end.run, following})
