"""Colours that go with names where a text says none."""

from __future__ import annotations

import pytest

from swifttailor.wording import read_words
from swifttailor.wording.lexicon import usual_color


def colors(text: str) -> set[str | None]:
    return {usual_color(mark.word, entry) for mark in read_words(text).marks for entry in mark.entries} - {
        None
    }


@pytest.mark.parametrize(
    ("text", "color"),
    [
        ("a gymslip", "1f2a44"),
        ("alb", "f7f6f2"),
        ("nun's habit", "18181b"),
        ("two doboks", "f4f2ec"),
        ("Wednesday Addams style", "18181b"),
        ("made of suede", "8f6a47"),
        ("school trousers", "3c3f45"),
        ("jeans", "3b5578"),
        ("qipao", "a9202b"),
        ("taekwondo pants", "f1efe8"),
    ],
)
def test_names_have_the_colours_that_people_picture(text, color):
    assert color in colors(text)


def test_words_of_other_languages_have_those_of_the_english_ones():
    assert colors("eine Lederhose") == colors("lederhosen") == {"5f442c"}
