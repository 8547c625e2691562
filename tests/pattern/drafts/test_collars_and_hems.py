"""Tall collars stand away from the neck, and backs of shirts are longer than their fronts look."""

from __future__ import annotations

import numpy as np
import pytest

from swifttailor import draft


def upper_over_lower(**options) -> float:
    """Length of the upper edge of a collar that stands over that of the lower one."""
    panel = draft("coat", standing=True, **options).panel("left_collar_front")
    chords = [panel.chord(k) for k in range(len(panel.edges))]
    level = [c for c in chords if abs(c[0, 1] - c[1, 1]) < 0.01]
    top, low = max(level, key=lambda c: c[0, 1]), min(level, key=lambda c: c[0, 1])
    return float(np.ptp(top[:, 0]) / np.ptp(low[:, 0]))


def test_collars_lean_to_the_neck_up_to_the_chin_and_stand_away_above():
    assert upper_over_lower(collar_height=5.0) < 1.0
    assert upper_over_lower(collar_height=10.0) < 1.0
    assert upper_over_lower(collar_height=11.0) > 1.3


@pytest.mark.parametrize("name", ["shirt", "polo-shirt"])
def test_backs_of_shirts_are_longer(name):
    pattern = draft(name)
    panel = pattern.panel("left_btorso")
    back = panel.to_world(panel.outline(0.2))
    middle = back[np.abs(back[:, 0]) < 1.0, 1].min()
    outer = back[back[:, 0] > back[:, 0].max() - 1.0, 1].min()
    assert 2.0 < outer - middle < 6.5


def test_coats_and_shirts_hang_closed():
    for name in ("coat", "shirt"):
        pattern = draft(name)
        sewn = {side for s in pattern.stitches for side in s.sides}
        panel = pattern.panel("left_ftorso")
        upright = [
            k
            for k in range(len(panel.edges))
            if abs(np.diff(panel.chord(k)[:, 0])[0]) < 0.5 and abs(np.diff(panel.chord(k)[:, 1])[0]) > 5.0
        ]
        assert all(any(s.edge == k and s.panel == "left_ftorso" for s in sewn) for k in upright)
