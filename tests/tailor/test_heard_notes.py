"""What a person is told of the language of a text."""

from __future__ import annotations

import pytest

from swifttailor.tailor import Order
from swifttailor.tailor.heard_notes import heard_notes
from swifttailor.tailor.reading import Wanted
from swifttailor.wishes.heard import Heard
from swifttailor.wording.lexicon import read_words


def notes_on(text):
    words = read_words(text)
    heard = Heard(text, words=words, unread=words.unknown)
    return " ".join(heard_notes(Wanted(Order(text), text, heard=heard)))


@pytest.mark.parametrize(
    ("text", "language"),
    [
        ("ein rotes Kleid", "German"),
        ("une robe rouge", "French"),
        ("un vestido rojo", "Spanish"),
        ("un vestito rosso", "Italian"),
        ("een rode jurk", "Dutch"),
        ("um vestido vermelho", "Portuguese"),
    ],
)
def test_the_language_that_a_text_was_read_in_is_told(text, language):
    assert f"Read as {language}," in notes_on(text) and "not read" not in notes_on(text)


def test_nothing_is_told_of_english():
    assert "Read as" not in notes_on("a red dress")


@pytest.mark.parametrize(
    ("text", "language"), [("黒いロングスカート", "Japanese"), ("czarna sukienka do kolan", "Polish")]
)
def test_who_writes_in_another_language_is_told_which_are_read(text, language):
    notes = notes_on(text)
    assert f"This seems to be {language}, which is not read." in notes
    assert "German, French, Spanish, Italian, Dutch and Portuguese by their words of clothes" in notes
