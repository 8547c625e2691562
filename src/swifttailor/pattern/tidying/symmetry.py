"""How alike the two sides of a pattern are, and making them so where they nearly are.

A network writes numbers that are a few centimetres off, each side of the body anew: a neckline is deeper on
the left, a hem slants. Of nearly all garments the sides are cut alike, so what nearly is so
is made exactly so (`even_sides`).
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from swifttailor.arrays import Floats
from swifttailor.pattern.curve import Arc, Cubic, Curve, Line, Quadratic
from swifttailor.pattern.names import PANEL_NAMES, TWINS
from swifttailor.pattern.panel import Panel, Placement

OTHER_SIDE: dict[str, str] = {
    PANEL_NAMES[a]: PANEL_NAMES[b] for pair in TWINS.items() for a, b in (pair, (pair[1], pair[0]))
} | {
    f"{one}_collar_fall_{face}": f"{other}_collar_fall_{face}"
    for one, other in (("left", "right"), ("right", "left"))
    for face in ("front", "back")
}
"""Names of panels and of those on the other side of the body."""
LEAST_CURVATURE = 1e-6
"""Per cm: what is straighter is a line."""
_SAMPLES = 5
_FEW = 32
"""Edges that are looked at first, where a panel has many."""


@dataclass(frozen=True, eq=False)
class Reflection:
    """A panel as it lies on its own reflection."""

    shift: int
    """Edge e lies on edge ``(shift - 1 - e) % n``, corner k on corner ``(shift - k) % n``."""
    axis: float
    """Local x of the line of reflection, cm."""
    deviation: float
    """The farthest that a point of an edge is from that of its reflection, cm."""

    def edge(self, number: int, count: int) -> int:
        """The edge that one lies on."""
        return (self.shift - 1 - number) % count

    def image(self, panel: Panel) -> Panel:
        """The panel reflected, its edges numbered like those that they lie on."""
        count = len(panel.edges)
        # Of a reversed panel edge e is edge n - 1 - e, corner k is corner n - k.
        turned = panel.mirrored().reversed()
        order = [(k - self.shift) % count for k in range(count)]
        vertices = turned.vertices[order] + [2 * self.axis, 0.0]
        return replace(turned, vertices=vertices, edges=tuple(turned.edges[k] for k in order))


def reflected(panel: Panel, name: str) -> Panel:
    """The panel on the other side of the body, as GarmentCode makes it: edge e becomes edge n - 1 - e.

    Args:
        panel: On one side.
        name: Of the other.
    """
    return replace(panel.mirrored().reversed(), name=name, placement=_reflected(panel.placement))


def _reflected(placement: Placement) -> Placement:
    x, y, z = placement.translation
    a, b, c = placement.rotation
    return replace(placement, translation=(-x, y, z), rotation=(a, -b, -c))


def self_reflection(panel: Panel) -> Reflection | None:
    """How a panel is most like its own reflection in its y axis; None where kinds of edges differ."""
    count = len(panel.edges)
    names = [type(e.curve).__name__ for e in panel.edges]
    kinds = np.unique(names, return_inverse=True)[1]
    best: Reflection | None = None
    points = np.array([panel.sample_edge(k, _SAMPLES) for k in range(count)])
    few = slice(None, None, max(count // _FEW, 1))
    for shift in range(count):
        partners = (shift - 1 - np.arange(count)) % count
        if (kinds != kinds[partners]).any():
            continue
        others = points[partners][:, ::-1]
        axis = float((points[..., 0] + others[..., 0]).mean() / 2)
        deviation = _farthest(points[few], others[few], axis)
        if best is not None and deviation >= best.deviation:
            continue  # a few edges have told already that this is no better
        deviation = _farthest(points, others, axis)
        if best is None or deviation < best.deviation:
            best = Reflection(shift, axis, deviation)
    return best


def _farthest(points: Floats, others: Floats, axis: float) -> float:
    """How far points (n, k, 2) are at most from others reflected in a line, cm."""
    apart = others * [-1.0, 1.0] + [2 * axis, 0.0] - points
    return float(np.linalg.norm(apart, axis=-1).max())


def distance(one: Panel, other: Panel) -> float | None:
    """How far outlines are from each other at most, edge by edge, cm; None where kinds of edges differ."""
    if not same_kinds(one, other):
        return None
    gaps = [
        np.linalg.norm(one.sample_edge(k, _SAMPLES) - other.sample_edge(k, _SAMPLES), axis=1).max()
        for k in range(len(one.edges))
    ]
    return float(max(gaps))


def same_kinds(one: Panel, other: Panel) -> bool:
    """Whether two panels have edges of the same kinds in the same order."""
    return [type(e.curve) for e in one.edges] == [type(e.curve) for e in other.edges]


def between(one: Panel, other: Panel) -> Panel:
    """The panel half-way between two that have the same kinds of edges, named and placed like the first."""
    vertices = (one.vertices + other.vertices) / 2
    edges = tuple(a.drawn_as(_between(a.curve, b.curve)) for a, b in zip(one.edges, other.edges, strict=True))
    return replace(one, vertices=vertices, edges=edges)


def _between(one: Curve, other: Curve) -> Curve:
    if isinstance(one, Quadratic) and isinstance(other, Quadratic):
        return Quadratic(_mean(one.control, other.control))
    if isinstance(one, Cubic) and isinstance(other, Cubic):
        return Cubic(_mean(one.control_1, other.control_1), _mean(one.control_2, other.control_2))
    if isinstance(one, Arc) and isinstance(other, Arc):
        return one if one.large or other.large else _between_arcs(one, other)
    assert isinstance(one, Line)
    return one


def _mean(a: tuple[float, float], b: tuple[float, float]) -> tuple[float, float]:
    return (a[0] + b[0]) / 2, (a[1] + b[1]) / 2


def _between_arcs(one: Arc, other: Arc) -> Arc | Line:
    """Curvatures have a middle; radii of nearly straight arcs are anything."""
    if min(one.radius, other.radius) <= 0:
        return one
    curvature = sum((1 if arc.right else -1) / arc.radius for arc in (one, other)) / 2
    if abs(curvature) < LEAST_CURVATURE:
        return Line()
    return Arc(1 / abs(curvature), large=False, right=curvature > 0)
