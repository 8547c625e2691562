import numpy as np
import pytest
from grid_reference import warp as plain_warp
from hypothesis import given, settings
from hypothesis import strategies as st

from swifttailor.ggi.warping import warp

places = st.lists(st.floats(0, 1), min_size=1, max_size=25).map(sorted)
even = st.integers(2, 40).map(lambda n: np.linspace(0, 1, n).tolist())
crowded = st.integers(2, 40).map(lambda n: (np.linspace(0, 1, n) ** 3).tolist())
sides = st.one_of(places, even, crowded)


def total(first, second, pairs):
    return sum(abs(first[i] - second[j]) for i, j in pairs)


@settings(max_examples=150, deadline=None)
@given(st.lists(st.tuples(sides, sides), min_size=1, max_size=5))
def test_pairs_are_as_good_as_the_best_there_are(seams):
    rows = [row for pair in seams for row in pair]
    start = np.cumsum([0, *map(len, rows)])
    pairs = warp(np.concatenate(rows), start)
    for k, (first, second) in enumerate(seams):
        own = pairs[(pairs[:, 0] >= start[2 * k]) & (pairs[:, 0] < start[2 * k + 1])]
        own = own - [start[2 * k], start[2 * k + 1]]
        assert own[0].tolist() == [0, 0]
        assert own[-1].tolist() == [len(first) - 1, len(second) - 1]
        steps = np.diff(own, axis=0)
        assert (steps >= 0).all() and (steps.max(axis=1, initial=1) == 1).all()
        assert total(first, second, own) == pytest.approx(
            total(first, second, plain_warp(first, second)), abs=1e-6
        )


@given(even, even)
def test_no_place_links_two_that_have_partners_of_their_own(first, second):
    """Else the pairs would hang together, and a whole seam become one vertex."""
    pairs = warp(np.array(first + second), np.array([0, len(first), len(first) + len(second)]))
    one, other = np.bincount(pairs[:, 0]), np.bincount(pairs[:, 1])
    assert not ((one[pairs[:, 0]] > 1) & (other[pairs[:, 1]] > 1)).any()


def test_equal_sides_are_paired_one_to_one():
    row = np.linspace(0, 1, 9) ** 2
    pairs = warp(np.concatenate([row, row]), np.array([0, 9, 18]))
    assert pairs.tolist() == [[k, 9 + k] for k in range(9)]


def test_a_gather_is_spread_evenly():
    pairs = warp(np.concatenate([np.linspace(0, 1, 4), np.linspace(0, 1, 40)]), np.array([0, 4, 44]))
    assert np.bincount(pairs[:, 0]).max() <= 14
    assert sorted(pairs[:, 1].tolist()) == list(range(4, 44))


def test_empty_sides_have_no_pairs():
    assert warp(np.zeros(0), np.array([0])).shape == (0, 2)
    pairs = warp(np.array([0.0, 1.0, 0.5, 0.2, 0.3]), np.array([0, 2, 2, 3, 5]))
    assert pairs.tolist() == [[2, 3], [2, 4]]
