from __future__ import annotations

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st
from pattern_strategies import shaped_edges

from swifttailor.pattern import Arc, Cubic, Line, Quadratic
from swifttailor.pattern import curve as curves
from swifttailor.pattern.curve_sampling import EdgeSampler


def plain(edges, chords, counts):
    """Plain reference of `EdgeSampler.sample`: every edge on its own."""
    return np.concatenate(
        [
            curves.sample_by_length(c, chord, n + 1)[:-1]
            for c, chord, n in zip(edges, chords, counts, strict=True)
        ]
    )


@settings(max_examples=100, deadline=None)
@given(st.lists(st.tuples(shaped_edges(), st.integers(1, 40)), min_size=1, max_size=8))
def test_many_edges_at_once_are_as_each_alone(drawn):
    edges, chords = [e for (e, _), _ in drawn], np.array([c for (_, c), _ in drawn])
    counts = [n for _, n in drawn]
    sampler = EdgeSampler.of(edges, chords)
    lengths = np.array([curves.length(e, c) for e, c in zip(edges, chords, strict=True)])
    assert np.allclose(sampler.lengths, lengths, rtol=1e-9)
    points, expected = sampler.sample(counts), plain(edges, chords, counts)
    tolerance = np.repeat(np.maximum(lengths, 1.0) * 1e-7, counts)
    assert (np.abs(points - expected).max(axis=1) <= tolerance).all()
    assert np.array_equal(points[np.cumsum(counts) - counts], chords[:, 0])


def test_cusps_and_points_are_measured_as_exactly():
    chord = np.array([[0.0, 0.0], [10.0, 0.0]])
    edges = [
        Cubic((1.5, 1.0), (-0.5, 1.0)),  # a cusp
        Quadratic((1.5, 0.0)),  # runs past its end and back
        Cubic((0.0, 0.0), (1.0, 0.0)),  # at rest in both ends
        Line(),
        Arc(5.0, False, True),
        Quadratic((0.5, 0.3)),
    ]
    chords = np.array([chord] * len(edges))
    chords[3] = 3.0  # both ends in one point
    sampler = EdgeSampler.of(edges, chords)
    for edge, c, measured in zip(edges, chords, sampler.lengths, strict=True):
        assert np.isclose(measured, curves.length(edge, c), rtol=1e-9, atol=1e-12)
    counts = [17] * len(edges)
    assert np.allclose(sampler.sample(counts), plain(edges, chords, counts), atol=1e-5)


def test_no_edges_are_no_points():
    sampler = EdgeSampler.of([], np.zeros((0, 2, 2)))
    assert sampler.lengths.shape == (0,) and sampler.sample([]).shape == (0, 2)
