"""Instructions in languages that are read through tables alone."""

from __future__ import annotations

import re
from functools import cache
from pathlib import Path

import pytest

import swifttailor
from swifttailor.describing import Claim
from swifttailor.describing.differences import Change, Gain, Step
from swifttailor.describing.facts import GarmentFacts
from swifttailor.describing.measuring import measure_facts
from swifttailor.wishes.instructions.hearing_changes import hear_instruction
from swifttailor.wishes.instructions.one_meaning import in_one_meaning
from swifttailor.wishes.instructions.spoken_targets import clauses_of
from swifttailor.wishes.reader import WishReader

DRAFTS = {"dress": "fitted-dress", "top": "t-shirt", "trousers": "trousers"}
STEP = re.compile(r"(\w+)([+-])([\d.]*)")


def _rows():
    """Kind, changes and a text that asks for them."""
    for line in Path(__file__).with_name("foreign_changes.txt").read_text(encoding="utf-8").splitlines():
        said, colon, texts = line.partition(" : ")
        if colon and not line.startswith("#"):
            kind, *changes = said.split()
            yield from ((kind, changes, text.strip()) for text in texts.split("|"))


ROWS = [pytest.param(*row, id=row[2]) for row in _rows()]


def change(said: str) -> Change:
    step = STEP.fullmatch(said)
    if step is None:
        return Gain(Claim(*said.split("=")))
    return Step(step[1].replace("_", " "), 1 if step[2] == "+" else -1, float(step[3]) if step[3] else None)


@cache
def facts(kind: str) -> GarmentFacts:
    return measure_facts(swifttailor.draft(DRAFTS[kind]))


@pytest.fixture(scope="module")
def reader() -> WishReader:
    return WishReader.load()


@pytest.mark.parametrize(("kind", "changes", "text"), ROWS)
def test_changes_are_read_in_other_languages(reader, kind, changes, text):
    heard = hear_instruction(text, reader, facts(kind))
    assert {wish.change for wish in heard.sure} == {change(said) for said in changes}
    assert not heard.unread and not heard.clashes


@pytest.mark.parametrize(
    ("text", "language", "plain"),
    [
        ("più largo", "it", "più ampio"),
        ("le maniche larghe", "it", "le maniche ampie"),
        ("más largo", "es", "más largo"),
        ("mais largas", "pt", "mais amplas"),
        ("maak hem los", "nl", "maak het ruim"),
        ("langer aan de zoom", "nl", "longer aan de hem"),
        ("ein langer Rock", "de", "ein langer Rock"),
        ("the hem is los", "en", "the hem is los"),
        ("largos", "it", "largos"),
    ],
)
def test_words_that_mean_another_thing_elsewhere_are_replaced_in_their_language(text, language, plain):
    assert in_one_meaning(text, language) == plain


@pytest.mark.parametrize(
    ("text", "language", "clauses"),
    [
        ("korter en wijder", "nl", ["korter", "wijder"]),
        ("jupe en lin", "fr", ["jupe en lin"]),
        ("più corto e più largo", "it", ["più corto", "più largo"]),
        ("saia 10 cm mais longa", "pt", ["saia 10 cm mais longa"]),
        ("plus court mais ample", "fr", ["plus court", "ample"]),
    ],
)
def test_clauses_end_where_their_language_joins_them(text, language, clauses):
    assert [text[a:b] for a, b in clauses_of(text, language)] == clauses


@pytest.mark.parametrize(
    "text",
    ["non cambiare le maniche, solo la gonna più corta", "não mudes as mangas, só a saia mais curta"],
)
def test_what_is_to_stay_stays(reader, text):
    heard = hear_instruction(text, reader, facts("dress"))
    assert [wish.change for wish in heard.sure] == [Step("length", -1, None)]
    assert "sleeve length" in heard.kept
