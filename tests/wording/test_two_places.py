"""Words that are said of two places contradict nothing."""

from __future__ import annotations

import pytest

from swifttailor.wording.lexicon import read_words


@pytest.mark.parametrize(
    "text",
    [
        "V neck in front, round neck behind",
        "sleeves tight above, loose below, a dress close at the top and loose at the bottom",
        "fitted on top and oversized at the hem dress",
    ],
)
def test_of_two_places_both_can_be_true(text):
    assert read_words(text).contradictions == ()


@pytest.mark.parametrize(
    "text",
    [
        "V neck, round neck",
        "sleeveless dress with puffed sleeves",
        "a backless top with a high closed back",
        "tight but loose top",
        "a short maxi dress",
        "a V neck in front and a round neck in front",
    ],
)
def test_of_one_place_they_contradict_each_other(text):
    assert read_words(text).contradictions


@pytest.mark.parametrize(
    ("text", "hem"), [("a long skirt to the knee", "knee"), ("long loose coat, mid calf length", "midi")]
)
def test_long_gives_way_to_what_is_exact(text, hem):
    read = read_words(text)
    assert [i.claim.value for i in read.implications if i.claim.name == "skirt_hem"] == [hem]
    assert read.contradictions == ()
