"""Which of several garments is made first, where a text says so."""

from __future__ import annotations

import pytest

from swifttailor.wishes.outfits.first_piece import first_piece
from swifttailor.wishes.outfits.two_garments import two_garments


@pytest.mark.parametrize(
    ("text", "piece"),
    [
        (
            "a white blouse with puffed sleeves, over that a bodice, and a green pleated skirt to mid-calf. "
            "If you can only do one piece, start with the skirt.",
            "a green pleated skirt to mid-calf",
        ),
        ("A red blouse and a black pencil skirt, please start with the skirt.", "a black pencil skirt"),
        ("Linen jacket, wide trousers. If only one piece is possible, do the trousers", "wide trousers"),
        ("a shirt, brown waistcoat, green breeches; just the waistcoat for now", "brown waistcoat"),
        ("a blouse with long sleeves and a skirt. Make the blouse first", "a blouse with long sleeves"),
        ("a cape and a gown in velvet. If you can do only one of them, the gown please", "a gown in velvet"),
    ],
)
def test_the_garment_that_is_asked_for_first_is_the_only_one(text, piece):
    assert first_piece(text) == piece
    assert two_garments(text) is None


@pytest.mark.parametrize(
    "text",
    [
        "a dress with a wide skirt, start with the skirt",
        "I want a skirt that starts with a yoke",
        "a blouse and a skirt",
    ],
)
def test_other_texts_stay_as_they_are(text):
    assert first_piece(text) == text
