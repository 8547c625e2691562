"""How garments will sit, by their measures."""

from __future__ import annotations

from dataclasses import replace

import pytest

import swifttailor
from swifttailor.describing import Claim, measure_facts
from swifttailor.describing.differences import Gain
from swifttailor.pattern.drafts import list_drafts
from swifttailor.tailor.sitting import sits_badly


@pytest.mark.parametrize("name", [d.name for d in list_drafts()])
def test_drafts_sit_well(name):
    pattern = swifttailor.draft(name)
    assert sits_badly(measure_facts(pattern), [], cloth_stretch=pattern.cloth_stretch) == ()


def test_what_is_narrower_than_the_hips_has_to_stretch():
    facts = measure_facts(swifttailor.draft("leggings"))
    assert sits_badly(facts, []) == ("it is narrower than the hips",)


def test_a_collar_on_a_wide_neckline_stands_off_unless_a_deep_one_is_asked_for():
    facts = measure_facts(swifttailor.draft("turtleneck"))
    half = replace(facts.front_neck.left, width=11.5)
    wide = replace(facts, front_neck=replace(facts.front_neck, left=half, right=half))
    assert sits_badly(wide, []) == ("its collar stands away from the neck",)
    assert sits_badly(wide, [Gain(Claim("neck_depth", "low"))]) == ()


def test_briefs_that_reach_the_waist_leave_the_hips_bare():
    assert sits_badly(measure_facts(swifttailor.draft("briefs", below_waist=2.0)), []) == ()


def test_what_is_narrower_than_the_hips_does_not_go_over_them():
    facts = measure_facts(swifttailor.draft("trousers"))
    hips = facts.body.hip_girth
    for room, found in ((-10.0, ("it is narrower than the hips",)), (-2.0, ())):
        assert sits_badly(replace(facts, trousers=replace(facts.trousers, hips=hips + room)), []) == found


@pytest.mark.parametrize(
    ("said", "badly"),
    [
        ((), True),
        ((("waistband", "narrow"),), True),
        ((("waistband", "loose"),), False),
        ((("rise", "low"),), False),
    ],
)
def test_a_band_that_is_wider_than_the_waist_is_told_unless_it_is_asked_for(said, badly):
    facts = measure_facts(swifttailor.draft("fitted-skirt"))
    wide = replace(facts, waistband=replace(facts.waistband, upper=facts.body.waist_girth + 12.0))
    found = sits_badly(wide, [Gain(Claim(*one)) for one in said])
    assert found == (("its waistband is wider than the waist",) if badly else ())


def test_a_low_band_lies_on_the_hips():
    facts = measure_facts(swifttailor.draft("fitted-skirt"))
    wide = replace(facts, waistband=replace(facts.waistband, upper=facts.body.hip_girth + 50.0))
    low, loose = Gain(Claim("rise", "low")), Gain(Claim("waistband", "loose"))
    assert sits_badly(wide, [low]) == ("its waistband is wider than the hips",)
    assert sits_badly(wide, [low, loose]) == ()
