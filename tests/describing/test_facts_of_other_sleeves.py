"""What is measured of raglan sleeves and of sleeves that are cut in one with the body."""

from __future__ import annotations

import pytest

from swifttailor.describing import Claim
from swifttailor.describing.differences import Gain
from swifttailor.describing.measuring import measure_facts
from swifttailor.pattern.drafts import draft
from swifttailor.recutting import alter


@pytest.mark.parametrize(
    ("name", "options"),
    [
        ("t-shirt", {}),
        ("t-shirt", {"neckline": "v", "neck_depth": 16.0}),
        ("t-shirt", {"neckline": "square", "neck_depth": 14.0}),
        ("sweatshirt", {"collar": "rolled"}),
        ("sweatshirt", {"collar": "standing"}),
        ("hoodie", {}),
        ("coat", {}),
        ("coat", {"standing": True}),
    ],
)
def test_raglan_garments_measure_as_those_with_set_in_sleeves(name, options):
    set_in, raglan = (measure_facts(draft(name, armhole=a, **options)) for a in ("set-in", "raglan"))
    assert raglan.kind == set_in.kind and not raglan.strapless
    for face in ("front_neck", "back_neck"):
        own, other = getattr(raglan, face), getattr(set_in, face)
        assert own.shape == other.shape
        assert own.depth == pytest.approx(other.depth, abs=0.1)
        assert own.width == pytest.approx(other.width, abs=0.1)
    assert raglan.torso.chest == pytest.approx(set_in.torso.chest, abs=0.5)
    assert raglan.hem.level == pytest.approx(set_in.hem.level, abs=1.5)
    assert raglan.left_sleeve.length == pytest.approx(set_in.left_sleeve.length, abs=1.0)
    assert (raglan.collar is None) == (set_in.collar is None)
    if raglan.collar is not None:
        assert raglan.collar.kind == set_in.collar.kind
    assert raglan.torso.left_armhole is None


def test_raglan_shoulders_are_found_after_the_chest_was_widened():
    pattern = draft("sweatshirt", armhole="raglan")
    wide = alter(pattern, [Gain(Claim("fit", "oversized"))]).pattern
    assert Claim("shoulders", "both").holds(measure_facts(wide))


@pytest.mark.parametrize("armhole", ["raglan", "cut-in-one"])
def test_sleeves_that_carry_the_shoulders_are_not_taken_off(armhole):
    pattern = draft("sweatshirt", armhole=armhole)
    after = alter(pattern, [Gain(Claim("sleeves", "none"))])
    assert not after.cuts and Claim("shoulders", "both").holds(measure_facts(after.pattern))


def test_set_in_sleeves_still_are():
    after = alter(draft("sweatshirt"), [Gain(Claim("sleeves", "none"))])
    assert Claim("sleeves", "none").holds(measure_facts(after.pattern))


@pytest.mark.parametrize(
    ("length", "end", "value"), [(22.0, 36.0, "short"), (46.0, 28.0, "three-quarter"), (60.0, 24.0, "long")]
)
def test_sleeves_cut_in_one_count_as_sleeves(length, end, value):
    facts = measure_facts(
        draft(
            "t-shirt", armhole="cut-in-one", sleeve_length=length, sleeve_end=end, wing=18.0, chest_ease=12.0
        )
    )
    assert Claim("sleeves", value).holds(facts) and not Claim("sleeves", "none").holds(facts)
    assert Claim("shoulders", "both").holds(facts) and facts.torso.left_armhole is None
    assert (
        facts.torso.left_shoulder == pytest.approx(facts.torso.right_shoulder)
        and facts.torso.left_shoulder < 12.0
    )
    assert facts.torso.chest_ease == pytest.approx(12.0, abs=2.0), "what hangs beside the body does not count"


def test_chests_of_overlapping_fronts_leave_out_such_sleeves_too():
    set_in, in_one = (measure_facts(draft("coat", armhole=a)).torso for a in ("set-in", "cut-in-one"))
    assert in_one.chest == pytest.approx(set_in.chest, abs=3.0)
