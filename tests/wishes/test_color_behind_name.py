"""A colour right behind a garment's name, before a detail that has no colour of its own."""

from __future__ import annotations

import pytest

from swifttailor.wishes.looks.color_of_bodies import color_behind_name
from swifttailor.wording.lexicon import read_words


@pytest.mark.parametrize(
    ("text", "color"),
    [
        ("work trousers women navy elasticated waist", "1f2a44"),
        ("skirt red side slit", "ab252e"),
        ("dress with a red slit", None),
        ("trousers with a navy elasticated waist", None),
        ("joggers white drawstring", None),
    ],
)
def test_it_is_the_garments(text, color):
    assert color_behind_name(read_words(text)) == color
