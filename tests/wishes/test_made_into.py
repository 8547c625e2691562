"""Garments that are to become dresses."""

from __future__ import annotations

import pytest

from swifttailor.wishes.descriptions.made_into import made_into_a_dress


@pytest.mark.parametrize(
    ("text", "read"),
    [
        ("my dad's old cardigan but as a dress", "a cardigan dress"),
        ("jumper as a dress, navy", "a jumper dress, navy"),
        ("a red t-shirt but make it a dress", "a red t-shirt dress"),
        ("a denim jacket but as a dress", "a denim jacket dress"),
        ("trench coat turned into a dress", "a trench coat dress"),
        ("a dress like a cardigan", "a cardigan dress"),
        ("a polo shirt but dress length", "a polo shirt dress"),
    ],
)
def test_a_garment_that_becomes_a_dress_is_named_so(text: str, read: str) -> None:
    assert made_into_a_dress(text) == read


@pytest.mark.parametrize(
    "text",
    ["a dress like a cloud", "wear it as a dress", "as comfortable as a dress", "a skirt but a dress shirt"],
)
def test_other_texts_stay(text: str) -> None:
    assert made_into_a_dress(text) == text
