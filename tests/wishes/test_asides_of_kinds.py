"""Words beside a wish that would make another garment of it, and those that say which one it is."""

from __future__ import annotations

import pytest

from swifttailor.wishes.descriptions.hearing import hear_description
from swifttailor.wishes.descriptions.sayings_of_wishes import without_asides
from swifttailor.wishes.outfits.two_garments import two_garments
from swifttailor.wishes.reader import WishReader
from swifttailor.wishes.text.complaints import without_complaints


@pytest.fixture(scope="module")
def reader() -> WishReader:
    return WishReader.load()


@pytest.mark.parametrize(
    ("text", "plain"),
    [
        ("cocktails then a club, a top", "drinks then a club, a top"),
        ("a cocktail dress", "a cocktail dress"),
        ("very large like for boys", "oversized"),
        ("a jumper, sleeves too long on purpose", "a jumper, extra long sleeves"),
        ("sleeves too long for me", "sleeves too long for me"),
        ("a blouse, full sleeves and a bow", "a blouse, full gathered sleeves and a bow"),
        ("full sleeves T-shirt", "full sleeves T-shirt"),
        ("Kleid, oben eng, unten weit", "Kleid, oben eng, mit weitem Rock"),
        ("Hose, unten weit", "Hose, unten weit"),
        ("robe serrée en haut, ample en bas", "robe serrée en haut, avec une jupe ample"),
        ("a top, long enough that it doesn't come untucked", "a top, hip length"),
        ("no sleeves but wide enough at the shoulder to hide a bra strap", "no sleeves wide straps"),
        ("a top, cut close", "a top, close fitting"),
        ("not jeans, not leggings, something in between", "comfortable trousers"),
        ("trousers with a bit of give at the knee", "trousers with room to move"),
        ("collars make me look like a tortoise", "no collars"),
        ("a jumper with buttons down the front", "a cardigan with buttons down the front"),
        ("a dress, the skirt in A", "a dress, the A-line skirt"),
        ("a skirt with volants", "a skirt with ruffles"),
        ("jacket, not leather, but biker style", "biker jacket, not leather, "),
    ],
)
def test_asides_are_put_plainly(text, plain):
    assert without_asides(text) == plain


@pytest.mark.parametrize(
    ("text", "kind"),
    [
        ("there is a dress code, so a nice top with a round neck", "top"),
        ("tee shirt dress with side slits, below the knee", "dress"),
        ("high leg one piece, red", "playsuit"),
        ("a-line mini", "skirt"),
        ("culotes to mid calf", "trousers"),
    ],
)
def test_the_kind_is_what_was_asked_for(reader, text, kind):
    heard = hear_description(text, reader)
    assert heard.kind == kind and not heard.unread


def test_a_high_waist_of_a_dress_is_under_the_bust(reader):
    sure = hear_description("a dress with the waist high and short sleeves", reader).sure
    assert "empire" in [w.change.claim.value for w in sure]


def test_a_t_shirt_dress_has_no_waist(reader):
    assert hear_description("tee shirt dress", reader).drafts[0].name == "shift-dress"


@pytest.mark.parametrize("text", ["Carmen blouse, white", "blusa carmen blanca", "Carmenbluse"])
def test_a_carmen_blouse_bares_the_shoulders(reader, text):
    assert hear_description(text, reader).drafts[0].name == "off-shoulder-top"


def test_a_general_word_for_prints_gives_way_to_their_name(reader):
    shown = hear_description("vestido largo de tirantes, estampado tropical", reader).print
    assert shown is not None and shown.motif == "palms"


@pytest.mark.parametrize(
    ("text", "left"),
    [
        (
            "all my tops are either gym stuff or too low, can I have a blouse with a high neck",
            "can I have a blouse with a high neck",
        ),
        (
            "my sister says I always look sad in my black dresses so can I have a bright one",
            "can I have a bright dresses",
        ),
    ],
)
def test_what_is_told_of_other_clothes_is_left_out(text, left):
    assert without_complaints(text) == left


@pytest.mark.parametrize(
    "text",
    [
        "something sleeveless but with a little jacket to go over",
        "I don't want a dress. A skirt and a top would do, both in navy.",
    ],
)
def test_two_garments_that_are_put_loosely_are_both_made(text):
    assert two_garments(text) is not None


def test_who_it_looks_to_be_for_does_not_wear_it(reader):
    heard = hear_description("a t-shirt very large like for boys, sleeve until elbow", reader)
    assert "oversized" in [w.change.claim.value for w in heard.sure]
