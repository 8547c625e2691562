"""Fur along an edge, and costumes of persons whose clothes are known."""

from __future__ import annotations

import pytest

from swifttailor.wishes.descriptions.hearing import hear_description
from swifttailor.wishes.descriptions.no_garment import asks_for_none
from swifttailor.wishes.outfits.two_garments import two_garments
from swifttailor.wishes.reader import WishReader
from swifttailor.wishes.trims.trims_wanted import trims_wanted


@pytest.fixture(scope="module")
def reader() -> WishReader:
    return WishReader.load()


@pytest.mark.parametrize(
    ("text", "nap", "trims"),
    [
        ("parka", None, {"neck fur"}),
        ("olive parka with a fur trimmed hood", None, {"neck fur"}),
        ("coat with a sheepskin collar", None, {"neck fur"}),
        ("khaki parka with a furry hood", None, {"neck fur"}),
        ("Santa dress", None, {"fur trim"}),
        ("red dress with white fur trim", None, {"fur trim"}),
        ("fur coat", "fur", set()),
        ("teddy coat", "curls", set()),
    ],
)
def test_fur_at_an_edge_is_not_the_cloth_of_the_whole(reader, text, nap, trims):
    heard = hear_description(text, reader)
    put_on = {name for wish in trims_wanted(heard, "coat") for name in wish.choices[0] if "fur" in name}
    assert (heard.nap, put_on) == (nap, trims)


@pytest.mark.parametrize(
    ("text", "guess", "color"),
    [
        ("Baywatch outfit", "swimsuit", "#ab1f2d"),
        ("Ghostbusters costume for adults", "boiler suit", "#b3a27a"),
        ("Indiana Jones costume", "leather jacket", "#5b4030"),
        ("something for a Bridgerton party", "Regency gown", "#f4efe5"),
        ("Wednesday Addams costume for a party", "", "#17151a"),
    ],
)
def test_a_costume_has_the_garment_and_the_colour_of_its_person(reader, text, guess, color):
    heard = hear_description(text, reader)
    assert (heard.guess, heard.color) == (guess, color)
    assert asks_for_none(heard, text) == ""


def test_a_necklace_is_still_refused(reader):
    text = "a necklace with a heart"
    assert asks_for_none(hear_description(text, reader), text)


def test_what_is_worn_in_a_film_may_be_two_garments():
    both = two_garments("Karate Kid costume")
    assert both is not None
    assert (both.upper, both.lower) == ("gi top", "gi trousers")
    assert two_garments("Karate Kid T-shirt") is None


def test_a_striking_colour_within_a_name_is_of_that_garment(reader):
    heard = hear_description("hi vis orange jacket", reader)
    assert heard.color == hear_description("orange hi vis jacket", reader).color
    assert any("reflecting bands" in wish.choices[0] for wish in trims_wanted(heard, "turtleneck"))
