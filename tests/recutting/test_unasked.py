"""What nobody asked to change stays."""

from __future__ import annotations

import pytest

import swifttailor
from swifttailor.describing.claims import Claim
from swifttailor.describing.differences import Gain, Step
from swifttailor.describing.measuring import measure_facts
from swifttailor.recutting.alter import alter
from swifttailor.recutting.nearer import towards
from swifttailor.recutting.unasked import Keep, spoken_parts, unasked

WISHES = (
    Step("length", 1, 10.0),
    Step("neck depth", 1),
    Step("sleeve length", -1),
    Step("chest", 1),
    Step("skirt hem", 1),
    Step("bodice length", -1, 6.0),
    Gain(Claim("sleeves", "none")),
    Gain(Claim("neckline", "v")),
    Gain(Claim("waistband", "waist")),
    Gain(Claim("hem_shape", "high-low")),
    Gain(Claim("collar", "stand")),
)


@pytest.mark.parametrize("name", ["fitted-dress", "t-shirt", "circle-skirt"])
@pytest.mark.parametrize("wish", WISHES, ids=str)
def test_no_cut_is_seen_in_parts_that_no_wish_speaks_of(name, wish):
    pattern = swifttailor.draft(name)
    before = measure_facts(pattern)
    altered = alter(pattern, [wish], keep_others=True)
    assert unasked(spoken_parts([wish]), before, measure_facts(altered.pattern)) == ()
    assert bool(altered.cuts) == (altered.pattern is not pattern)


def test_a_measure_that_is_told_to_stay_is_cut_back():
    dress = swifttailor.draft("fitted-dress")
    before = measure_facts(dress)
    wish = Step("bodice length", 1, 4.0)
    altered = alter(dress, [wish], keep_others=True, kept=["length"])
    after = measure_facts(altered.pattern)
    assert Keep("length", within=1.0).holds(before, after)
    assert wish in altered.open or wish.holds(before, after)


def test_wishes_about_all_of_a_garment_leave_no_part_out():
    assert spoken_parts([Gain(Claim("kind", "skirt"))]) is None
    assert unasked(None, *[measure_facts(swifttailor.draft(n)) for n in ("t-shirt", "circle-skirt")]) == ()


def test_one_side_may_differ_where_one_side_is_asked_for():
    assert "sides" in (spoken_parts([Gain(Claim("shoulders", "bare left"))]) or ())
    assert "sides" not in (spoken_parts([Gain(Claim("neckline", "v"))]) or ())


def test_what_cannot_be_reached_is_approached_unless_its_measure_is_told():
    wide = Gain(Claim("legs", "wide"))
    assert towards([wide], [wide]) == [Step("leg end", 1)]
    assert towards([wide], [wide, Step("leg end", -1)]) == []
    assert towards([Gain(Claim("godets", 5.0))], []) == []


def test_small_amounts_do_not_hold_of_what_stayed_as_it_was():
    facts = measure_facts(swifttailor.draft("fitted-dress"))
    assert not Step("neck width", 1, 1.0).holds(facts, facts)
