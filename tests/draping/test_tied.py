"""Belts draw in cloth that lies outside of them, little by little, and never into the body."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np
import pytest

from swifttailor.body import Body
from swifttailor.draping.tied import tie_around

BODY = Body.default()
WAIST = BODY.measurements.waist_level


def tube(radius: float) -> np.ndarray:
    """(v, 3) of cloth that stands around the waist like a pipe."""
    turn = np.linspace(0.0, 2 * np.pi, 72, endpoint=False)
    rows = [
        np.stack([radius * np.sin(turn), np.full(72, y), radius * np.cos(turn)], axis=1)
        for y in WAIST + np.arange(-20.0, 21.0, 2.0)
    ]
    return np.concatenate(rows)


def radii(points: np.ndarray, off: float) -> np.ndarray:
    row = points[np.abs(points[:, 1] - WAIST - off) < 0.1]
    return np.linalg.norm(row[:, [0, 2]], axis=1)


def test_a_belt_draws_in_what_lies_below_it_alone():
    cloth = tube(26.0)
    tie = tie_around(cloth, np.arange(len(cloth), dtype=np.int32), WAIST, 4.5, BODY)
    assert tie is not None
    state = SimpleNamespace(positions=cloth.copy(), velocities=np.zeros_like(cloth))
    tie(state, 0.3)
    between = radii(state.positions, 0.0).mean()
    tie(state, 1.0)
    tight = radii(state.positions, 0.0)
    assert tight.mean() < between < 26.0
    assert tight.min() > 26.0 * 0.75, "no more than folds can take up"
    np.testing.assert_allclose(radii(state.positions, 10.0), 26.0)
    waist = BODY.measurements.waist / (2 * np.pi)
    assert tight.mean() > waist


@pytest.mark.parametrize("radius", [6.0, 10.0])
def test_what_does_not_go_around_the_body_is_not_tied(radius):
    cloth = tube(radius)
    assert tie_around(cloth, np.arange(len(cloth), dtype=np.int32), WAIST, 4.5, BODY) is None
