"""Designs drafted for a body are as wide and as long as the body asks for, and say whose they are."""

from __future__ import annotations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from swifttailor.body import Body, body_for
from swifttailor.body.made_to_measure import body_to_measure
from swifttailor.body.probe import probe_body
from swifttailor.describing.measuring import measure_facts
from swifttailor.pattern import Severity, check_pattern
from swifttailor.programs import DesignError, make_pattern
from swifttailor.refitting import draft_design

DRESS = {
    "meta.upper": "FittedShirt",
    "meta.wb": "StraightWB",
    "meta.bottom": "Skirt2",
    "skirt.ruffle": 1.0,
    "skirt.length": 0.6,
    "sleeve.sleeveless": False,
    "sleeve.length": 0.6,
}
SHIRT = {"meta.upper": "Shirt", "shirt.width": 1.2, "sleeve.sleeveless": False}
PANTS = {"meta.bottom": "Pants", "meta.wb": "FittedWB", "pants.length": 0.9}
WEARERS = ["36", "46", "52", "men 44", "men 58", "children 122", "children 146"]


@pytest.fixture(scope="module")
def worn():
    return {name: body_for(name) for name in WEARERS}


@pytest.mark.parametrize("design", [DRESS, SHIRT, PANTS], ids=["dress", "shirt", "pants"])
@pytest.mark.parametrize("name", WEARERS)
def test_a_check_finds_nothing_on_any_body(design, name, worn):
    body = worn[name]
    pattern = draft_design(design, body)
    assert pattern.drafted_for == body.made_for
    found = [f for f in check_pattern(pattern, body=probe_body(body)) if f.severity is not Severity.INFO]
    assert not found, [f.line() for f in found]


@pytest.mark.parametrize("name", WEARERS)
def test_widths_and_lengths_are_the_body_s(name, worn):
    m = worn[name].measurements
    shirt = measure_facts(draft_design(SHIRT, worn[name]), m)
    assert shirt.torso.chest == pytest.approx(1.2 * m.bust, rel=0.01)
    dress = measure_facts(draft_design(DRESS, worn[name]), m)
    assert dress.waistband.upper == pytest.approx(m.waist, rel=0.02)
    assert dress.skirt.length == pytest.approx(0.6 * m.leg_length + m.hips_line, rel=0.02)
    pants = measure_facts(draft_design(PANTS, worn[name]), m)
    assert pants.trousers.hips == pytest.approx(m.hips, abs=1.2)


@settings(max_examples=12, deadline=None)
@given(bust=st.floats(80, 125), height=st.floats(150, 195), wide=st.floats(1.0, 1.3))
def test_a_shirt_is_as_many_times_as_wide_as_the_chest_as_its_design_says(bust, height, wide):
    body = body_to_measure({"bust": bust, "height": height}).body
    facts = measure_facts(draft_design(SHIRT | {"shirt.width": wide}, body), body.measurements)
    assert facts.torso.chest == pytest.approx(wide * body.measurements.bust, rel=0.01)


def test_without_a_body_it_is_garmentcode_s(tmp_path):
    plain = draft_design(DRESS)
    assert plain == make_pattern(DRESS) and plain.drafted_for is None
    assert draft_design(DRESS, Body.default()).drafted_for is None
    (tmp_path / "dress.yaml").write_text(
        "".join(f"{k}: {str(v).lower() if v is False else v}\n" for k, v in DRESS.items())
    )
    assert draft_design(tmp_path / "dress.yaml") == plain


def test_a_garment_that_is_too_long_for_a_body_says_for_whom(worn):
    long = {"meta.upper": "Shirt", "shirt.length": 3.5}
    with pytest.raises(DesignError, match="from the neck to the floor"):
        draft_design(long, worn["children 122"])
