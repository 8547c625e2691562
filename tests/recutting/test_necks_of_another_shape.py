"""Necklines that need more than one cut for another shape, or room for it."""

from __future__ import annotations

import pytest

import swifttailor
from swifttailor.describing import Claim
from swifttailor.describing.measuring import measure_facts
from swifttailor.recutting.alter import alter


@pytest.fixture(scope="module")
def v_neck():
    return alter(swifttailor.draft("t-shirt"), ["neckline=v"]).pattern


def test_a_v_neck_becomes_a_boat_neck(v_neck):
    done = alter(v_neck, ["neckline=boat"], keep_others=True)
    assert not done.open and Claim("neckline", "boat").holds(done.facts)
    assert done.cuts[0] == "front neckline cut shallow and round"


def test_a_plunging_neckline_becomes_a_square_one_less_deep():
    deep = alter(swifttailor.draft("fitted-dress"), ["neckline=v", "neck_depth_cm=27"]).pattern
    done = alter(deep, ["neckline=square"], keep_others=True)
    assert not done.open and Claim("neckline", "square").holds(done.facts)
    assert done.facts.front_neck.depth < measure_facts(deep).front_neck.depth
