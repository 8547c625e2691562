"""Instructions that correct themselves."""

from __future__ import annotations

import pytest

from swifttailor.wishes.instructions.taken_back import without_taken_back


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        ("shorter sleeves, or no, sorry, longer ones, to the wrist", "the sleeves longer, to the wrist"),
        ("wider skirt - scratch that, narrower", "the skirt narrower"),
        ("deeper neckline... actually no, higher", "the neckline higher"),
        ("5 cm shorter, sorry, longer", "longer by 5 cm"),
        ("shorten the sleeves, wait, I mean the skirt", "shorten the skirt"),
        (
            "lower neckline, oh no, wait, higher, and longer sleeves",
            "the neckline higher, and longer sleeves",
        ),
        ("Make the collar higher. No, lower.", "the collar lower."),
    ],
)
def test_what_was_said_last_counts(text, meant):
    assert without_taken_back(text) == meant


@pytest.mark.parametrize(
    "text",
    [
        "longer sleeves, no collar, wider skirt",
        "Sleeves shorter please. Sorry, also the skirt longer.",
        "the waist is fine, actually, the hips are too tight",
        "a wider hem, sorry for the trouble",
        "no collar",
        "",
    ],
)
def test_what_is_asked_for_besides_takes_nothing_back(text):
    assert without_taken_back(text) == text
