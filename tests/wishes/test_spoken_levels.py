"""Where garments and sleeves end, as people say it."""

from __future__ import annotations

import pytest

from swifttailor.wishes.text.spoken_levels import clashing_levels, spoken_levels
from swifttailor.wording.lexicon import read_words


def heard(text: str) -> dict[str, object]:
    words = read_words(text)
    kind = next((str(i.claim.value) for i in words.implications if i.claim.name == "kind"), None)
    return {claim.name: claim.value for claim in spoken_levels(text, words, kind).claims}


@pytest.mark.parametrize(
    ("text", "claims"),
    [
        ("sundress that stops at my ankles", {"skirt_hem": "ankle"}),
        ("every sundress drags, need one that stops at my ankles", {"skirt_hem": "ankle"}),
        ("a skirt ending just above my knee", {"skirt_hem": "above the knee"}),
        ("a coat that covers my knees", {"skirt_hem": "below the knee"}),
        ("trousers finishing at my shins", {"leg_hem": "calf"}),
        ("cargo shorts that go past the knee", {"leg_hem": "knee"}),
        ("a blouse that hits the hip bone", {"top_hem": "high hip"}),
        ("a jumper whose hem sits at the waist", {"top_hem": "waist"}),
        ("dress, sleeves that stop at the elbows", {"sleeves": "elbow"}),
        ("top with sleeves reaching my wrists", {"sleeves": "long"}),
    ],
)
def test_what_ends_somewhere_is_heard(text, claims):
    assert heard(text) == claims


@pytest.mark.parametrize(
    "text",
    [
        "dress with a slit to the thigh",
        "dress, fitted to the knee then flared",
        "gown with a train reaching the floor",
        "shirt with buttons down to the waist",
        "dress with long sleeves that touch the floor",
        "skirt with fringe reaching the knee",
        "dress with a sash hanging to the ankle",
        "top gathered at the waist",
        "blouse tied at the waist",
        "trousers narrow at the ankle",
        "tunic to wear over leggings that end at the calf",
        "skirt not below the knee",
        "dress with boots coming to the knee",
    ],
)
def test_what_is_said_of_something_else_is_not(text):
    assert heard(text) == {}


def test_what_the_lexicon_has_is_left_to_it():
    assert heard("a dress to the knee") == {}


def test_where_it_is_said_is_told():
    text = "a sundress that stops at my ankles"
    found = spoken_levels(text, read_words(text), "dress")
    assert [text[start:end] for start, end in found.spans] == ["stops at my ankles"]


@pytest.mark.parametrize(
    ("text", "kind", "clash"),
    [
        ("ankle-length dress that stops at the thigh", "dress", (("ankle-length", "stops at the thigh"),)),
        ("floor length gown that ends at the knees", "dress", (("floor length gown", "ends at the knees"),)),
        ("midi skirt that falls just below the knee", "skirt", ()),
        ("maxi dress, stops at the ankle", "dress", ()),
        ("floor length dress with a slit that goes up to the thigh", "dress", ()),
        ("long coat that stops at the knee", "dress", ()),
    ],
)
def test_a_length_and_a_level_that_cannot_both_be_true_are_told(text, kind, clash):
    assert clashing_levels(text, read_words(text), kind) == clash
