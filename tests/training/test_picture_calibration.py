"""Certainties that are as sure as they are right."""

from __future__ import annotations

import numpy as np
import pytest

from swifttailor.picture_reader.labels import statement_labels
from swifttailor.picture_reader.truth import FALSE, TRUE, UNCLEAR
from swifttailor.training.picture_calibration import calibration_error, fit_scales


def drawn(slope, offset, count=4000):
    """Logits that say too much, and what is true by a line from them."""
    chance = np.random.default_rng(0)
    logits = chance.normal(scale=4.0, size=(count, len(statement_labels())))
    right = chance.random(logits.shape) < 1 / (1 + np.exp(-(slope * logits + offset)))
    judged = np.where(right, TRUE, FALSE)
    judged[chance.random(logits.shape) < 0.1] = UNCLEAR
    return logits, judged


@pytest.mark.parametrize(("slope", "offset"), [(0.5, -0.7), (1.0, 0.0), (1.6, 0.4)])
def test_the_line_is_found_again(slope, offset):
    logits, judged = drawn(slope, offset)
    scales = fit_scales(logits, judged)
    assert scales.shape == (len(statement_labels()), 2)
    np.testing.assert_allclose(scales[:, 0], slope, atol=0.12)
    np.testing.assert_allclose(scales[:, 1], offset, atol=0.2)
    clear = judged != UNCLEAR
    before, after = (1 / (1 + np.exp(-(logits * a + b))) for a, b in ((1.0, 0.0), (slope, offset)))
    fitted = 1 / (1 + np.exp(-(logits * scales[:, 0] + scales[:, 1])))
    true = judged == TRUE
    errors = [calibration_error(c[clear], true[clear]) for c in (before, after, fitted)]
    assert errors[2] < errors[1] + 0.005
    assert slope == 1.0 or errors[2] < 0.3 * errors[0]


def test_what_is_seldom_seen_changes_little():
    logits = np.full((3, len(statement_labels())), 4.0)
    judged = np.full(logits.shape, FALSE)
    judged[:, 0] = UNCLEAR
    scales = fit_scales(logits, judged)
    labels = statement_labels()
    alone = [k for k, (claim, _) in enumerate(labels) if sum(c == claim for c, _ in labels) == 1]
    assert np.isfinite(scales).all() and (scales[alone, 0] > 0.5).all()


def test_the_error_is_the_distance_of_certainty_and_truth():
    assert calibration_error(np.array([0.75] * 4), np.array([1, 1, 1, 0])) == pytest.approx(0.0)
    assert calibration_error(np.array([0.95] * 4), np.array([1, 1, 0, 0])) == pytest.approx(0.45)
    assert calibration_error(np.zeros(0), np.zeros(0)) == 0.0
