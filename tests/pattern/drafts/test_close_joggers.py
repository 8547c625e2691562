"""Legs of pull-on trousers and joggers: close ones lie around the calves, wide ones reach the ankle."""

from __future__ import annotations

import numpy as np

from swifttailor.pattern.drafts import draft


def side_of_knee(pattern) -> float:
    """How far the side seam moves in from the hip to the leg's end, cm."""
    panel = pattern.panel("pant_f_l")
    x = panel.to_world(panel.outline(0.5))
    low = x[x[:, 1] <= x[:, 1].min() + 1.0, 0].max()
    return float(x[:, 0].max() - low)


def test_close_legs_narrow_at_the_side_seams_as_well():
    close, roomy = (draft("joggers", leg_ease=ease, flare=-4.0) for ease in (9.0, 11.0))
    assert side_of_knee(close) > side_of_knee(roomy) + 1.0


def test_full_legs_are_longer_by_what_goes_in_to_the_cuffs():
    usual, full = (draft("joggers", leg_ease=ease, flare=-6.0) for ease in (14.0, 54.0))
    ends = [np.ptp(p.panel("pant_f_l").outline(0.5)[:, 1]) for p in (usual, full)]
    assert ends[1] > ends[0] + 3.0
