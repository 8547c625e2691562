"""Legs that drag on the floor, that are gathered at the waist, and that are not too long."""

from __future__ import annotations

import pytest

from swifttailor.pattern.drafts.draft_names import NamedDraft
from swifttailor.wishes.descriptions.hearing import hear_description
from swifttailor.wishes.drafts.legs_by_words import legs_as_said
from swifttailor.wishes.reader import WishReader

TROUSERS = NamedDraft("trousers", (("length", 100.0), ("leg_ease", 36.0)))


@pytest.fixture(scope="module")
def reader():
    return WishReader.load()


def length(named: NamedDraft) -> float:
    return float(dict(named.options)["length"])


@pytest.mark.parametrize(
    "text", ["wideleg pants super long they drag on the floor", "jeans that puddle around the feet"]
)
def test_they_drag(text):
    assert length(legs_as_said(TROUSERS, text, (), ())) > 110.0


@pytest.mark.parametrize(
    "text", ["wide jeans that touch the floor", "floor length trousers", "trousers that cover my shoes"]
)
def test_they_reach_the_floor(text):
    assert 104.0 < length(legs_as_said(TROUSERS, text, (), ())) < 110.0


@pytest.mark.parametrize(
    "text",
    [
        "flared jeans, long enough for heels",
        "flares to wear over heels",
        "long enough to cover my high heels",
    ],
)
def test_flares_over_heels_reach_the_floor(text):
    assert length(legs_as_said(NamedDraft("flares"), text, (), ())) == 106.0
    assert legs_as_said(NamedDraft("flares"), "flared jeans, worn with heels", (), ()) == NamedDraft("flares")


@pytest.mark.parametrize(
    "text", ["trousers, not too long", "wide trousers with extra long sleeves", "long wide trousers"]
)
def test_they_do_not(text):
    assert length(legs_as_said(TROUSERS, text, (), ())) == 100.0


@pytest.mark.parametrize("text", ["cropped wide trousers", "chinos, cropped", "half-mast trousers"])
def test_cropped_ones_end_above_the_ankle(text):
    assert 80.0 < length(legs_as_said(TROUSERS, text, (), ())) < 88.0
    assert length(legs_as_said(TROUSERS, "trousers with a cropped jacket", (), ())) == 100.0


def test_short_ones_stay_short():
    shorts = NamedDraft("trousers", (("length", 50.0),))
    assert legs_as_said(shorts, "super long shorts", (), ()) == shorts


@pytest.mark.parametrize(
    ("text", "name"),
    [
        ("trousers with an elasticated waist, straight leg, not too long", "pull-on-trousers"),
        ("grey slacks", "trousers"),
        ("cargo trousers with elasticated ankles", "joggers"),
        ("sports shorts", "pull-on-trousers"),
        ("board shorts", "pull-on-trousers"),
        ("tap pants", "pull-on-trousers"),
        ("comfy trousers for a long flight", "pull-on-trousers"),
        ("trousers, comfortable, for travelling", "pull-on-trousers"),
        ("pijama shorts", "pull-on-trousers"),
        ("no zip, just pull-on trousers with a wide leg", "pull-on-trousers"),
        ("comfortable tailored trousers", "trousers"),
        ("comfy jeans", "trousers"),
    ],
)
def test_what_is_gathered_at_the_waist(text, name, reader):
    assert hear_description(text, reader).drafts[0].name == name


def test_not_too_long_ends_above_the_foot(reader):
    first = hear_description("trousers with an elasticated waist, not too long", reader).drafts[0]
    assert length(first) < 95.0


@pytest.mark.parametrize(
    ("text", "name", "option", "least"),
    [
        ("jodhpurs", "jeans", "bow", 1.5),
        ("plus fours", "joggers", "leg_ease", 30.0),
        ("harem trousers", "joggers", "leg_ease", 50.0),
        ("zouave trousers", "joggers", "leg_ease", 50.0),
        ("churidar pants", "leggings", "length", 104.0),
        ("joined hose", "leggings", "length", 100.0),
        ("hakama", "pull-on-trousers", "leg_ease", 50.0),
        ("clown trousers", "pull-on-trousers", "leg_ease", 50.0),
    ],
)
def test_legs_of_names(text, name, option, least, reader):
    first = hear_description(text, reader).drafts[0]
    assert first.name == name and float(dict(first.options)[option]) >= least


@pytest.mark.parametrize(
    ("text", "name", "option", "low", "high"),
    [
        ("skirt, short at front long behind", "circle-skirt", "hem_dip", 25.0, 40.0),
        ("asymmetric skirt longer at the back", "circle-skirt", "hem_dip", 25.0, 40.0),
        ("dress with a scalloped hem", "skater-dress", "scallop_width", 8.0, 12.0),
        ("a skirt with a handkerchief hem", "circle-skirt", "hem_points", 18.0, 22.0),
        ("hobble skirt", "fitted-skirt", "flare", -6.0, -4.0),
        ("skirt narrow, narrower still at the bottom", "fitted-skirt", "flare", -6.0, -4.0),
        ("half slip", "circle-skirt", "fraction", 0.3, 0.4),
        ("mini skirt but not too short", "circle-skirt", "length", 38.0, 42.0),
        ("playsuit with very short legs", "jumpsuit", "length", 36.0, 40.0),
    ],
)
def test_skirts_and_short_legs(text, name, option, low, high, reader):
    first = hear_description(text, reader).drafts[0]
    assert first.name == name and low <= float(dict(first.options)[option]) <= high


def test_dresses_are_gathered_into_an_elastic_waist(reader):
    first = hear_description("a knee length dress with an elastic waist", reader).drafts[0]
    assert first.name == "skater-dress" and dict(first.options)["gathers"] > 1.5


def test_baggy_joggers_are_no_harem_trousers(reader):
    (baggy, *_) = hear_description("baggy joggers", reader).drafts
    (harem, *_) = hear_description("harem pants", reader).drafts
    assert baggy.name == harem.name == "joggers"
    assert 20.0 <= dict(baggy.options)["leg_ease"] <= 32.0 < dict(harem.options)["leg_ease"]
    assert "low_crotch" in harem.shows and "low_crotch" not in baggy.shows


def test_what_blouses_over_its_cuffs_ends_where_it_is_seen_to(reader):
    (harem, *_) = hear_description("harem pants", reader).drafts
    assert ("leg_hem", "ankle") in harem.is_to_the_eye
    (zouave, *_) = hear_description("zouave trousers", reader).drafts
    assert ("leg_hem", "calf") in zouave.is_to_the_eye


@pytest.mark.parametrize(
    "text",
    [
        "a foldover waistband",
        "yoga waistband",
        "a roll-top waist",
        "fold-over waist",
        "a waistband that folds down",
    ],
)
def test_a_waistband_that_is_folded_down_is_deep(text):
    leggings = NamedDraft.parse("leggings(length=90)")
    assert dict(legs_as_said(leggings, f"leggings with {text}", (), ()).options)["band_height"] == 9.0
    assert legs_as_said(leggings, "leggings with folds, and a waistband", (), ()) == leggings


@pytest.mark.parametrize(
    ("text", "length"),
    [
        ("7/8 trousers", 92.0),
        ("seven-eighths trousers", 92.0),
        ("trousers, 7/8 sleeves", 99.0),
        ("trousers", 99.0),
    ],
)
def test_seven_eighths_end_above_the_ankle(text, length):
    assert (
        dict(legs_as_said(NamedDraft.parse("trousers(length=99)"), text, (), ()).options)["length"] == length
    )


@pytest.mark.parametrize(
    ("text", "begun"),
    [
        ("bootcut jeans", "flares(flare=12;leg_ease=10;length=103)"),
        ("bell bottoms", "flares"),
        ("tapered trousers", "trousers(length=98;hip_ease=6;leg_ease=17;flare=-15)"),
        ("culotte shorts", "trousers(length=45;hip_ease=12;leg_ease=60;flare=30)"),
    ],
)
def test_names_of_legs_mean_their_shapes(text, begun, reader):
    heard = hear_description(text, reader)
    assert heard.drafts[0] == NamedDraft.parse(begun)
    flared = any("flared" in str(wish.change) for wish in heard.sure)
    assert flared == (text == "bell bottoms")  # bootcut legs are not to be cut as wide as the thigh


@pytest.mark.parametrize(
    "text", ["jeans, not cropped", "trousers that aren't cropped", "not flared nor cropped"]
)
def test_legs_that_are_not_to_be_cropped_stay_as_long(text):
    assert length(legs_as_said(TROUSERS, text, (), ())) == 100.0


@pytest.mark.parametrize(
    ("text", "slight"),
    [
        ("white jeans, slight kick flare", True),
        ("slightly flared trousers", True),
        ("trousers with a subtle flare", True),
        ("flared trousers", False),
        ("flares with slightly flared sleeves", False),
    ],
)
def test_slight_flares_flare_less(text, slight):
    made = dict(legs_as_said(NamedDraft("flares", (("flare", 32.0),)), text, (), ()).options)
    assert (made["flare"] < 20.0) == slight
