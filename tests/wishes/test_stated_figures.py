"""Figures beside words about the same thing."""

from __future__ import annotations

import pytest

import swifttailor
from swifttailor.describing import Claim
from swifttailor.describing.differences import Gain, Step
from swifttailor.describing.dimensions import QUANTITIES
from swifttailor.describing.measuring import measure_facts
from swifttailor.wishes.instructions.stated_figures import (
    by_the_number,
    is_stated,
    to_the_number,
    without_steps_to,
)


@pytest.fixture(scope="module")
def shirt():
    return measure_facts(swifttailor.draft("t-shirt"))


def test_a_number_below_what_is_there_is_by_how_much(shirt):
    deeper, three = Step("neck depth", 1), Gain(Claim("neck_depth_cm", 3.0))
    assert by_the_number([deeper, three], shirt) == [Step("neck depth", 1, 3.0)]
    assert by_the_number([Step("neck depth", 1, 3.0), three], shirt) == [Step("neck depth", 1, 3.0)]
    to_thirty = [deeper, Gain(Claim("neck_depth_cm", 30.0))]
    assert by_the_number(to_thirty, shirt) == to_thirty
    higher = [Step("neck depth", -1), three]
    assert by_the_number(higher, shirt) == higher, "3 cm is where a neckline that is raised may end"
    assert by_the_number([three], shirt) == [three], "nobody said deeper"


def test_what_nearly_holds_is_led_to_the_figure():
    trousers = measure_facts(swifttailor.draft("trousers"))
    now = QUANTITIES["leg end"].of(trousers)
    near, there, far = (Gain(Claim("leg_width_cm", round(now + off, 2))) for off in (2.0, 0.3, 20.0))
    assert to_the_number([near], trousers) == [Step("leg end", 1, pytest.approx(2.0, abs=0.02))]
    assert to_the_number([there, far], trousers) == [there, far]
    words = Gain(Claim("legs", "straight"))
    assert to_the_number([words], trousers) == [words]


def test_what_is_said_in_figures_needs_no_word():
    band = [Gain(Claim("waistband_cm", 6.0))]
    assert is_stated(Gain(Claim("waistband", "wide")), band)
    assert is_stated(Step("waistband height", 1), band)
    assert not is_stated(Gain(Claim("waistband", "none")), band)
    assert not is_stated(Gain(Claim("sleeves", "long")), band)
    assert not is_stated(Step("length", 1), band)


def test_a_step_by_so_much_replaces_one_of_no_amount():
    by = Step("length", -1, 8.0)
    assert without_steps_to([Step("length", -1), by]) == [by]
    assert without_steps_to([Step("length", 1), by]) == [Step("length", 1), by], (
        "the opposite is another matter"
    )
