"""Pictures that are not the same twice."""

from __future__ import annotations

import numpy as np
import pytest

from swifttailor.training.picture_variation import vary_picture


@pytest.fixture
def picture():
    """A dark disk on light grey, which lies in the middle."""
    y, x = np.mgrid[:64, :64] - 31.5
    return np.repeat(np.where(np.hypot(x, y) < 16, 60, 225)[..., None], 3, axis=2).astype(np.uint8)


def disk(picture):
    """Its middle (row, column) and how many pixels it has."""
    inside = np.argwhere(picture.mean(axis=2) < 142)
    return inside.mean(axis=0), len(inside)


def test_what_is_shown_stays_there(picture):
    """The disk moves by 5 % of the side at most, and grows or shrinks by 10 %."""
    found = [disk(vary_picture(picture, np.random.default_rng(k))) for k in range(40)]
    middles, sizes = np.array([m for m, _ in found]), np.array([s for _, s in found])
    assert np.abs(middles - 31.5).max() < 0.05 * 64 * 1.1 + 0.5
    ratios = np.sqrt(sizes / disk(picture)[1])
    assert 0.87 < ratios.min() < 0.95 and 1.05 < ratios.max() < 1.13
    assert np.ptp(middles, axis=0).min() > 3


def test_light_and_dark_stay_light_and_dark(picture):
    """Contrast is kept to a fifth, and nothing is cut off that was not nearly white or black."""
    for seed in range(20):
        varied = vary_picture(picture, np.random.default_rng(seed)).astype(float)
        contrast = np.percentile(varied, 90) - np.percentile(varied, 2)
        assert contrast == pytest.approx(225 - 60, rel=0.35)
        assert np.percentile(varied, 90) > 180 and np.percentile(varied, 2) < 110


def test_it_is_another_picture_each_time_and_the_same_for_the_same_chance(picture):
    one, two, again = (vary_picture(picture, np.random.default_rng(k)) for k in (1, 2, 1))
    assert one.dtype == np.uint8 and one.shape == picture.shape
    assert np.array_equal(one, again) and not np.array_equal(one, two)
    colours = one[30:34, 30:34].mean(axis=(0, 1))
    assert 1 < np.ptp(colours) < 60


def test_no_strength_leaves_it_as_it_is(picture):
    assert vary_picture(picture, np.random.default_rng(0), 0.0) is picture
    near = vary_picture(picture, np.random.default_rng(0), 0.01)
    assert 0 < np.abs(near.astype(float) - picture).mean() < 1.5
