"""Lengths and widths well within what words mean."""

from __future__ import annotations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import swifttailor
from swifttailor.describing import Claim, measure_facts
from swifttailor.describing.differences import Gain, Step
from swifttailor.recutting import alter
from swifttailor.wishes.assumed.well_within import (
    FLOOR_AT_LEAST_CM,
    FLOOR_CM,
    as_stated,
    off_the_floor,
    well_within,
)

CASES = [
    ("trousers", {"length": 92.0}, Claim("leg_hem", "full"), "inseam_cm"),
    ("t-shirt", {"sleeve_length": 47.0}, Claim("sleeves", "long"), "sleeve_cm"),
    ("circle-skirt", {"length": 88.0}, Claim("skirt_hem", "maxi"), "skirt_length_cm"),
    ("fitted-dress", {"skirt_length": 91.0}, Claim("skirt_hem", "maxi"), "skirt_length_cm"),
    ("swing-dress", {"length": 90.0}, Claim("skirt_hem", "maxi"), "length_cm"),
]


@pytest.mark.parametrize(("name", "options", "said", "measure"), CASES)
def test_what_is_met_at_the_border_is_cut_further_once(name, options, said, measure):
    pattern = swifttailor.draft(name, **options)
    facts = measure_facts(pattern)
    assert said.holds(facts), "it is met as it is"
    (wish,) = well_within([Gain(said)], facts)
    assert isinstance(wish, Gain) and wish.claim.name == measure
    cut = alter(pattern, [Gain(said), wish])
    assert cut.open == ()
    assert cut.facts.hem is not None and facts.hem is not None
    if measure == "sleeve_cm":
        assert cut.facts.left_sleeve.length > facts.left_sleeve.length + 2.0
    else:
        assert 0.0 < cut.facts.hem.level < facts.hem.level - 2.0
    assert well_within([Gain(said)], cut.facts) == ()


@pytest.mark.parametrize(("name", "options", "said", "measure"), CASES)
def test_measures_that_are_said_stand(name, options, said, measure):
    facts = measure_facts(swifttailor.draft(name, **options))
    assert well_within([], facts) == ()
    assert well_within([Gain(said), Gain(Claim(measure, 50.0))], facts) == ()


@pytest.mark.parametrize("length", [56.0, 68.0])
def test_hems_at_the_knee_end_at_its_middle(length):
    pattern = swifttailor.draft("circle-skirt", length=length)
    said = Gain(Claim("skirt_hem", "knee"))
    cut = alter(pattern, [said, *well_within([said], measure_facts(pattern))])
    assert abs(cut.facts.hem.level - cut.facts.body.knee) < 1.0


def test_hems_below_the_knee_cover_it():
    facts = measure_facts(swifttailor.draft("fitted-skirt", length=63.0))
    (wish,) = well_within([Gain(Claim("skirt_hem", "below the knee"))], facts)
    assert wish.claim.name == "skirt_length_cm" and 66.0 < wish.claim.value < 70.0


def test_wide_legs_are_wider_than_the_thigh():
    facts = measure_facts(swifttailor.draft("trousers"))
    (wish,) = well_within([Gain(Claim("legs", "wide"))], facts)
    assert isinstance(wish, Gain) and wish.claim.name == "leg_width_cm"
    assert float(wish.claim.value) > 1.2 * facts.body.thigh_girth


@settings(max_examples=15, deadline=None)
@given(st.floats(30.0, 59.0))
def test_long_sleeves_never_become_shorter(length):
    facts = measure_facts(swifttailor.draft("t-shirt", sleeve_length=length))
    for wish in well_within([Gain(Claim("sleeves", "long"))], facts):
        assert isinstance(wish, Gain) and float(wish.claim.value) > facts.left_sleeve.length


def test_a_gown_is_cut_short_enough_to_walk_in():
    floor = Gain(Claim("skirt_hem", "floor"))
    (step,) = off_the_floor([floor], alter_to_level(0.5))
    assert isinstance(step, Step) and step.amount == pytest.approx(FLOOR_CM - 0.5, abs=0.6)
    assert off_the_floor([Gain(Claim("skirt_hem", "maxi"))], alter_to_level(0.5)) == ()
    assert off_the_floor([floor, Gain(Claim("skirt_length_cm", 110.0))], alter_to_level(0.5)) == ()
    assert off_the_floor([floor], alter_to_level(FLOOR_AT_LEAST_CM + 0.5)) == ()


def alter_to_level(level: float):
    """Facts of a dress whose hem is measured at a height, cm."""
    dress = swifttailor.draft("fitted-dress", skirt_length=100.0)
    facts = measure_facts(dress)
    return alter(dress, [Step("length", 1, facts.hem.level - level)]).facts


def test_a_slit_in_a_long_skirt_opens_to_above_the_knee():
    pattern = swifttailor.draft("fitted-skirt", length=95.0)
    said = Gain(Claim("slit", "left"))
    cut = alter(pattern, [said])
    (wish,) = well_within([said], cut.facts)
    assert isinstance(wish, Step) and wish.quantity == "left slit"
    again = alter(cut.pattern, [said, wish]).facts
    assert again.skirt is not None and again.hem is not None
    top = again.hem.level + max(slit.height for slit in again.skirt.slits)
    assert again.body.knee + 9.0 < top < again.body.knee + 17.0
    assert well_within([Gain(Claim("slit", "back"))], cut.facts) == ()


def test_slim_legs_stay_above_the_instep():
    facts = measure_facts(swifttailor.draft("leggings"))
    assert facts.hem is not None and facts.hem.level > 8.0
    assert well_within([Gain(Claim("leg_hem", "full"))], facts) == ()


@pytest.mark.parametrize(("name", "length"), [("circle-skirt", 88.0), ("skater-dress", 84.0)])
def test_midis_do_not_look_like_maxis(name, length):
    option = "length" if name == "circle-skirt" else "skirt_length"
    facts = measure_facts(swifttailor.draft(name, **{option: length}))
    midi = Gain(Claim("skirt_hem", "midi"))
    (wish,) = well_within([midi], facts)
    assert wish.claim.name == "skirt_length_cm" and length - 14.0 < wish.claim.value < length - 3.0
    assert well_within([midi], measure_facts(swifttailor.draft(name, **{option: 74.0}))) == ()


def test_hems_below_the_knee_do_not_hang_far_below_it():
    facts = measure_facts(swifttailor.draft("fitted-skirt", length=77.0))
    (wish,) = well_within([Gain(Claim("skirt_hem", "below the knee"))], facts)
    assert 68.0 < wish.claim.value < 74.0


@pytest.mark.parametrize(("off", "steps"), [(4.0, 1), (1.0, 0), (-4.0, 0)])
def test_legs_are_no_longer_than_their_inseam_was_stated(off, steps):
    facts = measure_facts(swifttailor.draft("trousers"))
    assert facts.trousers is not None
    found = as_stated([Gain(Claim("inseam_cm", facts.trousers.inseam - off))], facts)
    assert found == (Step("leg length", -1, off),) * steps


def test_narrow_legs_stay_off_the_foot():
    full = [Gain(Claim("leg_hem", "full"))]
    narrow = measure_facts(swifttailor.draft("trousers", length=99.5, leg_ease=17, flare=-8))
    wide = measure_facts(swifttailor.draft("trousers", length=99.5, leg_ease=42, flare=10))
    assert not well_within(full, narrow) and well_within(full, wide)
