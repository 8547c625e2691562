"""What makes a kind of top or of underwear that kind: the bands of a ringer tee, the seat of a thong."""

from __future__ import annotations

import pytest

from swifttailor.describing.claims import Claim
from swifttailor.describing.differences import Gain
from swifttailor.wishes import WishReader
from swifttailor.wishes.descriptions.hearing import hear_description
from swifttailor.wishes.trims.trims_wanted import trims_wanted
from swifttailor.wording import read_words
from swifttailor.wording.lexicon.usual_colors import usual_color


@pytest.fixture(scope="module")
def heard():
    reader = WishReader.load()
    return lambda text: hear_description(text, reader)


@pytest.mark.parametrize(
    ("text", "trim"),
    [
        ("ringer tee", "narrow bands"),
        ("tuxedo shirt", "tucks"),
        ("a white blouse with pintucks", "tucks"),
        ("a gingham tie front shirt", "waist bow"),
        ("cold shoulder top", "shoulder cut-outs"),
        ("a green dress with cold shoulders", "shoulder cut-outs"),
        ("cowl neck top", "cowl folds"),
        ("an emerald cami with a cowl neck", "cowl folds"),
        ("chemise", "lace trim"),
        ("white blouse with a pleated front", "pleated front"),
        ("a pleated blouse", "pleated front"),
        ("blouse with pleats at the neckline", "neck pleats"),
        ("a bit of pleating below the shoulders of a blouse", "shoulder pleats"),
        ("shirt with a box pleat at the back", "back pleat"),
        ("plissé top", "fine pleats"),
        ("top gathered at the neck", "neck gathers"),
        ("blouse with gathers at the shoulders", "shoulder gathers"),
        ("tulip sleeve top", "sleeve petals"),
        ("wrap blouse", "side tie"),
        ("shirt with a tie at the waist", "tie belt"),
        ("white crop shirt knotted at the waist", "waist bow"),
    ],
)
def test_has_what_it_is_known_by(heard, text, trim):
    assert any(trim in wish.choices[0] for wish in trims_wanted(heard(text)))


@pytest.mark.parametrize(
    ("text", "trim"),
    [
        ("a black lace teddy", "lace trim"),
        ("a draped dress", "cowl folds"),
        ("T shirt", "narrow bands"),
        ("a pleated skirt", "pleated front"),
        ("a blouse with pleated sleeves", "pleated front"),
    ],
)
def test_others_have_not(heard, text, trim):
    assert not any(trim in choice for wish in trims_wanted(heard(text)) for choice in wish.choices)


@pytest.mark.parametrize(
    ("text", "draft", "options"),
    [
        ("a black corset top with straps", "bustier", {"straps": True}),
        ("corset top", "bustier", {}),
        ("a silky slip", "slip-dress", {}),
        ("sleeveless hoodie", "hoodie", {"sleeves": False}),
        ("green cropped cardigan with buttons", "cardigan", {"opening": 0.0}),
        ("black thong", "briefs", {"seat": 0.1}),
        ("smock blouse", "t-shirt", {"chest_ease": 24.0}),
        ("tulip skirt", "wrap-skirt", {"petals": 4.0}),
        ("a black skirt, tulip shaped", "wrap-skirt", {"petals": 4.0}),
        ("skirt with overlapping front panels", "wrap-skirt", {}),
        ("a top that overlaps in front", "wrap-top", {}),
        ("red tartan kilt skirt", "pleated-skirt", {"apron": True}),
        ("grey box pleat skirt", "pleated-skirt", {"strips": 4.0}),
        ("kaftan top", "t-shirt", {"armhole": "cut-in-one"}),
        ("cream peasant blouse with short sleeves", "t-shirt", {"sleeve_shape": "balloon"}),
        ("black jumpsuit with tuxedo lapels", "jumpsuit", {"collar": "revers"}),
    ],
)
def test_begins_from_the_draft_that_shows_it(heard, text, draft, options):
    first = heard(text).drafts[0]
    assert first.name == draft and options.items() <= dict(first.options).items()


def test_what_a_name_speaks_against_is_not_guessed(heard):
    """A network takes boxer briefs for boxers; who says wide legs gets them."""
    wide = Gain(Claim("legs", "wide"))
    plain = heard("navy boxer briefs with a white waistband")
    asked = heard("navy boxer briefs with wide legs")
    assert wide not in [wish.change for wish in (*plain.sure, *plain.likely)]
    assert wide in [wish.change for wish in asked.sure]


def test_a_teddy_has_not_the_colour_of_teddy():
    (named,) = [mark for mark in read_words("a silk teddy").marks if mark.word == "teddy"]
    assert [usual_color("teddy", entry) for entry in named.entries if entry.category == "garments"] == [None]
    (cloth,) = [m for m in read_words("a hoodie of teddy fabric and teddy").marks if m.word == "teddy"]
    assert any(usual_color("teddy", entry) for entry in cloth.entries if entry.category == "fabrics")


@pytest.mark.parametrize("text", ["a jumpsuit, gold sequins", "dress in gold sequin", "gold sequined dress"])
def test_sequins_of_one_colour_are_what_is_seen(text):
    assert [color.words for color in read_words(text).colors] == ["gold"]


def test_sequins_on_another_colour_are_not_the_garments():
    assert [color.words for color in read_words("a black dress with gold sequins").colors] == ["black"]
