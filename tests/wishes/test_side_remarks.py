"""Remarks about garments that are worn with the one that is asked for."""

from __future__ import annotations

import pytest

from swifttailor.wishes.outfits.side_remarks import without_side_remarks


@pytest.mark.parametrize(
    ("text", "left"),
    [
        (
            "A light cardigan, cream, to throw over a strappy dress when it turns chilly",
            "A light cardigan, cream when it turns chilly",
        ),
        (
            "peplum top burgundy velvet, im pairing it w cigarette pants i already own",
            "peplum top burgundy velvet",
        ),
        ("a silk slip to wear under my wedding dress", "a silk slip"),
        ("jacket that goes with a long red evening gown", "jacket"),
        ("a tunic to wear over leggings, navy", "a tunic, navy"),
        ("graduation dress, midi, has to look ok under the robes", "graduation dress, midi, has"),
        ("I already have the jacket, just need trousers in navy", "need trousers in navy"),
        ("trousers for a suit, the jacket I have is grey herringbone", "trousers for a suit"),
        ("a blouse under my black pinafore dress", "a blouse"),
        ("pinafore for over a polo neck, mustard", "pinafore, mustard"),
        ("vest top for under shirts, white", "vest top, white"),
        ("a gilet for wearing over a thick jumper", "a gilet"),
        ("a long sleeve base layer with a turtleneck", "a long sleeve base layer with a turtleneck"),
        ("a top, slim fit with a polo neck", "a top, slim fit with a polo neck"),
        ("a top, fits with a skirt", "a top"),
        (
            "racerback, long enough to cover the waistband of my leggings",
            "racerback, long enough to cover it",
        ),
    ],
)
def test_remarks_about_other_garments_are_left_out(text: str, left: str) -> None:
    assert without_side_remarks(text) == left


@pytest.mark.parametrize(
    "text",
    [
        "something to wear over a dress",
        "a dress with a shirt collar",
        "a dress with a pencil skirt",
        "my wedding dress should be long",
        "I want to wear a red skirt",
        "a top that goes with anything",
    ],
)
def test_what_is_asked_for_stays(text: str) -> None:
    assert without_side_remarks(text) == text
