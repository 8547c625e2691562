"""Sleeves that are not to be set in."""

from __future__ import annotations

import pytest

from swifttailor.pattern.drafts import draft
from swifttailor.wishes.descriptions.hearing import hear_description
from swifttailor.wishes.reader import WishReader


@pytest.fixture(scope="module")
def reader() -> WishReader:
    return WishReader.load()


@pytest.mark.parametrize(
    "text", ["Nothing with set-in sleeves, they pinch me. A loose shirt", "no set-in sleeves, a coat"]
)
def test_set_in_sleeves_that_are_refused_are_raglan(reader: WishReader, text: str) -> None:
    heard = hear_description(text, reader)
    options = dict(heard.drafts[0].options)
    assert options["armhole"] == "raglan" and "set-in sleeves" not in heard.unread
    draft(heard.drafts[0].name, **options)


def test_others_that_are_named_win(reader: WishReader) -> None:
    heard = hear_description("a jumper without set-in sleeves, with batwing sleeves", reader)
    assert dict(heard.drafts[0].options)["armhole"] == "cut-in-one"
