"""Drafts are cut to stated measures: the facts must give those back."""

from __future__ import annotations

import math

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from swifttailor.body import Body, BodyMeasurements
from swifttailor.describing import measure_facts
from swifttailor.pattern.drafts import draft

BODY = Body.default().measurements
FEW = settings(max_examples=12, deadline=None)


def lengths(low, high):
    return st.floats(low, high).map(lambda x: round(x, 1))


@given(lengths(14, 64), st.sampled_from(["round", "v", "square"]), lengths(8, 20))
@FEW
def test_t_shirt(sleeve_length, neckline, neck_depth):
    facts = measure_facts(
        draft("t-shirt", sleeve_length=sleeve_length, neckline=neckline, neck_depth=neck_depth)
    )
    assert facts.kind == "top" and facts.panels == 8
    for sleeve in (facts.left_sleeve, facts.right_sleeve):
        assert sleeve.length == pytest.approx(sleeve_length, abs=1.0)
        assert sleeve.cuff is None and sleeve.head_gather < 1.08
    assert facts.front_neck.shape == neckline
    # The draft's depth counts from where neck meets shoulder, ours from the neckline's end on the shoulder.
    assert facts.front_neck.depth == pytest.approx(neck_depth, abs=1.5)
    assert facts.back_neck.shape == "round"
    assert facts.torso.darts == 0


@given(lengths(4, 34), lengths(-10, 40))
@FEW
def test_ease_and_length_of_a_top(ease, length):
    facts = measure_facts(draft("tank-top", chest_ease=ease, length=length))
    assert facts.torso.chest_ease == pytest.approx(ease, abs=1.5 + 0.04 * ease)
    assert facts.left_sleeve is None and facts.torso.left_armhole.shape == "round"
    assert facts.hem.level == pytest.approx(BODY.waist_level - length, abs=4.5)


@given(lengths(40, 95), lengths(0.3, 1.5), lengths(2, 9))
@FEW
def test_circle_skirt(length, fraction, band_height):
    facts = measure_facts(draft("circle-skirt", length=length, fraction=fraction, band_height=band_height))
    assert facts.kind == "skirt" and facts.torso is None
    assert facts.length == pytest.approx(length, abs=1.5)
    assert facts.skirt.circle == pytest.approx(fraction, abs=0.03)
    assert facts.skirt.gather == pytest.approx(1.0, abs=0.01)
    assert facts.waistband.height == pytest.approx(band_height, abs=0.3)
    assert not facts.waistband.at_hem
    assert facts.hem.front == pytest.approx(facts.hem.back, abs=1.0)


@given(lengths(40, 95), lengths(1.3, 3.0))
@FEW
def test_gathered_skirt(length, fullness):
    facts = measure_facts(draft("gathered-skirt", length=length, fullness=fullness, flare=0.0))
    assert facts.skirt.gather == pytest.approx(fullness, rel=0.02)
    assert facts.skirt.circle == pytest.approx(0.0, abs=0.02)
    assert facts.skirt.hem == pytest.approx(fullness * facts.waistband.lower, rel=0.02)
    assert facts.length == pytest.approx(length, abs=1.5)


@given(lengths(40, 90), lengths(-4, 16), lengths(2, 16))
@FEW
def test_fitted_skirt(length, flare, hip_ease):
    facts = measure_facts(draft("fitted-skirt", length=length, flare=flare, hip_ease=hip_ease))
    assert facts.skirt.darts > 0 and facts.skirt.gores == 2 and facts.skirt.tiers == 1
    assert facts.skirt.hips == pytest.approx(BODY.hips + hip_ease, abs=2.5)
    below = length - (BODY.hips_line)
    spread = 4 * math.tan(math.radians(flare)) * max(below, 0.0)
    assert facts.skirt.hem - facts.skirt.hips == pytest.approx(spread, abs=4.0 + 0.1 * abs(spread))


@given(lengths(45, 104), lengths(3, 28), st.booleans())
@FEW
def test_trousers(length, leg_ease, flared):
    facts = measure_facts(draft("trousers", length=length, leg_ease=leg_ease, flare=12.0 if flared else -6.0))
    assert facts.kind == "trousers" and facts.skirt is None
    assert facts.hem.level == pytest.approx(BODY.waist_level - length, abs=2.5)
    assert facts.trousers.cuff is None and facts.trousers.darts == 4
    assert facts.trousers.opening == pytest.approx(facts.trousers.hem, abs=0.1)
    assert facts.trousers.inseam == pytest.approx(BODY.crotch_level - facts.hem.level, abs=4.0)


@given(lengths(30, 64), lengths(3, 9), lengths(5, 17), st.booleans(), st.booleans())
@FEW
def test_hoodie(sleeve_length, cuff_height, hood_height, cuffs, band):
    facts = measure_facts(
        draft(
            "hoodie",
            sleeve_length=sleeve_length,
            cuff_height=cuff_height,
            hood_height=hood_height,
            cuffs=cuffs,
            hem_band=band,
        )
    )
    assert facts.hood is not None and facts.collar is None
    assert facts.left_sleeve.length == pytest.approx(sleeve_length, abs=1.5)
    assert (facts.left_sleeve.cuff is not None) == cuffs
    if cuffs:
        assert facts.left_sleeve.cuff.kind == "band"
        assert facts.left_sleeve.cuff.length == pytest.approx(cuff_height, abs=0.3)
    assert (facts.waistband is not None) == band
    if band:
        assert facts.waistband.at_hem
    assert facts.hood.height > hood_height + 20


@given(lengths(40, 95), lengths(2, 14))
@FEW
def test_fitted_dress(skirt_length, bust_ease):
    facts = measure_facts(draft("fitted-dress", skirt_length=skirt_length, bust_ease=bust_ease))
    assert facts.kind == "dress" and facts.torso.darts == 6
    assert facts.skirt.length == pytest.approx(skirt_length, abs=1.5)
    assert facts.torso.chest_ease == pytest.approx(bust_ease, abs=2.0)
    assert facts.torso.lower_level == pytest.approx(BODY.waist_level, abs=2.5)
    assert not facts.strapless and not facts.one_shoulder


def test_left_and_right_agree(draft_facts):
    for name, facts in draft_facts.items():
        if facts.torso:
            assert facts.torso.left_shoulder == pytest.approx(facts.torso.right_shoulder), name
        if facts.left_sleeve:
            assert facts.left_sleeve.length == pytest.approx(facts.right_sleeve.length), name
        if facts.front_neck:
            assert facts.front_neck.left.shape == facts.front_neck.right.shape, name


def test_another_body_gives_other_landmarks():
    pattern = draft("t-shirt")
    values = BODY.as_dict() | {"height": BODY.height - 12.0}
    facts = measure_facts(pattern, BodyMeasurements.from_mapping(values))
    assert facts.body.waist == pytest.approx(measure_facts(pattern).body.waist - 12.0)
