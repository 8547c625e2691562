"""Hems that reach the feet are laid over the toes before they fall."""

from __future__ import annotations

import numpy as np
import pytest

from swifttailor.body import Body
from swifttailor.garment_sewer.clear_of_feet import clear_of_feet


def tube(low: float, deep: float) -> np.ndarray:
    """A skirt that hangs straight down from the knees, so deep from front to back."""
    turn, height = np.meshgrid(np.linspace(0.0, 2 * np.pi, 48, endpoint=False), np.linspace(low, 50.0, 30))
    return np.stack([22.0 * np.sin(turn), height, -2.0 + 0.5 * deep * np.cos(turn)], axis=-1).reshape(-1, 3)


def test_wide_skirts_lie_before_the_toes():
    body, cloth = Body.default(), tube(1.0, 24.0)
    laid = clear_of_feet(cloth, body)
    toes = body.vertices[body.vertices[:, 1] < 8.0, 2].max()
    in_front = (cloth[:, 1] < 4.0) & (np.abs(cloth[:, 0]) < 12.0) & (cloth[:, 2] > 0.0)
    assert laid[in_front, 2].min() > toes
    kept = (cloth[:, 1] > 40.0) | (cloth[:, 2] < -2.0)
    np.testing.assert_array_equal(laid[kept], cloth[kept])
    np.testing.assert_array_equal(laid[:, :2], cloth[:, :2])


@pytest.mark.parametrize(("low", "deep"), [(15.0, 24.0), (1.0, 14.0)])
def test_short_and_narrow_ones_stay(low, deep):
    cloth = tube(low, deep)
    assert clear_of_feet(cloth, Body.default()) is cloth
