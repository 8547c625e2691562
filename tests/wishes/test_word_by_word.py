"""Instructions in languages that have no lexicon."""

from __future__ import annotations

import pytest

from swifttailor.describing.differences import Step
from swifttailor.wishes.spoken_changes import spoken_changes
from swifttailor.wishes.word_by_word import in_english
from swifttailor.wording.lexicon import read_words


@pytest.mark.parametrize(
    ("text", "change"),
    [
        ("dłuższa spódnica", Step("length", 1)),
        ("rękawy o 5 cm krótsze", Step("sleeve length", -1, 5.0)),
        ("gör halsringningen lite djupare, annars är den bra som den är", Step("neck depth", 1)),
        ("lite kortare ärmar tack", Step("sleeve length", -1)),
        ("bredere skjørt", Step("skirt hem", 1)),
        ("højere krave", Step("collar height", 1)),
    ],
)
def test_a_few_words_are_enough_for_a_change(text, change):
    plain = in_english(text)
    assert change in spoken_changes(plain, read_words(plain, kind="dress"), "dress").changes


@pytest.mark.parametrize(
    "text", ["make the sleeves longer", "a den to sort in", "plus long, le dos", "więcej", ""]
)
def test_other_texts_stay_as_they_are(text):
    assert in_english(text) in (text, "more")
