"""Colours of which no more is told than how they are."""

from __future__ import annotations

import pytest

from swifttailor.wishes.looks.shades_alone import shade_alone
from swifttailor.wording.lexicon import read_words


@pytest.mark.parametrize(
    ("text", "rgb"),
    [
        ("a dark coat", "26272d"),
        ("a dress in a bright colour", "e4572e"),
        ("happy colours please, a dress", "e4572e"),
        ("a skirt in earth tones", "9a5f3c"),
        ("Kleid in dunklen Farben", "26272d"),
        ("vestido de colores vivos", "e4572e"),
        ("a bright red dress", None),
        ("a dark floral dress", None),
        ("not too bright, a shirt", None),
        ("a dress with dark sleeves", None),
        ("a light summer dress", None),
    ],
)
def test_how_a_colour_is_tells_one_where_none_is_named(text: str, rgb: str | None) -> None:
    assert shade_alone(read_words(text)) == rgb


def test_many_colours_are_a_print() -> None:
    for text in ("a colourful skirt", "ein buntes Kleid", "une robe multicolore"):
        assert [one.kind for one in read_words(text).prints] == ["motif"]
