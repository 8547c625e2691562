"""How long sleeves are is said of the one arm that has one."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from swifttailor.describing import Claim
from swifttailor.describing.claims import CLAIM_TYPES
from swifttailor.describing.differences import Gain
from swifttailor.wishes.corrections.closed_behind import without_opposites
from swifttailor.wishes.corrections.one_arm import of_one_arm, without_guessed_length
from swifttailor.wishes.reader import Wish
from swifttailor.wording.lexicon import read_words

LENGTHS = ("cap", "short", "elbow", "three-quarter", "long", "extra-long")
NOT_LENGTHS = [
    Claim(kind.name, value)
    for kind in CLAIM_TYPES.values()
    for value in kind.words
    if not (kind.name == "sleeves" and value in LENGTHS)
]


def wish(name, value):
    return Wish(Gain(Claim(name, value)), 0.9)


def claims(wishes):
    return {f"{w.change.claim.name}={w.change.claim.value}" for w in of_one_arm(wishes)}


@pytest.mark.parametrize("length", LENGTHS)
@pytest.mark.parametrize(
    ("name", "value", "side"),
    [
        ("sleeves", "left only", "left"),
        ("sleeves", "right only", "right"),
        ("shoulders", "bare right", "left"),
        ("shoulders", "bare left", "right"),
    ],
)
def test_the_length_is_that_of_the_only_sleeve(length, name, value, side):
    found = claims([wish("sleeves", length), wish(name, value)])
    assert found == {f"{name}={value}", f"sleeves={side} only", f"{side}_sleeve={length}"}


def test_a_bare_shoulder_without_sleeves_has_none():
    wishes = [wish("shoulders", "bare right"), wish("sleeves", "none")]
    assert of_one_arm(wishes) == tuple(wishes)


@given(st.lists(st.sampled_from(NOT_LENGTHS), unique=True))
def test_other_wishes_stay_as_they_are(said):
    wishes = tuple([Wish(Gain(claim), 0.9) for claim in said])
    assert of_one_arm(wishes) == wishes


@given(st.sampled_from(LENGTHS), st.lists(st.sampled_from(NOT_LENGTHS), unique=True))
def test_sleeves_stay_those_of_both_arms_where_both_have_one(length, said):
    kept = [c for c in said if c.name not in ("sleeves", "shoulders")]
    wishes = (wish("sleeves", length), *[Wish(Gain(claim), 0.9) for claim in kept])
    assert of_one_arm(wishes) == wishes


@pytest.mark.parametrize(
    ("text", "lengths"),
    [
        ("a shirt with one sleeve", set()),
        ("a top with one sleeve", set()),
        ("a top with one sleeve to the blorf", {"short", "long"}),
        ("a shirt with two sleeves", {"short", "long"}),
    ],
)
def test_no_length_is_guessed_of_the_only_sleeve(text, lengths):
    """The draft decides it; unknown words may say one."""
    found = [wish("sleeves", "right only"), wish("right_sleeve", "short"), wish("right_sleeve", "long")]
    left = without_guessed_length(found, read_words(text))
    assert {w.change.claim.value for w in left} == {"right only", *lengths}


@pytest.mark.parametrize(
    "text",
    [
        "a techwear jacket with an asymmetrical zip and a high funnel neck",
        "a coat with an asymmetric closure",
        "a jacket, off centre zip, long sleeves",
        "a black top with asymmetrical buttons",
    ],
)
def test_closings_to_one_side_say_nothing_of_sides_and_sleeves(text):
    words = read_words(text)
    heard = (wish("sides", "different"), wish("sleeves", "unequal"), wish("collar", "stand"))
    kept = {w.change.claim.name for w in without_opposites(heard, words)}
    assert kept == {"collar"}


@pytest.mark.parametrize(
    ("text", "kept"),
    [
        ("longline cardigan, open", set()),
        ("a blazer, worn open", set()),
        ("a cardigan with an open back", {"back_depth"}),
        ("a dress, open back", {"back_depth"}),
    ],
)
def test_what_opens_in_front_is_open_there(text, kept):
    heard = (wish("back_depth", "open"),)
    assert {w.change.claim.name for w in without_opposites(heard, read_words(text))} == kept
