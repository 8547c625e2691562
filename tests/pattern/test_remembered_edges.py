"""Lengths, samples and polylines of edges are remembered: nobody can tell, whatever was asked before."""

from __future__ import annotations

from dataclasses import replace
from types import MappingProxyType

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from pattern_strategies import panels, shaped_edges
from unchangeable import changeable

from swifttailor.pattern import Arc, Cubic, Line, Quadratic
from swifttailor.pattern import curve as curves

MEMOS = (curves._sampled, curves._flattened, curves._length_table)
LIMIT = 4096

signed_zeros = st.sampled_from([0.0, -0.0, 1.0, -1.0, 10.0])
points = st.tuples(signed_zeros, signed_zeros)
axis_chords = st.tuples(points, points).filter(lambda ends: ends[0] != ends[1]).map(np.array)
"""With ends on the axes, where the sign of zero decides from which side an angle is seen."""
axis_edges = st.tuples(
    st.one_of(
        st.just(Line()),
        st.builds(Quadratic, points),
        st.builds(Cubic, points, points),
        st.builds(Arc, st.sampled_from([0.5, 5.0, 10.0, 40.0]), st.booleans(), st.booleans()),
    ),
    axis_chords,
)


def forget():
    for memo in MEMOS:
        memo.cache_clear()


def measures(curve, chord):
    """All that is remembered of an edge, to the last bit but for the sign of zero in a Bezier's control."""
    found = [
        np.array(curves.length(curve, chord)),
        curves.sample_by_length(curve, chord, 7),
        curves.flatten(curve, chord, 0.01),
        curves.flatten(curve, chord, 0.2),
        curves.parameters_by_length(curve, chord, [0.0, 0.3, 1.0]),
    ]
    return [each.shape for each in found], [(each + 0.0).tobytes() for each in found]


@settings(max_examples=60)
@given(st.lists(st.one_of(shaped_edges(), axis_edges), min_size=1, max_size=5))
def test_an_edge_is_measured_as_if_for_the_first_time(edges):
    edges += [(curve, -1.0 * chord[::-1]) for curve, chord in edges]  # others, some of the same value
    edges += [(curve, np.where(chord == 0, -chord, chord)) for curve, chord in edges]
    fresh = []
    for edge in edges:
        forget()
        fresh.append(measures(*edge))
    forget()
    assert [measures(*edge) for edge in edges] == fresh
    assert [measures(*edge) for edge in edges[::-1]] == fresh[::-1]


@pytest.mark.parametrize("order", [1, -1])
def test_the_sign_of_zero_in_a_chord_is_told_apart(order):
    """The angle at which this arc begins is pi or -pi, and its points differ in the last digit."""
    arc, parameters = Arc(10.0, False, True), np.linspace(0.0, 1.0, 7)
    chords = [np.array([[-10.0, zero], [10.0, 0.0]]) for zero in (0.0, -0.0)][::order]
    expected = [curves.evaluate(arc, chord, parameters).tobytes() for chord in chords]
    assert expected[0] != expected[1]
    forget()
    assert [curves.sample_by_length(arc, chord, 7).tobytes() for chord in chords] == expected


@given(shaped_edges())
def test_nothing_that_is_handed_out_is_what_is_remembered(edge):
    curve, chord = edge
    expected = measures(curve, chord)
    for spoilt in (
        curves.sample_by_length(curve, chord, 7),
        curves.flatten(curve, chord, 0.01),
        curves.flatten(curve, chord, 0.2),
        curves.parameters_by_length(curve, chord, [0.0, 0.3, 1.0]),
    ):
        spoilt[:] = np.nan
    assert measures(curve, chord) == expected


@given(shaped_edges(["quadratic", "cubic"]))
def test_what_is_shared_inside_cannot_be_changed(edge):
    curve, chord = edge
    assert not changeable(curves._length_table(curve, chord.tobytes()))
    assert not changeable(curves.gauss_rule())
    with pytest.raises(ValueError, match="read-only"):
        curves.gauss_rule()[0][0] = 1.0


@given(shaped_edges())
def test_a_chord_may_be_changed_after_it_was_measured(edge):
    """By value, not by the array: whoever moves an end gets the moved edge."""
    curve, chord = edge
    moved = chord + np.array([[0.0, 0.0], [3.0, 1.0]])
    forget()
    expected = measures(curve, moved)
    own = chord.copy()
    measures(curve, own)
    own += np.array([[0.0, 0.0], [3.0, 1.0]])
    assert np.array_equal(own, moved) and measures(curve, own) == expected


@given(shaped_edges(["cubic"]))
def test_equal_edges_are_measured_once(edge):
    curve, chord = edge
    forget()
    measures(curve, chord)
    misses = [memo.cache_info().misses for memo in MEMOS]
    transposed = np.asfortranarray(chord)  # the same numbers in another order in memory
    measures(replace(curve), transposed)
    measures(Cubic(tuple(curve.control_1), tuple(curve.control_2)), chord.tolist())
    assert [memo.cache_info().misses for memo in MEMOS] == misses


@settings(max_examples=20)
@given(panels())
def test_panels_measure_their_edges_alike(panel):
    forget()
    fresh = [[panel.edge_length(k), panel.sample_edge(k, 5).tolist()] for k in range(len(panel.edges))]
    outline, area = panel.outline().tobytes(), panel.signed_area()
    panel.sample_edge(0, 5)[:] = np.nan
    panel.chord(0)[:] = np.nan
    panel.outline()[:] = np.nan
    again = replace(panel)
    assert [
        [again.edge_length(k), again.sample_edge(k, 5).tolist()] for k in range(len(panel.edges))
    ] == fresh
    assert (again.outline().tobytes(), again.signed_area()) == (outline, area)


def test_no_more_than_a_few_thousand_are_kept():
    forget()
    for k in range(LIMIT + 100):
        curves.sample_by_length(Line(), [[0.0, 0.0], [1.0 + k, 0.0]], 2)
    assert curves._sampled.cache_info().currsize == LIMIT
    assert all(memo.cache_info().maxsize == LIMIT for memo in MEMOS)
    forget()


@pytest.mark.parametrize(
    "value", [[1], {"a": 1}, np.zeros(2), (1, (np.zeros(2),)), MappingProxyType({1: [2]})], ids=repr
)
def test_the_walk_finds_what_can_be_changed(value):
    assert changeable(value)
