"""Words that point back to a place or a number, and slips in complaints."""

from __future__ import annotations

import pytest

from swifttailor.wishes.instructions.not_misspelt import with_plain_verbs
from swifttailor.wishes.instructions.pointing_back import with_what_is_meant
from swifttailor.wishes.instructions.to_for_too import with_too


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        (
            "It is loose at the waist, take it in there by 2 cm",
            "It is loose at the waist, take it in at the waist by 2 cm",
        ),
        ("My thighs rub, can you loosen them there?", "My thighs rub, can you loosen them at the thighs?"),
        (
            "hem down by 3 cm and the neckline up by the same amount",
            "hem down by 3 cm and the neckline up by 3 cm",
        ),
        ("sleeves 2 cm shorter and the hem the same amount", "sleeves 2 cm shorter and the hem by 2 cm"),
        ("there is a slit, make it higher", "there is a slit, make it higher"),
        ("take it in there", "take it in there"),
        ("both sleeves the same length", "both sleeves the same length"),
    ],
)
def test_what_is_pointed_at_is_named(text, meant):
    assert with_what_is_meant(text) == meant


@pytest.mark.parametrize(
    ("text", "so", "meant"),
    [
        ("its to tight", (), "its too tight"),
        ("a bit to short for me", (), "a bit too short for me"),
        ("the neck is two low", (), "the neck is too low"),
        ("sleeves to long", ("sleeves=long",), "sleeves too long"),
        ("sleeves to long", ("sleeves=short",), "sleeves to long"),
        ("change the sleeves to short", ("sleeves=short",), "change the sleeves to short"),
        ("to wide legs", (), "to wide legs"),
    ],
)
def test_to_is_too_where_something_is_complained_of(text, so, meant):
    assert with_too(text, lambda c: f"{c.name}={c.value}" in so) == meant


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        ("strip the cuffs", "remove the cuffs"),
        ("Strip off those ruffles", "remove those ruffles"),
        ("a strip of lace", "a strip of lace"),
        ("strips at the hem", "strips at the hem"),
    ],
)
def test_stripping_puts_no_stripes_on(text, meant):
    assert with_plain_verbs(text) == meant
