"""Collars and hoods sewn on, and kept where the neckline below is recut."""

from __future__ import annotations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from swifttailor import draft
from swifttailor.describing.claims import Claim
from swifttailor.describing.differences import Gain, Step
from swifttailor.describing.measuring.parts import Part
from swifttailor.recutting import alter
from swifttailor.recutting.amounts.neck_cuts import sew_collar, sew_hood
from swifttailor.recutting.table.cutter import Cutter


def gain(name, value):
    return Gain(Claim(name, value))


def neck_seam(cutter, part):
    """Lengths of the neckline and of what is sewn to it."""
    seam = cutter.anatomy.seam(Part.TORSO, part)
    return seam.length, seam.other_length


@pytest.mark.parametrize("name", ["t-shirt", "tank-top", "shirt-dress", "jumpsuit"])
@pytest.mark.parametrize("kind", ["stand", "lapel"])
def test_collars_are_as_long_as_the_neckline(name, kind, sound):
    before = draft(name)
    after = sound(before, alter(before, [gain("collar", kind)]))
    assert after.facts.collar.kind == kind
    own, other = neck_seam(after, Part.COLLAR)
    assert other == pytest.approx(own, rel=1e-6)
    turned = [s for s in after.pattern.stitches if s.right_wrong]
    assert bool(turned) == (kind == "lapel")
    assert set(before.canonical().panels) <= set(after.pattern.panels)  # nothing else has changed


@given(st.floats(2.0, 12.0))
@settings(max_examples=15, deadline=None)
def test_stands_are_as_high_as_is_asked_for(height):
    after = Cutter(sew_collar(Cutter(draft("t-shirt")), "stand", height))
    assert after.facts.collar.height == pytest.approx(height, abs=0.05)


@pytest.mark.parametrize("name", ["t-shirt", "fitted-dress"])
def test_hoods(name, sound):
    before = draft(name)
    after = sound(before, alter(before, [gain("hood", "hood")]))
    own, other = neck_seam(after, Part.HOOD)
    assert other == pytest.approx(own, abs=0.1)
    assert set(before.canonical().panels) <= set(after.pattern.panels)


@given(st.floats(46.0, 60.0), st.floats(26.0, 40.0), st.floats(-2.0, 22.0))
@settings(max_examples=15, deadline=None)
def test_hoods_measure_what_is_asked_for_at_deep_necklines_too(height, depth, deeper):
    shirt = alter(draft("t-shirt"), [Step("neck depth", 1, deeper)] if deeper > 2 else []).pattern
    pattern = sew_hood(Cutter(shirt), height, depth)
    if pattern is not None:
        after = Cutter(pattern)
        assert (after.facts.hood.height, after.facts.hood.depth) == pytest.approx((height, depth), abs=0.3)
        own, other = neck_seam(after, Part.HOOD)
        assert other == pytest.approx(own, abs=0.15)


@pytest.mark.parametrize(
    ("quantity", "direction"), [("neck depth", 1), ("neck depth", -1), ("neck width", 1), ("back depth", 1)]
)
@pytest.mark.parametrize("on", ["hood", "stand", "lapel"])
def test_what_is_on_a_neckline_stays_where_it_is_recut(on, quantity, direction, sound):
    wish = gain("hood", "hood") if on == "hood" else gain("collar", on)
    before = alter(draft("t-shirt"), [wish]).pattern
    after = sound(before, alter(before, [Step(quantity, direction)]))
    assert (after.facts.hood is not None) == (on == "hood")
    assert on == "hood" or after.facts.collar.kind == on
    own, other = neck_seam(after, Part.HOOD if on == "hood" else Part.COLLAR)
    assert other == pytest.approx(own, abs=0.15)


@pytest.mark.parametrize("step", [Step("hood depth", 1), Step("hood depth", -1, 3.0), Step("hood height", 1)])
def test_hoods_of_another_size(step, sound):
    before = draft("hoodie")
    after = sound(before, alter(before, [step]))
    was, now = Cutter(before).facts, after.facts
    assert now.front_neck == was.front_neck and now.left_sleeve == was.left_sleeve


def test_a_collar_takes_the_place_of_a_hood(sound):
    before = draft("hoodie")
    after = sound(before, alter(before, [gain("collar", "stand")]))
    assert after.facts.hood is None


def test_there_is_no_collar_without_shoulders():
    strapless = alter(draft("fitted-dress"), [gain("shoulders", "strapless")])
    assert strapless.open == ()
    wish = gain("collar", "stand")
    assert alter(strapless.pattern, [wish]).open == (wish,)
    assert sew_collar(Cutter(strapless.pattern), "stand", 4.0) is None
