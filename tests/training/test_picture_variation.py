"""Pictures that are not the same twice."""

from __future__ import annotations

import numpy as np
import pytest

from swifttailor.training.picture_variation import vary_picture


@pytest.fixture
def picture():
    """A dark disk on white, which lies in the middle."""
    y, x = np.mgrid[:64, :64] - 31.5
    return np.repeat(np.where(np.hypot(x, y) < 16, -0.6, 0.9)[None], 3, axis=0).astype(np.float32)


def disk(picture):
    """Its middle (row, column) and how many pixels it has."""
    inside = np.argwhere(picture.mean(axis=0) < 0.15)
    return inside.mean(axis=0), len(inside)


def test_what_is_shown_stays_there(picture):
    """The disk moves by 5 % of the side at most, and grows or shrinks by 10 %."""
    found = [disk(vary_picture(picture, np.random.default_rng(k))) for k in range(40)]
    middles, sizes = np.array([m for m, _ in found]), np.array([s for _, s in found])
    assert np.abs(middles - 31.5).max() < 0.05 * 64 * 1.1 + 0.5
    ratios = np.sqrt(sizes / disk(picture)[1])
    assert 0.87 < ratios.min() < 0.95 and 1.05 < ratios.max() < 1.13
    assert np.ptp(middles, axis=0).min() > 3


def test_it_is_another_picture_each_time_and_the_same_for_the_same_chance(picture):
    one, two, again = (vary_picture(picture, np.random.default_rng(k)) for k in (1, 2, 1))
    assert one.dtype == np.float32 and one.shape == picture.shape
    assert np.array_equal(one, again) and not np.array_equal(one, two)
    assert np.abs(one).max() <= 1
    colours = one[:, 30:34, 30:34].mean(axis=(1, 2))
    assert 0.02 < np.ptp(colours) < 0.6


def test_no_strength_leaves_it_as_it_is(picture):
    assert vary_picture(picture, np.random.default_rng(0), 0.0) is picture
    near = vary_picture(picture, np.random.default_rng(0), 0.01)
    assert 0 < np.abs(near - picture).mean() < 0.01
