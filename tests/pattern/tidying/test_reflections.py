"""The reflection that a panel is most like: what a few edges tell first, against looking at all of them."""

from __future__ import annotations

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st
from pattern_strategies import panels

from swifttailor.pattern import Line, Quadratic
from swifttailor.pattern.panel import Edge, Panel
from swifttailor.pattern.tidying.symmetry import self_reflection


def plain_reflection(panel):
    """Shift and deviation of the first best one, edge by edge."""
    count = len(panel.edges)
    points = np.array([panel.sample_edge(k, 5) for k in range(count)])
    best = None
    for shift in range(count):
        partners = [(shift - 1 - k) % count for k in range(count)]
        if any(type(panel.edges[k].curve) is not type(panel.edges[p].curve) for k, p in enumerate(partners)):
            continue
        others = points[partners][:, ::-1]
        axis = float((points[..., 0] + others[..., 0]).mean() / 2)
        gaps = others * [-1.0, 1.0] + [2 * axis, 0.0] - points
        deviation = max(float(np.linalg.norm(gap, axis=-1).max()) for gap in gaps)
        if best is None or deviation < best[1]:
            best = shift, deviation
    return best


def found(panel):
    reflection = self_reflection(panel)
    return None if reflection is None else (reflection.shift, reflection.deviation)


@settings(max_examples=40, deadline=None)
@given(panels())
def test_small_panels(panel):
    assert found(panel) == plain_reflection(panel)


@settings(max_examples=15, deadline=None)
@given(st.integers(33, 150), st.integers(0, 2**32 - 1), st.sampled_from([0.0, 0.01, 3.0]))
def test_panels_of_many_edges_that_are_nearly_alike_on_both_sides(count, seed, noise):
    rng = np.random.default_rng(seed)
    angle = np.linspace(0.0, 2 * np.pi, 2 * count, endpoint=False) + np.pi / (2 * count)
    radius = 20 + rng.uniform(0.0, 5.0, count)
    outline = np.concatenate([radius, radius[::-1]])[:, None] * np.stack([np.sin(angle), np.cos(angle)], 1)
    outline = np.roll(outline + rng.normal(0.0, noise, outline.shape), rng.integers(2 * count), axis=0)
    curves = [Line() if rng.random() < 0.7 else Quadratic((0.5, 0.1)) for _ in range(count)]
    edges = tuple(Edge(rng.choice(curves) if noise > 1 else Line()) for _ in range(2 * count))
    panel = Panel("panel", outline, edges)
    assert found(panel) == plain_reflection(panel)
    if noise < 1:
        assert found(panel)[1] < 0.1
