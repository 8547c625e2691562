"""Legs as people mean them: high, bootcut in jersey, of the forties, on wrap and halter bodices."""

from __future__ import annotations

import pytest

from swifttailor.pattern.drafts.draft_names import NamedDraft
from swifttailor.wishes.descriptions.hearing import hear_description
from swifttailor.wishes.drafts.bygone_legs import legs_of_their_time
from swifttailor.wishes.drafts.legged_drafts import short_as_a_playsuit
from swifttailor.wishes.reader import WishReader
from swifttailor.wishes.trims.trims_wanted import trims_wanted


@pytest.fixture(scope="module")
def reader():
    return WishReader.load()


@pytest.mark.parametrize(
    ("text", "name", "options"),
    [
        ("halter jumpsuit, wide leg", "halter-jumpsuit", {"leg_ease": 42.0}),
        ("wrap jumpsuit", "wrap-jumpsuit", {}),
        ("jumpsuit with a wrap front and short sleeves", "wrap-jumpsuit", {"sleeves": True}),
        ("wrap playsuit", "wrap-jumpsuit", {"length": 48.0}),
        ("halter playsuit", "halter-jumpsuit", {"length": 48.0}),
        ("leggings, but bootleg", "flares", {"stretch": 8.0}),
        ("bootleg yoga pants", "flares", {"stretch": 8.0}),
        ("high waisted trousers", "trousers", {"below_waist": -3.5, "band_height": 7.0}),
        ("Marlenehose", "trousers", {"below_waist": -3.0, "leg_ease": 42.0}),
        ("forties style trousers", "trousers", {"below_waist": -3.5, "leg_ease": 34.0}),
        ("trousers that narrow gradually to the ankle", "trousers", {"leg_ease": 17.0, "flare": -15.0}),
        ("trousers, easy over the knee, narrow at the ankle", "trousers", {"leg_ease": 17.0}),
        ("trousers high enough at the back", "trousers", {"back_rise": 4.0}),
        ("cropped halter jumpsuit", "halter-jumpsuit", {"length": 84.0, "flare": -1.0}),
        ("high leg one piece", "swimsuit", {"leg_height": 10.0}),
        ("cargo trousers with tie ankles", "joggers", {}),
    ],
)
def test_they_begin_from_the_draft_that_shows_them(text, name, options, reader):
    first = hear_description(text, reader).drafts[0]
    assert first.name == name and options.items() <= dict(first.options).items()


@pytest.mark.parametrize(("text", "at_least"), [("trousers", 102.0), ("chinos", 101.0), ("jeans", 102.0)])
def test_full_legs_end_at_the_shoe(text, at_least, reader):
    options = dict(hear_description(text, reader).drafts[0].options)
    assert at_least <= float(options["length"]) <= 103.0


@pytest.mark.parametrize(
    ("text", "draft", "names"),
    [
        ("dungaree dress", "pinafore", {"strap buckles", "bib pocket", "topstitching"}),
        ("tuxedo jumpsuit", "jumpsuit", {"satin stripes", "buttons"}),
        ("Marlenehose", "trousers", {"front pleats", "fly", "creases"}),
        ("men's trousers of the 1940s", "trousers", {"front pleats", "creases", "fly"}),
        ("wrap jumpsuit", "wrap-jumpsuit", {"side tie"}),
        ("bikini top", "camisole", {"cups"}),
    ],
)
def test_what_makes_the_kind_is_put_on(text, draft, names, reader):
    wishes = trims_wanted(hear_description(text, reader), draft)
    assert names <= {name for wish in wishes for name in wish.choices[0]}


def test_forties_without_pleats_have_none(reader):
    wishes = trims_wanted(hear_description("1940s trousers without pleats", reader), "trousers")
    assert not any("front pleats" in names for wish in wishes for names in wish.choices)


@pytest.mark.parametrize(
    ("draft", "text", "told", "changed"),
    [
        ("trousers", "1930s trousers", False, True),
        ("trousers", "trousers for £40s", False, False),
        ("trousers(length=50)", "1940s shorts", False, False),
        ("leggings", "1940s leggings", False, False),
        ("trousers(leg_ease=12)", "slim 1940s trousers", True, True),
    ],
)
def test_decades_change_long_trousers_alone(draft, text, told, changed):
    before = NamedDraft.parse(draft)
    after = legs_of_their_time(before, text, told=told)
    assert (after != before) is changed
    if told:
        assert dict(after.options)["leg_ease"] == 12.0


@pytest.mark.parametrize("name", ["swimsuit", "jumpsuit(length=40)", "fitted-dress"])
def test_what_is_short_or_has_no_legs_stays_as_it_is(name):
    draft = NamedDraft.parse(name)
    assert short_as_a_playsuit(draft) == draft
