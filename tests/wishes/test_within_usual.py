"""What is cut back where nobody speaks of it."""

from __future__ import annotations

from dataclasses import replace

import pytest

import swifttailor
from swifttailor.describing import Claim, measure_facts
from swifttailor.describing.differences import Gain, Step
from swifttailor.describing.facts import Cuff
from swifttailor.recutting import alter
from swifttailor.wishes.assumed.within_usual import beyond_usual, within_usual


@pytest.fixture(scope="module")
def facts():
    return measure_facts(swifttailor.draft("t-shirt"))


def with_neck(facts, face, **values):
    neck = getattr(facts, face)
    half = replace(neck.left, **values)
    return replace(facts, **{face: replace(neck, left=half, right=half)})


@pytest.mark.parametrize("name", ["t-shirt", "polo-shirt", "turtleneck", "trousers", "circle-skirt"])
def test_what_is_usual_stays(name):
    assert within_usual([], measure_facts(swifttailor.draft(name))) == ()


@pytest.mark.parametrize(
    ("face", "values", "spoken", "change"),
    [
        ("front_neck", {"depth": 36.0}, ("neck_depth", "plunging"), Gain(Claim("neck_depth_cm", 14.0))),
        ("back_neck", {"depth": 30.0}, ("back_depth", "open"), Gain(Claim("back_depth_cm", 6.0))),
        ("front_neck", {"width": 15.0}, ("neckline", "boat"), Step("neck width", -1, 10.0)),
    ],
)
def test_an_odd_neckline_is_cut_back_unless_it_is_spoken_of(facts, face, values, spoken, change):
    odd = with_neck(facts, face, **values)
    assert within_usual([], odd) == (change,)
    assert len(beyond_usual([], odd)) == 1
    assert within_usual([Gain(Claim("shoulders", "both"))], odd) == (change,)
    assert within_usual([Gain(Claim(*spoken))], odd) == ()


def test_a_v_may_be_deeper_than_a_round_neckline(facts):
    deep = with_neck(facts, "front_neck", depth=22.0)
    assert within_usual([], deep) and not within_usual([Gain(Claim("neckline", "v"))], deep)


def test_deep_cuffs_are_shortened_unless_they_are_asked_for(facts):
    cuff = Cuff("band", 25.0, 25.0, 1.0)
    sleeves = {side: replace(getattr(facts, side), cuff=cuff) for side in ("left_sleeve", "right_sleeve")}
    deep = replace(facts, **sleeves)
    assert within_usual([], deep) == (Gain(Claim("cuff_cm", 6.0)),)
    assert within_usual([Gain(Claim("cuffs", "band"))], deep) == (Gain(Claim("cuff_cm", 6.0)),)
    assert within_usual([Gain(Claim("cuffs", "deep"))], deep) == ()
    assert within_usual([Gain(Claim("cuff_cm", 25.0))], deep) == ()


def test_a_neckline_that_is_cut_back_is_usual_afterwards():
    deep = alter(swifttailor.draft("fitted-dress", neck_widening=3.0), [Claim("neck_depth_cm", 30.0)])
    assert deep.facts.front_neck.depth > 28.0 and deep.facts.front_neck.width > 13.0
    assert len(beyond_usual([], deep.facts)) == 2
    back = alter(deep.pattern, within_usual([], deep.facts))
    assert back.open == () and within_usual([], back.facts) == ()


@pytest.fixture(scope="module")
def skirt():
    return measure_facts(swifttailor.draft("circle-skirt"))


def test_a_hem_in_points_is_levelled_unless_it_is_asked_for(skirt):
    pointed = replace(skirt, hem=replace(skirt.hem, dip=30.0))
    assert within_usual([], pointed) == (Gain(Claim("hem_shape", "level")),)
    assert beyond_usual([], pointed) == ("its hem hangs in points",)
    assert within_usual([Gain(Claim("hem_shape", "pointed"))], pointed) == ()


def test_a_very_wide_skirt_is_narrowed_unless_it_is_asked_for(skirt):
    wide = replace(skirt, hem=replace(skirt.hem, length=1077.0))
    assert within_usual([], wide) == (Gain(Claim("hem_cm", 440.0)),)
    for spoken in (Claim("hem_cm", 1077.0), Claim("skirt", "circle")):
        assert within_usual([Gain(spoken)], wide) == ()


def test_a_stand_collar_is_no_turtleneck():
    high = measure_facts(swifttailor.draft("turtleneck"))
    assert high.collar.height > 5.0
    stand, turtleneck = (Gain(Claim("collar", kind)) for kind in ("stand", "turtleneck"))
    assert within_usual([stand], high) == (Gain(Claim("collar_cm", 4.0)),)
    assert within_usual([stand, turtleneck], high) == within_usual([turtleneck], high) == ()


def test_a_straight_skirt_is_not_gathered():
    dress = measure_facts(swifttailor.draft("fitted-dress"))
    dress = replace(dress, skirt=replace(dress.skirt, gather=1.5))
    straight, smooth = Gain(Claim("skirt", "straight")), Step("skirt gathers", -1, 0.5)
    assert smooth in within_usual([straight], dress)
    for spoken in ("gathered", "a-line"):
        assert smooth not in within_usual([straight, Gain(Claim("skirt", spoken))], dress)


def test_slits_that_nobody_asked_for_are_closed_where_one_is_asked_for():
    both = alter(swifttailor.draft("fitted-skirt"), [Claim("slit", "back"), Claim("slit", "front")])
    front = next(slit for slit in both.facts.skirt.slits if slit.place == "front")
    asked = Gain(Claim("slit", "back"))
    assert within_usual([asked], both.facts) == (Step("front slit", -1, front.height),)
    assert within_usual([asked, Gain(Claim("slit", "front"))], both.facts) == ()
    after = alter(both.pattern, [asked, *within_usual([asked], both.facts)])
    assert [slit.place for slit in after.facts.skirt.slits] == ["back"] and after.open == ()
