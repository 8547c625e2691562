"""Tops and knitwear that are cut as people wear them: shawl cardigans, open ones, stretchy tops, scoops."""

from __future__ import annotations

import pytest

from swifttailor.pattern.drafts import draft
from swifttailor.pattern.drafts.draft_names import NamedDraft
from swifttailor.pattern.trims import trims_that_fit
from swifttailor.wishes import WishReader
from swifttailor.wishes.descriptions.hearing import hear_description
from swifttailor.wishes.drafts.unbuttoned_cardigans import open_without_buttons
from swifttailor.wishes.trims.trims_wanted import trims_wanted

SHAWL = {"lapels": "shawl", "waist_shaping": 0.0}


@pytest.fixture(scope="module")
def heard():
    reader = WishReader.load()
    return lambda text: hear_description(text, reader)


@pytest.mark.parametrize(
    ("text", "name", "options"),
    [
        ("cardigan with a shawl collar", "blazer", {**SHAWL, "opening": 0.5, "closed_to": 21.0}),
        ("open cardigan, shawl collar", "blazer", {**SHAWL, "opening": 8.0}),
        ("shawl collar cardigan, no buttons", "blazer", {**SHAWL, "opening": 7.0}),
        ("cardigan without buttons", "cardigan", {"opening": 7.0, "closed_to": -30.0}),
        ("cardigan without buttons, with a zip", "cardigan", {"opening": 0.0}),
        ("stretchy long sleeved top, round neck", "t-shirt", {"stretch": 5.0, "waist_shaping": 2.5}),
        ("tee with a scoop neck", "t-shirt", {"neck_widening": 2.0, "neck_depth": 17.0}),
        ("sweatshirt with dropped shoulders", "sweatshirt", {"shoulder_extension": 7.5, "chest_ease": 18.0}),
        ("jumper, sleeves too long on purpose", "sweatshirt", {"sleeve_length": 71.0}),
        ("breastfeeding t-shirt", "wrap-top", {}),
        ("top I can breastfeed in", "wrap-top", {}),
        ("dress for breastfeeding", "wrap-dress", {}),
        ("cropped zip hoodie", "hoodie", {"length": 6.0}),
        ("tube top", "bandeau", {"length": 2.0}),
        ("bandeau top", "bandeau", {"length": -6.0}),
        ("blouse, neck closed", "shirt", {"collar": "standing"}),
        ("blouse with a cowl neck", "t-shirt", {"neck_widening": 4.5, "neck_depth": 10.5}),
        ("rash vest", "turtleneck", {"rolled": False, "collar_height": 4.0}),
        ("knit dress, roll neck", "shift-dress", {"collar": "rolled", "collar_height": 8.0}),
        ("top with flutter at the sleeves", "t-shirt", {"sleeve_shape": "bell"}),
    ],
)
def test_what_a_top_begins_from(text, name, options, heard):
    first = heard(text).drafts[0]
    assert first.name == name and options.items() <= dict(first.options).items()


@pytest.mark.parametrize("text", ["fisherman's jumper", "fishermans sweater", "cabled jumper, navy"])
def test_jumpers_of_fishermen_have_cables(text, heard):
    assert any(lack.what == "cables" for lack in heard(text).lacks)


@pytest.mark.parametrize(
    ("draft_name", "lacks", "denied", "opens"),
    [
        ("cardigan(opening=0;ribbed=true)", (), ("buttons",), True),
        ("cardigan(opening=0;ribbed=true)", (), (), False),
        ("cardigan(opening=0)", ("zip",), ("buttons",), False),
        ("cardigan(opening=8)", (), ("buttons",), False),
        ("blazer", (), ("buttons",), False),
    ],
)
def test_what_nothing_closes_hangs_open(draft_name, lacks, denied, opens):
    begun = NamedDraft.parse(draft_name)
    found = open_without_buttons(begun, lacks, denied, knitted=True)
    assert (found != begun) is opens
    assert not (opens and "ribbed" in dict(found.options))


def test_a_cardigan_with_a_collar_keeps_its_bands_and_pockets(heard):
    told = heard("cardigan with a shawl collar and pockets")
    first = told.drafts[0]
    wanted = trims_wanted(told, first.name)
    put = {name for wish in wanted for name in wish.choices[0]}
    assert {"knit bands", "patch pockets"} <= put and "welt pockets" not in put
    assert trims_that_fit(draft(first.name, **dict(first.options)), ["knit bands"]) == ("knit bands",)


@pytest.mark.parametrize("text", ["long hoodie with a zip, to mid thigh", "oversized hoodie with a zip"])
def test_hoodies_are_zipped_in_front_however_long(text, heard):
    told = heard(text)
    zips = [wish.choices[0] for wish in trims_wanted(told, "hoodie") if wish.what == "zip"]
    assert zips == [("zip",)]
