"""Hearts and stars on the chest, and words and pictures that cannot be put there."""

from __future__ import annotations

import pytest

from swifttailor.wishes.descriptions.sayings_of_wishes import without_asides
from swifttailor.wording import read_words
from swifttailor.wording.lexicon import cannot_texts


@pytest.mark.parametrize(
    ("text", "trims"),
    [
        ("hoodie with a big heart on the front", ["chest heart"]),
        ("white tee with a red heart", ["chest heart"]),
        ("jumper with a star on the chest", ["chest star"]),
        ("jumper with a star on the sleeve", []),
        ("white tee with a black skull", []),
        ("dress with hearts", []),
        ("my heart is set on a dress", []),
    ],
)
def test_one_figure_is_put_on_and_a_pattern_of_them_is_printed(text, trims):
    reading = read_words(text)
    assert [
        name for mark in reading.marks for entry in mark.entries for name in entry.trims if "chest" in name
    ] == trims
    lettered = any(lack.what == "lettering" for lack in reading.lacks)
    assert lettered == (trims != [] or "sleeve" in text or "skull" in text)


@pytest.mark.parametrize(
    "text",
    [
        't-shirt that says "I love NY"',
        "t-shirt that says girl power",
        "football shirt with number 7 on the back",
        "hoodie with my name on the back",
    ],
)
def test_writing_is_told_and_its_words_are_no_wishes(text):
    plain = without_asides(text)
    assert plain.endswith("lettering") and "lettering" in cannot_texts()


def test_a_red_heart_is_red():
    [look] = [look for look in read_words("white tee with a red heart").looks if look.part == "motif"]
    assert look.color is not None and look.color.words == "red"
