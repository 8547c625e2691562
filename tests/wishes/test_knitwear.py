"""Knitwear and tops as shops show them: ribs of cardigans, loose collars, close tops of jersey, V necks."""

from __future__ import annotations

import pytest

from swifttailor.wishes import WishReader
from swifttailor.wishes.descriptions.hearing import hear_description
from swifttailor.wishes.looks.heard_print import heard_print
from swifttailor.wishes.trims.trims_wanted import trims_wanted
from swifttailor.wording import read_words


@pytest.fixture(scope="module")
def heard():
    reader = WishReader.load()
    return lambda text: hear_description(text, reader)


@pytest.mark.parametrize(
    ("text", "name", "options"),
    [
        ("cardigan", "cardigan", {"ribbed": True, "opening": 0.0}),
        ("Strickjacke", "cardigan", {"ribbed": True}),
        ("button-up cardigan, navy", "cardigan", {"ribbed": True}),
        ("big roll neck jumper", "sweatshirt", {"collar": "loose"}),
        ("cropped cardigan", "cardigan", {"ribbed": True, "length": 6.0}),
        ("crew neck cardigan", "cardigan", {"neckline": "round", "ribbed": True}),
        ("longline cardigan", "cardigan", {"length": 48.0}),
        ("cowl neck jumper", "sweatshirt", {"collar": "loose"}),
        ("jumper with a big loose polo neck", "sweatshirt", {"collar": "loose"}),
        ("a jumper, large roll neck", "sweatshirt", {"collar": "loose"}),
        ("polo neck jumper", "sweatshirt", {"collar": "rolled"}),
        ("jumper with sleeves wide at the bottom", "sweatshirt", {"sleeve_shape": "wide"}),
        ("jumper with bell sleeves", "sweatshirt", {"sleeve_shape": "bell"}),
        ("cardigan with loose sleeves", "cardigan", {"ribbed": True, "arm_ease": 15.0}),
        ("fitted top, keyhole back", "t-shirt", {"stretch": 5.0}),
        ("fitted long-sleeve top with a mock neck", "turtleneck", {"stretch": 5.0}),
        ("peasent blouse", "t-shirt", {"armhole": "raglan", "sleeve_shape": "balloon"}),
        ("top with a v neck but not a BIG v", "t-shirt", {"neckline": "v", "neck_depth": 12.5}),
    ],
)
def test_a_name_begins_from_a_draft(text, name, options, heard):
    first = heard(text).drafts[0]
    assert first.name == name and options.items() <= dict(first.options).items()


def test_close_tops_of_woven_cloth_do_not_stretch(heard):
    assert "stretch" not in dict(heard("fitted linen top").drafts[0].options)


@pytest.mark.parametrize(
    ("text", "has"),
    [("cardigan", True), ("open cardigan", True), ("longline cardigan", True), ("kimono jacket", False)],
)
def test_cardigans_have_knitted_bands(text, has, heard):
    put = {name for wish in trims_wanted(heard(text), "cardigan") for name in wish.choices[0]}
    assert ("knit bands" in put) == has


@pytest.mark.parametrize(
    ("text", "hem"),
    [
        ("a plain jumper, well over the hips", "long"),
        ("a nice top, long enough to half tuck", "hip"),
        ("blouse, the long is until the hip", "hip"),
    ],
)
def test_hems_of_tops_as_people_say_them(text, hem, heard):
    told = [w.change.claim for w in heard(text).sure if w.change.claim.name == "top_hem"]
    assert [claim.value for claim in told] == [hem]


@pytest.mark.parametrize(
    ("text", "width"),
    [
        ("rugby shirt, navy and white stripes", 8.0),
        ("rugby shirt, thin stripes", 8.0),
        ("rugby shirt with 3 cm stripes", 3.0),
        ("rugby top, green and white hoops", 8.0),
        ("jumper, navy and white stripes", 2.5),
    ],
)
def test_stripes_are_as_wide_as_the_garment_has_them(text, width):
    found = heard_print(text, read_words(text))
    assert found is not None
    assert (found.size("width") == width) == ("thin" not in text)
