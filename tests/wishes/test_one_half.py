"""One half of what is worn as two."""

from __future__ import annotations

import pytest

from swifttailor.wishes.outfits.two_garments import two_garments
from swifttailor.wishes.text.one_half import of_one_half


@pytest.mark.parametrize(
    ("text", "half"),
    [
        ("trouser suit top half only, one button", "blazer, one button"),
        ("just the jacket of a skirt suit, navy", "blazer, navy"),
        ("pyjamas, bottoms only, tartan", "pyjama bottoms, tartan"),
        ("a suit but the trousers only", "a tailored trousers"),
        ("a trouser suit with a long jacket", "a trouser suit with a long jacket"),
        ("only a suit jacket", "only a suit jacket"),
    ],
)
def test_one_half_is_called_by_its_name(text: str, half: str) -> None:
    assert of_one_half(text) == half


def test_of_one_half_one_garment_is_made() -> None:
    assert two_garments("trouser suit top half only, shawl collar") is None
    assert two_garments("trouser suit with a shawl collar") is not None
