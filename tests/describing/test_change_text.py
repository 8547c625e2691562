"""Changes written down briefly."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from swifttailor.describing import CLAIM_TYPES, Claim
from swifttailor.describing.change_text import read_change
from swifttailor.describing.differences import QUANTITIES, Gain, Step
from swifttailor.errors import InputError

WORDS = [(name, word) for name, kind in CLAIM_TYPES.items() for word in kind.words]
NUMBERS = [name for name, kind in CLAIM_TYPES.items() if not kind.words]


@given(st.sampled_from(WORDS))
def test_every_claim_can_be_written(claim):
    name, word = claim
    assert read_change(f"{name}={word}") == read_change(f" {name} = {word} ") == Gain(Claim(name, word))


@given(st.sampled_from(NUMBERS), st.integers(1, 200))
def test_every_number_can_be_written(name, number):
    assert read_change(f"{name}={number}") == Gain(Claim(name, float(number)))


@given(st.sampled_from(list(QUANTITIES)), st.sampled_from("+-"), st.one_of(st.none(), st.integers(1, 80)))
def test_every_step_can_be_written(name, sign, amount):
    wanted = Step(name, 1 if sign == "+" else -1, amount)
    assert read_change(f"{name} {sign}{'' if amount is None else amount}") == wanted
    assert read_change(f"{name}{sign} {'' if amount is None else amount}") == wanted


def test_what_is_a_change_already_stays():
    claim, step = Claim("sleeves", "long"), Step("length", 1)
    assert read_change(step) is step
    assert read_change(claim) == Gain(claim) == read_change(Gain(claim))


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("longer", r"no change of a garment\. Accepted: 'claim=value'"),
        ("", "no change"),
        ("sleeves=purple", r"'sleeves' has no value 'purple'\. Known: .*long"),
        ("sleeve_cm=long", "a number is expected after '=', received 'long'"),
        ("colour=red", "no claim 'colour'"),
        ("girth +3", r"no quantity 'girth'\. Known: .*length"),
        ("length ++3", "no change"),
    ],
)
def test_other_texts_are_refused(text, says):
    with pytest.raises(InputError, match=says):
        read_change(text)
