"""Phrases that are known word for word."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from swifttailor.describing import Claim
from swifttailor.describing.differences import Gain, Step
from swifttailor.wishes.reader import WishReader
from swifttailor.wishes.text.mentions import find_mentions
from swifttailor.wishes.text.phrase_book import find_phrases
from swifttailor.wording.instructions.requests import step_words


def asked(text: str) -> list:
    return [change for phrase in find_phrases(text, find_mentions(text)) for change in phrase.changes]


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        ("Use fewer godets and make the hood roomier.", [Step("godets", -1), Step("hood depth", 1)]),
        ("Please increase the number of tiers.", [Step("tiers", 1)]),
        ("cut the back 16 cm higher", [Step("back depth", -1, 16.0)]),
        ("sew 2 inches of the back slit shut", [Step("back slit", -1, 5.08)]),
        ("Give it a lapel collar", [Gain(Claim("collar", "lapel"))]),
        ("make the hood lower, then lower the crown of the hood", [Step("hood height", -1)] * 2),
    ],
)
def test_phrases_mean_what_instructions_mean_by_them(text, meant):
    assert asked(text) == meant


@pytest.mark.parametrize(
    "text",
    ["don't use fewer godets", "never add a hood", "without a hood", "a refused fewer godetson", "", "\0"],
)
def test_what_is_negated_or_part_of_another_word_is_no_phrase(text):
    assert asked(text) == []


def test_the_longest_phrase_counts():
    # It begins with "lengthen the legs", which asks for no amount.
    assert asked("lengthen the legs by 15 cm") == [Step("leg length", 1, 15.0)]


@given(
    st.sampled_from(sorted(step_words())),
    st.integers(min_value=1, max_value=60),
    st.sampled_from(["", "Please ", "Could you "]),
)
def test_amounts_are_those_that_are_said(step, cm, before):
    quantity, direction = step
    for text in step_words()[step].texts_by:
        said = before + text.replace("{by}", f"{cm} cm").replace("{garment}", "dress")
        changes = asked(said.replace("{band}", "waistband"))
        assert changes in ([Step(quantity, direction, float(cm))], []), said


@given(st.text(max_size=200))
def test_any_text_can_be_looked_through(text):
    for phrase in find_phrases(text, find_mentions(text)):
        assert 0 <= phrase.start < phrase.end <= len(text)


def test_the_reader_is_sure_of_them():
    reader = WishReader.load()
    found = {
        w.change: w.certainty for w in reader.read("Now sew 21 cm of the back slit shut.", instruction=True)
    }
    assert found == {Step("back slit", -1, 21.0): 0.99}
    # A description is no instruction.
    assert not any(isinstance(w.change, Step) for w in reader.read("use fewer godets"))
