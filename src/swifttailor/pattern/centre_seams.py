"""Seams in the middle of front or back that nobody need sew: the cloth is folded there when it is cut."""

from __future__ import annotations

import numpy as np

from swifttailor.arrays import Floats
from swifttailor.pattern.curve import Line
from swifttailor.pattern.names import body_region
from swifttailor.pattern.panel import Panel
from swifttailor.pattern.pattern import Pattern, Stitch
from swifttailor.pattern.trims.names import CLOSES_FRONT

_UPRIGHT, _ASLANT = 0.02, 0.1
"""Sine of the largest angle between such a seam and the grain, and where cloth is folded a little askew."""
_EVEN_CM, _ASIDE_CM = 0.03, 4.0
_STRAIGHT_ON = 0.98
"""Cosine of the largest angle by which an edge that goes on turns."""
_BACK_ZIP = "back zip"


def foldable_sides(pattern: Pattern) -> tuple[bool, bool]:
    """Whether front and back may be folded: not what buttons or a zip close all the way down."""
    return not set(pattern.trims) & set(CLOSES_FRONT), _BACK_ZIP not in pattern.trims


def needless_centre_seams(pattern: Pattern, *, aslant: bool = False) -> frozenset[int]:
    """Indices of the stitches that vanish where the middle of front and back is cut on the fold.

    Args:
        pattern: Any pattern that can be sewn.
        aslant: Whether cloth may be folded a little off its grain, as of camisoles that widen to the hem.
    """
    front, back = foldable_sides(pattern)
    found = []
    for index, stitch in enumerate(pattern.stitches):
        if not all(pattern.has_edge(side) for side in stitch.sides):
            continue
        a, b = (pattern.panel(side.panel) for side in stitch.sides)
        if not (front if a.normal()[2] > 0 else back) or a.name == b.name:
            continue
        if is_centre_seam(pattern, stitch, aslant=aslant) and not _goes_on(a, stitch.first.edge):
            found.append(index)
    return frozenset(found)


def _goes_on(panel: Panel, edge: int) -> bool:
    """Whether an edge goes on straight ahead at one of its ends, as one with a slit below it does."""
    start, end = panel.chord(edge)
    along = (end - start) / max(float(np.hypot(*(end - start))), 1e-9)
    count = len(panel.edges)
    for other in ((edge - 1) % count, (edge + 1) % count):
        first, last = panel.chord(other)
        ahead = (last - first) / max(float(np.hypot(*(last - first))), 1e-9)
        if float(ahead @ along) > _STRAIGHT_ON:
            return True
    return False


def is_centre_seam(pattern: Pattern, stitch: Stitch, *, aslant: bool = False) -> bool:
    """Whether a stitch joins two panels that are each other's mirror image at it.

    It is straight, runs along the grain in the middle of the body, and is all that joins them.

    Args:
        pattern: Any pattern that can be sewn.
        stitch: One of its stitches, between two panels of it.
        aslant: Whether it may run a little off the grain.
    """
    first, second = stitch.sides
    a, b = pattern.panel(first.panel), pattern.panel(second.panel)
    if stitch.right_wrong or body_region(a.name, a.label) != body_region(b.name, b.label):
        return False
    between = [s for s in pattern.stitches if {x.panel for x in s.sides} == {a.name, b.name}]
    curves = a.edges[first.edge].curve, b.edges[second.edge].curve
    if len(between) != 1 or not all(isinstance(curve, Line) for curve in curves):
        return False
    if a.signed_area() * b.signed_area() <= 0 or a.normal() @ b.normal() < 0.9:
        return False
    start, end = a.chord(first.edge)
    along = (end - start) / max(float(np.hypot(*(end - start))), 1e-9)
    if (
        abs(along[0]) > (_ASLANT if aslant else _UPRIGHT)
        or abs(pattern.edge_length(first) - pattern.edge_length(second)) > _EVEN_CM
    ):
        return False
    middle = a.to_world(a.chord(first.edge))[:, 0]
    if np.abs(middle).max() > (_ASIDE_CM if aslant else 1.0):  # elsewhere than in the middle of the body
        return False
    mirrored = _mirrored(a, first.edge)
    moved = _moved(b, second.edge, a, first.edge)
    return len(mirrored) == len(moved) and bool(np.abs(mirrored - moved).max() <= _EVEN_CM)


def _mirrored(a: Panel, edge: int) -> Floats:
    """Points of a panel's other edges, mirrored at one edge, in the order of the mirror image."""
    start, end = a.chord(edge)
    along = (end - start) / float(np.hypot(*(end - start)))
    count = len(a.edges)
    points = np.concatenate([a.sample_edge((edge + 1 + k) % count, 5)[:-1] for k in range(count - 1)])
    points = np.concatenate([points, start[None]])[::-1] - start
    return start + 2 * (points @ along)[:, None] * along - points


def _moved(b: Panel, own: int, a: Panel, edge: int) -> Floats:
    """Points of the other panel's other edges, laid against the first."""
    count = len(b.edges)
    points = np.concatenate([b.sample_edge((own + 1 + k) % count, 5)[:-1] for k in range(count - 1)])
    return laid_on(np.concatenate([points, b.chord(own)[:1]]), b.chord(own), a.chord(edge))


def laid_on(points: Floats, own: Floats, other: Floats) -> Floats:
    """Moves points so that a chord comes to lie on another, end to start.

    Args:
        points: (n, 2) cm.
        own: (2, 2) ends of a chord of theirs.
        other: (2, 2) ends of the one to lie on.
    """
    u, v = own[1] - own[0], other[0] - other[1]
    cosine, sine = float(u @ v), float(u[0] * v[1] - u[1] * v[0])
    turn = np.array([[cosine, -sine], [sine, cosine]]) / max(float(np.hypot(cosine, sine)), 1e-12)
    return (points - own[0]) @ turn.T + other[1]
