"""Briefs that bare the seat, bustiers on straps, hoodies without sleeves."""

from __future__ import annotations

import pytest
from shapely.geometry import Polygon

from swifttailor import draft
from swifttailor.describing import Claim, measure_facts


def _area(pattern, name):
    return Polygon(pattern.panel(name).outline(0.3)).area


@pytest.mark.parametrize("leg_height", [-2.0, 1.0, 10.0])
@pytest.mark.parametrize("below_waist", [0.0, 16.0])
def test_a_thong_bares_the_seat_and_nothing_else(leg_height, below_waist):
    options = {"leg_height": leg_height, "below_waist": below_waist}
    full, some, bare = [draft("briefs", seat=seat, **options) for seat in (1.0, 0.5, 0.0)]
    areas = [_area(each, "pant_b_l") for each in (full, some, bare)]
    assert areas[0] > areas[1] > areas[2] > 0.2 * areas[0]
    assert _area(full, "pant_f_l") == pytest.approx(_area(bare, "pant_f_l"))


def test_a_bustier_hangs_on_straps_where_it_is_to():
    facts = measure_facts(draft("bustier", straps=True))
    told = [("straps", "narrow"), ("bodice", "darted"), ("fit", "close"), ("sleeves", "none")]
    assert all(Claim(*claim).holds(facts) for claim in told)
    assert not Claim("straps", "narrow").holds(measure_facts(draft("bustier")))


def test_a_hoodie_may_have_no_sleeves():
    facts = measure_facts(draft("hoodie", sleeves=False))
    assert Claim("sleeves", "none").holds(facts) and Claim("hood", "hood").holds(facts)
