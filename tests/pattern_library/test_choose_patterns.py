"""Choosing patterns for coverage."""

from __future__ import annotations

from itertools import combinations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from swifttailor.pattern_library.choose import choose, stands_for, usefulness
from swifttailor.pattern_library.nearest import Weights, log_likelihoods
from swifttailor.pattern_library.sought import Sought


def plain_choice(use, groups, count):
    """Without a heap: every gain is taken anew each time."""
    covered, taken = np.zeros(len(use), np.float32), []
    while len(taken) < count:
        for group in sorted(set(groups)):
            left = [k for k in np.flatnonzero(groups == group) if k not in taken]
            if left and len(taken) < count:
                gains = [np.maximum(use[:, k] - covered, 0).sum() for k in left]
                taken.append(int(left[int(np.argmax(gains))]))
                covered = np.maximum(covered, use[:, taken[-1]])
    return taken


@given(st.integers(0, 2**31), st.integers(1, 12))
@settings(max_examples=30)
def test_the_lazy_choice_is_the_plain_one(seed, count):
    chance = np.random.default_rng(seed)
    use = chance.random((15, 12)).astype(np.float32)
    groups = chance.integers(0, 3, 12)
    taken, plain = choose(use, groups, count), plain_choice(use, groups, count)
    assert len(taken) == len(set(taken)) == count
    covered, expected = (use[:, chosen].max(axis=1).sum() for chosen in (taken, plain))
    assert covered == pytest.approx(expected, rel=1e-5)


@given(st.integers(0, 2**31))
@settings(max_examples=20)
def test_the_choice_is_nearly_the_best(seed):
    use = np.random.default_rng(seed).random((10, 9)).astype(np.float32)
    taken = choose(use, np.zeros(9, int), 3)
    best = max(use[:, list(some)].max(axis=1).sum() for some in combinations(range(9), 3))
    assert use[:, taken].max(axis=1).sum() >= (1 - 1 / np.e) * best


def test_groups_take_turns():
    use = np.random.default_rng(1).random((20, 30)).astype(np.float32)
    groups = (np.arange(30) < 5).astype(int)
    taken = choose(use, groups, 16)
    assert np.bincount(groups[taken[:10]]).tolist() == [5, 5]
    assert np.bincount(groups[taken]).tolist() == [11, 5]


def test_patterns_serve_who_wants_one_like_them(library):
    weights = Weights()
    use = usefulness(library.table, [0, 3, 5], weights)
    assert use.shape == (3, len(library))
    for row, k in enumerate((0, 3, 5)):
        assert use[row, k] == 0  # none serves who wants itself
        assert use[row].max() == 1
        fits = log_likelihoods(library.table, Sought.of_truth(library.table[k]), weights)
        order = np.argsort(-fits)
        assert np.argsort(-use[row], kind="stable")[0] == order[order != k][0]
    assert 0 <= use.min() <= use.max() <= 1


def test_patterns_stand_for_those_who_want_them():
    use = np.array([[0.9, 0.1, 0.5], [0.2, 0.1, 0.5], [0.8, 0.1, 0.3]], np.float32)
    assert stands_for(use, [0, 2]).tolist() == [2, 1]
