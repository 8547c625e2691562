"""What a text demands comes through, or is told: it is not lost, nor told where nothing is wrong."""

from __future__ import annotations

import pytest

from swifttailor.describing.claims import Claim
from swifttailor.describing.differences import Gain
from swifttailor.wishes.descriptions.hearing import hear_description
from swifttailor.wishes.heard import Heard
from swifttailor.wishes.reader import WishReader
from swifttailor.wishes.trims.trims_wanted import trims_wanted


@pytest.fixture(scope="module")
def reader() -> WishReader:
    return WishReader.load()


def sure(heard: Heard) -> set[Claim]:
    return {wish.change.claim for wish in heard.sure if isinstance(wish.change, Gain)}


@pytest.mark.parametrize(
    ("text", "pairs"),
    [
        ("Square V neck tee", {("Square neck", "V neck tee")}),
        ("sleeveless long sleeve top", {("sleeveless", "long sleeve top")}),
        ("officer's coat, knee length, stand collar", set()),
        ("crop top, one shoulder, long sleeve", set()),
        ("trousers, tight on the thighs, wide from the knee", set()),
        ("white shirt, puffed shoulders, long tight sleeves", set()),
        ("flared skinny jeans", {("flared", "skinny jeans")}),
        ("a polo neck with lapels", {("polo neck", "lapels")}),
    ],
)
def test_contradictions_are_named_where_there_are_some(reader, text, pairs):
    assert set(hear_description(text, reader).contradictions) == pairs


@pytest.mark.parametrize(
    "text",
    [
        "a dress touching the floor, boat neck. No train.",
        "Gentlemen's breeches",
        "poet blouse, full sleeves gathered into tight cuffs",
        "tunic for leggings",
        "mom jeans but blue",
        "blouse to the hip bone",
        "trousers, waistband 74 cm, inseam 80 cm",
        "trousers, tight on the bum and thighs, wide from the knee, low waist",
    ],
)
def test_nothing_is_said_of_what_was_understood(reader, text):
    heard = hear_description(text, reader)
    assert not set(heard.unread) - {"74 cm"} and not heard.missed_colors
    assert not {"several garments at once (ask for each on its own)"} & set(heard.cannot)


def test_who_wants_less_of_something_gets_none(reader):
    for text in ("less frilly than what you usually see: a blouse", "a blouse with fewer ruffles"):
        lacks = {lack.what for lack in hear_description(text, reader).lacks if lack.said}
        assert "frills" not in lacks, text


def test_a_lot_in_two_colors_is_of_the_first(reader):
    heard = hear_description("500 pcs ladies leggings, full length, black and charcoal", reader)
    assert heard.color == "#000000" and not heard.looks


def test_slits_at_both_sides_are_both_though_a_network_sees_one(reader):
    found = sure(hear_description("tunic with slits at both sides", reader))
    assert {Claim("slit", "left"), Claim("slit", "right")} <= found


def test_high_necks_above_bare_backs_have_no_collar_that_stands(reader):
    heard = hear_description("skater dress, long sleeves, high neck, open back", reader)
    assert heard.drafts and "collar" not in dict(heard.drafts[0].options)


@pytest.mark.parametrize(
    ("text", "name", "flares"),
    [
        ("A-line dress, knee length, no waist seam", "shift-dress", True),
        ("dress, no sleeves, no collar, no waist seam, no slit", "shift-dress", False),
        ("dress, no slit", "skater-dress", False),
    ],
)
def test_a_dress_without_a_waist_seam_hangs_from_the_shoulders(reader, text, name, flares):
    draft = hear_description(text, reader).drafts[0]
    assert draft.name == name and (float(dict(draft.options).get("flare", 0.0)) >= 20.0) == flares


def test_buttons_that_are_counted_are_wanted(reader):
    heard = hear_description("cropped cardigan, short sleeves, three buttons", reader)
    assert "buttons" in {lack.what for lack in heard.lacks if lack.said}


def test_a_hem_band_of_a_cardigan_is_put_on(reader):
    heard = hear_description("cardigan with a ribbed hem", reader)
    assert any(("hem rib",) in wish.choices for wish in trims_wanted(heard, "cardigan"))
    assert ("waistband", "hem") in heard.drafts[0].is_to_the_eye
