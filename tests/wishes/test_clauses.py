"""Instructions of several requests."""

from __future__ import annotations

import pytest

from swifttailor.describing import Claim
from swifttailor.describing.differences import Gain, Step
from swifttailor.wishes.reader import SURE, WishReader
from swifttailor.wishes.text.clauses import clauses

LONGER, LONG = Step("length", 1, 20.0), Gain(Claim("sleeves", "long"))


@pytest.fixture(scope="module")
def reader() -> WishReader:
    return WishReader.load()


@pytest.mark.parametrize(
    ("text", "parts"),
    [
        ("make it longer", ["make it longer"]),
        ("give it long sleeves and make it longer", ["give it long sleeves", "make it longer"]),
        ("Shorten it, then add a hood.", ["Shorten it", "add a hood."]),
        ("remove the sleeves and the collar", ["remove the sleeves and the collar"]),
        ("make it 5 cm wider and 10 cm longer", ["make it 5 cm wider", "10 cm longer"]),
        ("make it shorter and the sleeves wider", ["make it shorter", "the sleeves wider"]),
        ("no sleeves, but longer", ["no sleeves", "longer"]),
        ("", []),
        (" , and ", [" , and "]),
    ],
)
def test_a_clause_begins_where_an_instruction_could(text, parts):
    assert [text[start:end] for start, end in clauses(text)] == parts


@pytest.mark.parametrize(
    "text",
    [
        "give it long sleeves and make it 20 cm longer",
        "make it 20 cm longer and give it long sleeves",
        "add long sleeves, and lengthen it by 20 cm",
        "lengthen it by 20 cm, then give it long sleeves",
        "make it 20 cm longer, with long sleeves",
    ],
)
def test_no_request_is_lost_to_another(reader, text):
    sure = {w.change for w in reader.read(text, instruction=True) if w.certainty >= SURE}
    assert sure == {LONGER, LONG}


def test_each_number_goes_with_its_own_request(reader):
    text = "make it 10 cm shorter and the sleeves 5 cm longer"
    sure = {w.change for w in reader.read(text, instruction=True) if w.certainty >= SURE}
    assert sure == {Step("length", -1, 10.0), Step("sleeve length", 1, 5.0)}


def test_many_clauses_take_bounded_time(reader, monkeypatch):
    read = []
    real = WishReader._read
    monkeypatch.setattr(WishReader, "_read", lambda self, *given: read.append(given) or real(self, *given))
    reader.read("make it longer and " * 2000, instruction=True)
    assert len(read) <= 17
