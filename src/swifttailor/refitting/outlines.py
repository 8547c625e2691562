"""New edges of a panel through the places where the points of the old ones went."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from swifttailor.arrays import Floats
from swifttailor.pattern import Panel
from swifttailor.pattern.curve import (
    Arc,
    Cubic,
    Curve,
    Line,
    Quadratic,
    control_polygon,
    parameters_by_length,
    scale,
    to_relative,
)

_FLATTEST_CM = 1e-3
"""Arcs that rise less over their chord are lines."""


def moved_panel(panel: Panel, traces: list[Floats]) -> Panel:
    """The panel whose edges run along given points: the same kinds of edges, of the same labels.

    Args:
        panel: Before.
        traces: Of each edge (n, 2) where points at equal steps along it went, both corners included, cm.
    """
    vertices = np.array([trace[0] for trace in traces])
    edges = []
    for k, (edge, trace) in enumerate(zip(panel.edges, traces, strict=True)):
        chord = np.array([vertices[k], vertices[(k + 1) % len(vertices)]])
        edges.append(replace(edge, curve=_fitted(edge.curve, panel.chord(k), chord, trace)))
    return replace(panel, vertices=vertices, edges=tuple(edges))


def _fitted(curve: Curve, before: Floats, chord: Floats, trace: Floats) -> Curve:
    """The curve of the same kind over a new chord that runs nearest to a trace."""
    if isinstance(curve, Line):
        return curve
    if isinstance(curve, Arc):
        return _fitted_arc(curve, before, chord, trace)
    inner = 1 if isinstance(curve, Quadratic) else 2
    if len(trace) - 2 < 2 * inner:  # too few points to tell a shape
        return curve
    t = parameters_by_length(curve, before, np.linspace(0.0, 1.0, len(trace)))[:, None]
    # From the old control points, so that what the points do not tell stays as it was.
    old = control_polygon(curve, before)
    basis = _bernstein(t, inner + 1)
    guess = chord[0] + _turned(old[1:-1] - old[0], before, chord)
    rest = trace - basis[:, :1] * chord[0] - basis[:, -1:] * chord[1] - basis[:, 1:-1] @ guess
    change, *_ = np.linalg.lstsq(basis[:, 1:-1], rest, rcond=None)
    points = [to_relative(point, chord) for point in guess + change]
    return Quadratic(points[0]) if inner == 1 else Cubic(points[0], points[1])


def _turned(offsets: Floats, before: Floats, chord: Floats) -> Floats:
    """Offsets (n, 2) from the old chord's start, as they lie from the new one's."""
    a, b = before[1] - before[0], chord[1] - chord[0]
    factor = complex(*b) / complex(*a)
    turned = (offsets[:, 0] + 1j * offsets[:, 1]) * factor
    return np.stack([turned.real, turned.imag], axis=1)


def _bernstein(t: Floats, degree: int) -> Floats:
    from math import comb

    return np.concatenate(
        [comb(degree, k) * t**k * (1 - t) ** (degree - k) for k in range(degree + 1)], axis=1
    )


def _fitted_arc(curve: Arc, before: Floats, chord: Floats, trace: Floats) -> Curve:
    long, old = (float(np.linalg.norm(c[1] - c[0])) for c in (chord, before))
    if curve.large or len(trace) < 4:
        return scale(curve, long / old)
    across = chord[1] - chord[0]
    rises = ((trace - chord[0]) @ [-across[1], across[0]]) / long
    rise = float(rises[np.abs(rises).argmax()])
    if abs(rise) < _FLATTEST_CM:
        return Line()
    rise = float(np.clip(rise, -0.499 * long, 0.499 * long))
    return Arc((long**2 / 4 + rise**2) / (2 * abs(rise)), large=False, right=rise < 0)
