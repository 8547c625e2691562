"""What is refused beside a name that means it, and names that are made as people picture them."""

from __future__ import annotations

import pytest

from swifttailor.describing import Claim
from swifttailor.wording import read_words


def test_a_mini_skirt_that_is_not_too_short_is_still_a_mini_skirt():
    reading = read_words("a mini skirt, but not too short")
    assert reading.certainty(Claim("skirt_hem", "mini")) == "certain"
    assert Claim("skirt_hem", "micro") in reading.never and Claim("skirt_hem", "mini") not in reading.never


@pytest.mark.parametrize(
    ("text", "claim"),
    [
        ("exomis", Claim("skirt_hem", "above the knee")),
        ("seifuku skirt", Claim("kind", "skirt")),
        ("monk's clothing", Claim("skirt_hem", "ankle")),
        ("hooded fleece poncho", Claim("hood", "hood")),
        ("Princess Peach dress", Claim("sleeve_shape", "puffed")),
        ("wrapover overall", Claim("kind", "dress")),
        ("cowl neck jumper", Claim("collar", "turtleneck")),
        ("a pretty top", Claim("sleeve_shape", "puffed")),
        ("ninja suit", Claim("hood", "hood")),
        ("gorilla suit", Claim("kind", "jumpsuit")),
        ("a dress, no bare arms", Claim("sleeves", "long")),
        ("servant's bedgown", Claim("kind", "dress")),
        ("a blouse with huge sleeves", Claim("sleeve_shape", "balloon")),
        ("a top with sleeves below the elbows", Claim("sleeves", "three-quarter")),
    ],
)
def test_names_mean_what_people_picture(text, claim):
    assert read_words(text).certainty(claim) is not None


@pytest.mark.parametrize(
    ("text", "denied"),
    [
        ("a dress, sleeves yes, frills no", {"frills"}),
        ("dress. pockets no. collar no", {"pockets", "collar"}),
        ("a dress, sleeves no", {"sleeves"}),
        ("a dress off the telly", set()),
        ("that dress off wuzzle", set()),
        ("a dress with the sleeves off", {"sleeves"}),
    ],
)
def test_what_is_answered_with_a_no_is_refused(text, denied):
    assert {mark.word for mark in read_words(text).marks if mark.denied} == denied


@pytest.mark.parametrize(
    ("text", "oversized"),
    [
        ("a jumper with a huge hood", False),
        ("a coat with huge patch pockets", False),
        ("a dress with a big bow at the waist", False),
        ("a top with a giant frill at the neck", False),
        ("a big jumper with a roll neck", True),
        ("a big quilted coat", True),
    ],
)
def test_what_is_put_on_may_be_big_on_a_garment_that_is_not(text, oversized):
    reading = read_words(text)
    assert (reading.certainty(Claim("fit", "oversized")) is not None) == oversized
    astray = [mark.word for mark in reading.marks if mark.role == "astray"]
    assert bool(astray) != oversized, "and is named as not understood"
