"""Whole wishes in languages that are read through tables alone, with all that they say."""

from __future__ import annotations

from pathlib import Path

import pytest

from swifttailor.describing.claims import Claim
from swifttailor.wording.claim_marks import claims_in
from swifttailor.wording.lexicon import WordReading, foreign_language, read_words
from swifttailor.wording.lexicon.vocabulary import vocabulary
from swifttailor.wording.word_tables import Row, read_table

TABLE = Path(__file__).with_name("foreign_wishes.txt")
WISHES = [pytest.param(row, text, id=text) for row in read_table(TABLE) for text in row.texts]
LEAST = 25
"""Wishes of each language."""


def told(row: Row, mark: str) -> set[str]:
    return {value.replace("_", " ") for value in row.options.get(mark, ())}


def certain(reading: WordReading) -> set[Claim]:
    return {each.claim for each in reading.implications if each.certainty == "certain"}


def rgb_of(color: str) -> str:
    (entry,) = [s.entry for s in vocabulary("en").find(color.split()) if s.entry.color is not None]
    assert entry.color is not None
    return entry.color


@pytest.mark.parametrize(("row", "text"), WISHES)
def test_a_wish_says_all_that_it_says_and_nothing_else(row, text):
    reading = read_words(text)
    assert reading.language == row.section
    assert not reading.unknown and not reading.contradictions
    assert certain(reading) == set(claims_in(row, row.claims))
    assert {color.rgb for color in reading.colors} == {rgb_of(color) for color in told(row, "color")}
    assert {found.kind for found in reading.prints} == told(row, "print")
    assert set(reading.cloths) == told(row, "cloth")
    assert {lack.what for lack in reading.lacks if lack.said} >= told(row, "cannot")
    assert set(reading.never) >= set(claims_in(row, row.options.get("not", ())))


@pytest.mark.parametrize("language", ["it", "nl", "pt"])
def test_many_wishes_are_tried_in_each_language(language):
    texts = [text for row in read_table(TABLE) if row.section == language for text in row.texts]
    assert len(set(texts)) >= LEAST


@pytest.mark.parametrize(
    ("text", "language"),
    [
        ("gonna", "it"),
        ("gonna midi", "it"),
        ("gonna lunga 70 cm", "it"),
        ("gonna go shorter", "en"),
        ("I'm gonna need a red skirt", "en"),
        ("make em flares", "en"),
        ("ad a turtelneck", "en"),
        ("nee", "en"),
        ("lose sleeves", "en"),
        ("vest", "en"),
        ("vest met rits", "nl"),
        ("top", "en"),
        ("top met lange mouwen", "nl"),
        ("lange Jeans", "de"),
        ("die Hose", "de"),
        ("die broek", "nl"),
        ("jupe plissée", "fr"),
        ("vestido con mangas", "es"),
        ("vestido com mangas", "pt"),
        ("camisa blanca", "es"),
        ("camisa branca", "pt"),
        ("camicia bianca", "it"),
    ],
)
def test_words_that_languages_share_are_of_the_one_that_knows_the_rest(text, language):
    assert read_words(text).language == language


@pytest.mark.parametrize(
    ("text", "language"),
    [
        ("czarna sukienka do kolan bez rękawów", "Polish"),
        ("en klänning med långa ärmar", "Swedish"),
        ("lang kjole med korte ærmer", "Danish"),
        ("黒いロングスカート", "Japanese"),
        ("半袖のワンピース", "Japanese"),
    ],
)
def test_languages_that_are_not_read_are_not_taken_for_those_that_are(text, language):
    reading = read_words(text)
    assert foreign_language(text, reading.unknown) == language
    assert reading.language not in ("it", "nl", "pt")


@pytest.mark.parametrize(
    ("text", "halves"),
    [
        ("katoenjurk", ("katoen", "jurk")),
        ("zomerbroek", ("zomer", "broek")),
        ("fluwelenjasje", ("fluwelen", "jasje")),
    ],
)
def test_dutch_compounds_of_two_words_are_both(text, halves):
    reading = read_words(text)
    assert reading.language == "nl" and not reading.unknown
    assert tuple(mark.word for mark in reading.marks) == halves


@pytest.mark.parametrize(
    "text", ["abito con l'orlo asimmetrico", "abito con lo scollo all'americana", "un'ampia gonna sull'orlo"]
)
def test_italian_elisions_are_parted(text):
    reading = read_words(text)
    assert reading.language == "it" and not reading.unknown
