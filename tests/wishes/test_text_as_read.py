"""Texts as they are read, before any word of them is understood."""

from __future__ import annotations

import pytest

from swifttailor.wishes.text.text_as_read import text_as_read


@pytest.mark.parametrize(
    ("text", "read"),
    [
        ("1. no hood 2. high collar 3. slim sleeves", "no hood; high collar; slim sleeves"),
        ("1) longer\n2) wider", "longer; wider"),
        ("a skirt of 2. No hood", "a skirt of 2. No hood"),
        ("2. no hood 1. high collar", "2. no hood 1. high collar"),
        ("loger slevs", "longer sleeves"),
        ("I leave the rest, i.e. at the waist", "I leave the rest, that is at the waist"),
        ("a gown for the hospital", "a hospital gown"),
        ("a dress for a night out", "a dress for a night out"),
        ("a skirt for the school play", "a skirt for the school play"),
        ("culotes to mid calf", "culottes to mid calf"),
        ("culotes negros", "culotes negros"),
        ("sleeves, e.g. puffed", "sleeves, for example puffed"),
        ("a broad band, say 7 cm", "a broad band 7 cm"),
        ("I say long", "I say long"),
        ("a kimono-sleeved top", "a kimono sleeves top"),
        ("a V-backed dress", "a V back dress"),
        ("frill-hemmed dress", "frill hem dress"),
        ("a bell-sleeved top", "a bell-sleeved top"),  # that the lexicon has
        ("one-sleeved dress", "one-sleeved dress"),
        ("a wuzzle-necked dress", "a wuzzle-necked dress"),
    ],
)
def test_numbers_of_lists_and_slips_are_put_right(text, read):
    assert text_as_read(text)[0] == read
