"""Two sides that differ made alike."""

import pytest

from swifttailor import draft
from swifttailor.describing.claims import Claim
from swifttailor.describing.differences import Gain
from swifttailor.describing.measuring import measure_facts
from swifttailor.recutting import alter

ALIKE = Gain(Claim("sides", "alike"))


def lopsided(side):
    return alter(draft("t-shirt"), [f"sleeves={side} only"]).pattern


@pytest.mark.parametrize("side", ["left", "right"])
def test_a_lone_sleeve_gets_a_second_one(side, sound):
    pattern = lopsided(side)
    assert not ALIKE.holds(measure_facts(pattern), measure_facts(pattern))
    altered = alter(pattern, [ALIKE])
    facts = sound(pattern, altered).facts
    assert facts.left_sleeve and facts.right_sleeve
    assert facts.left_sleeve.length == pytest.approx(facts.right_sleeve.length, abs=0.1)


@pytest.mark.parametrize("side", ["left", "right"])
def test_what_was_longer_stays_as_it_was(side):
    pattern = draft("t-shirt", sleeve_length=40.0)
    other = "right" if side == "left" else "left"
    short = alter(pattern, [f"{other}_sleeve=short"]).pattern
    facts = alter(short, [ALIKE]).facts
    kept = getattr(measure_facts(short), f"{side}_sleeve")
    for sleeve in (facts.left_sleeve, facts.right_sleeve):
        assert sleeve is not None and sleeve.length == pytest.approx(kept.length, abs=0.1)


def test_what_is_alike_is_left_alone():
    assert alter(draft("t-shirt"), [ALIKE]).cuts == ()
