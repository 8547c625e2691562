"""Numbers in texts."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from swifttailor.wishes.text.mentions import find_mentions
from swifttailor.wording.numbers import say_measure


@pytest.mark.parametrize(
    ("text", "found"),
    [
        ("92 cm long", [("92 cm", 92.0, True)]),
        ("sleeves of 6 inches", [("6 inches", 15.24, True)]),
        ('a 3 1/2" cuff', [('3 1/2"', 8.89, True)]),
        ("1/2 inch up", [("1/2 inch", 1.27, True)]),
        ("a 30-cm hem", [("30-cm", 30.0, True)]),
        ("61cm around", [("61cm", 61.0, True)]),
        ("1,5 m of cloth", [("1,5 m", 150.0, True)]),
        ("80 centimetres, 75 millimeters", [("80 centimetres", 80.0, True), ("75 millimeters", 7.5, True)]),
        ("three tiers and 6 gores", [("three", 3.0, False), ("6", 6.0, False)]),
        ("make it 15 longer", [("15", 15.0, False)]),
        ("12 in the front", [("12", 12.0, False)]),
        ("A4 paper, a 2in1, v2.0x and 1/0 of it", [("1/0", 1.0, False)]),
        ("someone, threesome", []),
        ("half a metre long", [("half a metre", 50.0, True)]),
        ("a quarter of an inch", [("a quarter of an inch", 0.635, True)]),
        ("about one foot, or 2 ft", [("one foot", 30.48, True), ("2 ft", 60.96, True)]),
        ("a five-inch band", [("five-inch", 12.7, True)]),
        ("half a dress, the left foot", []),
        ("", []),
    ],
)
def test_numbers_and_their_units_are_found(text, found):
    mentions = find_mentions(text)
    assert [(text[m.start : m.end], pytest.approx(m.value), m.is_length) for m in mentions] == found


@given(
    value=st.floats(1.0, 400.0),
    units=st.sampled_from(["cm", "inches"]),
    before_noun=st.booleans(),
    rng=st.randoms(use_true_random=False),
)
def test_every_way_of_captions_to_say_a_length_is_read_again(value, units, before_noun, rng):
    said = say_measure("sleeve_cm", value, units, rng, before_noun=before_noun)
    (mention,) = find_mentions(f"with {said.text} sleeves")
    assert mention.is_length
    assert mention.value == pytest.approx(said.claim.value, abs=0.01)


@given(st.text(max_size=300))
def test_any_text_is_searched(text):
    last = 0
    for mention in find_mentions(text):
        assert last <= mention.start < mention.end <= len(text)
        assert 0.0 <= mention.value <= 1e7
        last = mention.end


def test_number_words_go_with_short_units():
    assert [(m.value, m.is_length) for m in find_mentions("two cm longer sleeves")] == [(2.0, True)]
