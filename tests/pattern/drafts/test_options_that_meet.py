"""Options at the ends of their ranges that meet each other, or a body: one of them gives way."""

from __future__ import annotations

import pytest
from draft_checks import assert_sound

from swifttailor.pattern.drafts import DraftMeasurements, draft


def test_a_wing_begins_within_the_end_of_its_sleeve():
    """The side of a wide hem slants outward, and would reach beyond a short sleeve."""
    cut = {"armhole": "cut-in-one", "sleeve_shape": "bell", "wing": 30.0}
    assert_sound(draft("t-shirt", **cut, flare=40.0, hem_rise=9.0))


@pytest.mark.parametrize("name", ["blazer", "turtleneck", "waistcoat"])
def test_bust_darts_end_above_hems_that_lie_above_the_bust(name):
    low_bust = DraftMeasurements(vert_bust_line=23.0, waist_line=33.0)
    assert_sound(draft(name, measurements=low_bust, length=-12.0, waist_shaping=3.0))


@pytest.mark.parametrize("name", ["blazer", "turtleneck"])
def test_bust_darts_end_beside_the_edges_of_wide_open_fronts(name):
    full_bust = DraftMeasurements(waist_line=35.1, waist_over_bust_line=45.0)
    cut = {"length": -12.0, "opening": 14.0, "waist_shaping": 3.0}
    depth = {"neck_depth": 18.0} if name == "blazer" else {}
    assert_sound(draft(name, measurements=full_bust, **cut, **depth))
