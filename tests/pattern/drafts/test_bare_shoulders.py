"""Halters and necklines around the arms, as a tailor and the program measure them."""

from __future__ import annotations

import numpy as np
import pytest
from test_cut import BODY, extent, seam_length

from swifttailor.describing import Claim
from swifttailor.describing.measuring import measure_facts
from swifttailor.pattern.drafts import draft
from swifttailor.recutting.holes import has_holes

HALTERS = ("halter-top", "halter-dress")
OFF_SHOULDERS = ("off-shoulder-top", "off-shoulder-dress")


@pytest.mark.parametrize("name", HALTERS)
@pytest.mark.parametrize("width", [1.5, 3.5, 6.0])
def test_a_halter_s_strap_is_as_wide_as_the_front_where_they_meet(name, width):
    pattern = draft(name, strap_width=width)
    front, strap = seam_length(pattern, "left_ftorso", "left_btorso_strap")
    assert strap == pytest.approx(front, rel=1e-3)
    assert front == pytest.approx(width, rel=0.15)


@pytest.mark.parametrize("name", HALTERS)
def test_a_halter_leaves_arms_and_back_bare_and_has_no_holes(name):
    pattern = draft(name)
    facts = measure_facts(pattern)
    assert Claim("sleeves", "none").holds(facts) and Claim("back_depth", "low").holds(facts)
    assert not Claim("back_depth", "high").holds(facts), "the strap behind the neck is not the back"
    assert not has_holes(pattern)


@pytest.mark.parametrize("name", OFF_SHOULDERS)
@pytest.mark.parametrize("height", [3.0, 5.0, 9.0])
def test_the_edge_is_level_on_the_body_and_as_high_as_asked(name, height):
    pattern = draft(name, above_underarm=height)
    neck_y = BODY.height - BODY.head_l
    assert all(extent(pattern, f"left_{face}torso")[1, 1] < neck_y for face in "fb")
    fronts = [extent(draft(name, above_underarm=h), "left_ftorso")[1, 1] for h in (3.0, height)]
    assert fronts[1] - fronts[0] == pytest.approx(height - 3.0, abs=0.2)


@pytest.mark.parametrize("name", OFF_SHOULDERS)
@pytest.mark.parametrize("length", [24.0, 30.0, 60.0])
def test_off_the_shoulder_has_sleeves_and_bare_shoulders(name, length):
    facts = measure_facts(draft(name, sleeve_length=length))
    assert Claim("shoulders", "strapless").holds(facts)
    assert facts.left_sleeve is not None
    assert facts.left_sleeve.length == pytest.approx(length, abs=4.0)
    assert not has_holes(draft(name, sleeve_length=length))


@pytest.mark.parametrize("name", OFF_SHOULDERS)
def test_sleeves_are_eased_into_what_is_left_of_the_armholes(name):
    pattern = draft(name)
    for side in "fb":
        torso, sleeve = seam_length(pattern, f"left_{side}torso", f"left_sleeve_{side}")
        assert np.isclose(torso, sleeve, rtol=0.03)


def test_off_the_shoulder_a_close_skirt_may_end_at_a_flounce():
    made = draft("off-shoulder-dress", waist_seam=True, flounce=True, length=100.0, skirt_fraction=0.8)
    facts = measure_facts(made)
    assert Claim("skirt", "fitted base").holds(facts) and Claim("skirt_hem", "ankle").holds(facts)
    assert not has_holes(made)
