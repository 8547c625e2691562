"""A slit that a gown is asked for is seen: over the leg in front, or with the front cut away beside it."""

from __future__ import annotations

import pytest

from swifttailor.describing.differences import Step
from swifttailor.pattern import check_pattern
from swifttailor.pattern.drafts import draft
from swifttailor.pattern.pattern import Pattern
from swifttailor.recutting.alter import alter
from swifttailor.recutting.levers.slits import closed, open_slit
from swifttailor.recutting.table.cutter import Cutter
from swifttailor.recutting.ways.parted_slits import parted_front, parted_sides, parted_slit, slit_over_leg


def gown(place: str, height: float = 46.0) -> Pattern:
    opened = open_slit(Cutter(draft("fitted-dress", skirt_length=92.0)), place, height, 2.0)
    assert opened is not None
    return opened


@pytest.mark.parametrize("place", ["left", "right"])
def test_it_is_cut_over_that_leg(place):
    before = gown(place)
    after = slit_over_leg(before)
    assert after is not None
    (slit,) = Cutter(after).facts.skirt.slits
    assert slit.place == "front" and slit.height == pytest.approx(46.0, abs=2.0) and slit.width > 12.0
    assert slit.over == place
    hem = after.panel("skirt_front").to_world(after.panel("skirt_front").vertices)
    x = hem[(hem[:, 1] > hem[:, 1].min() + 40.0) & (hem[:, 1] < hem[:, 1].max() - 20.0), 0]
    assert abs(x * (1 if place == "left" else -1) - 13.0).min() < 1.5
    errors = [f for f in check_pattern(after) if f.severity.name == "ERROR"]
    assert errors == [f for f in check_pattern(before) if f.severity.name == "ERROR"]


@pytest.mark.parametrize("place", ["left", "right"])
def test_at_the_side_the_front_is_cut_away(place):
    before = gown(place)
    after = parted_slit(before)
    assert after is not None
    ends = [p.to_world(p.vertices)[:, 0] for p in (before.panel("skirt_front"), after.panel("skirt_front"))]
    reach = [max(x) if place == "left" else -min(x) for x in ends]
    assert reach[1] <= reach[0] and Cutter(after).facts.skirt.slits[0].place == place


def test_a_much_lower_one_is_sewn_shut():
    lower = open_slit(Cutter(gown("left")), "right", 20.0, 2.0)
    after = slit_over_leg(lower)
    assert [slit.place for slit in Cutter(after).facts.skirt.slits] == ["front"]
    assert slit_over_leg(open_slit(Cutter(gown("left")), "right", 40.0, 2.0)) is None


def test_a_slit_over_a_joint_is_closed_down_to_the_hem():
    high = alter(gown("left", 24.0), [Step("left slit", 1, 14.0)]).pattern
    assert Cutter(high).facts.skirt.slits[0].height == pytest.approx(38.0, abs=1.0)
    shut = closed(Cutter(high))
    assert shut is not None and Cutter(shut).facts.skirt.slits == ()
    after = slit_over_leg(high)
    assert after is not None
    (slit,) = Cutter(after).facts.skirt.slits
    assert slit.place == "front" and slit.over == "left"


@pytest.mark.parametrize("part", [parted_slit, slit_over_leg])
def test_others_stay_as_they_are(part):
    assert part(draft("fitted-dress")) is None
    assert part(gown("back", 20.0)) is None
    assert part(gown("left", 12.0)) is None
    assert part(draft("jeans")) is None


def test_both_fronts_are_cut_away_beside_slits_at_both_sides():
    before = open_slit(Cutter(gown("left", 30.0)), "right", 30.0, 2.0)
    after = parted_sides(before)
    hems = [
        sum(p.edge_length(ref) for ref in Cutter(p).hem if ref.panel == "skirt_front")
        for p in (before, after)
    ]
    assert hems[0] - hems[1] > 10.0
    assert parted_sides(gown("left")) is None and parted_sides(draft("jeans")) is None


def test_a_slit_in_the_middle_of_the_front_becomes_a_wedge():
    after = parted_front(gown("front", 40.0))
    (slit,) = Cutter(after).facts.skirt.slits
    assert slit.place == "front" and slit.width > 8.0
    assert parted_front(gown("front", 12.0)) is None
