"""The learning rate over steps or over time."""

from __future__ import annotations

from itertools import pairwise

import pytest
from hypothesis import given
from hypothesis import strategies as st

from swifttailor.training.schedule import Schedule


def test_rises_then_falls_to_its_end():
    schedule = Schedule(1000, 10, 0.01)
    rates = [schedule.rate(k, 0.0) for k in range(1000)]
    assert rates[0] == pytest.approx(0.1, rel=1e-3)
    assert max(rates) == pytest.approx(1, abs=1e-3)
    assert rates.index(max(rates)) == 9
    assert all(b < a for a, b in pairwise(rates[9:]))
    assert rates[505] == pytest.approx(0.5, abs=0.02)
    assert rates[-1] == pytest.approx(0.01, abs=1e-3)


def test_time_ends_it_where_it_is_shorter():
    schedule = Schedule(1000, 0, 0.0, max_seconds=60)
    assert schedule.progress(10, 30.0) == 0.5
    assert schedule.rate(10, 30.0) == pytest.approx(0.5)
    assert schedule.progress(10, 61.0) == 1
    assert schedule.progress(900, 30.0) == 0.9


@given(st.integers(1, 10**6), st.integers(0, 10**6), st.floats(0, 1), st.integers(0, 1000), st.floats(0, 1e6))
def test_stays_between_nothing_and_all(steps, step, final, warmup, seconds):
    schedule = Schedule(steps, warmup, final, max_seconds=1e4)
    assert 0 <= schedule.rate(step, seconds) <= 1
    assert 0 <= schedule.progress(step, seconds) <= 1
