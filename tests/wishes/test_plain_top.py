"""Where words tell something but name no garment, a plain top is begun from."""

from __future__ import annotations

import pytest

from swifttailor.wishes.descriptions.hearing import hear_description
from swifttailor.wishes.reader import WishReader


@pytest.fixture(scope="module")
def reader():
    return WishReader.load()


@pytest.mark.parametrize("text", ["a red one", "puff sleeves", "cotton"])
def test_a_plain_top_has_what_is_told(reader, text):
    (draft,) = hear_description(text, reader).drafts
    assert draft.name == "t-shirt"
    assert (dict(draft.options).get("sleeve_shape") == "puffed") == (text == "puff sleeves")


@pytest.mark.parametrize("text", ["a wuzzle", "czarna brzydula", ""])
def test_of_what_is_not_known_nothing_is_made_up(reader, text):
    assert hear_description(text, reader).drafts == ()


def test_a_dirndl_with_an_apron_is_no_apron(reader):
    names = {draft.name for draft in hear_description("Dirndl mit Schürze", reader).drafts}
    assert names and "apron" not in names
    assert {draft.name for draft in hear_description("eine Schürze", reader).drafts} == {"apron"}
