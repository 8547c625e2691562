"""What names of legs, underwear, nightwear and working clothes begin from."""

from __future__ import annotations

import pytest

import swifttailor
from swifttailor.describing.claims import Claim
from swifttailor.pattern.drafts.draft_names import NamedDraft
from swifttailor.wishes.descriptions.hearing import hear_description
from swifttailor.wishes.drafts.swimsuits_as_asked import on_a_halter
from swifttailor.wishes.reader import WishReader
from swifttailor.wishes.trims.trims_spoken_of import refused_trims
from swifttailor.wishes.trims.trims_wanted import trims_wanted


@pytest.fixture(scope="module")
def reader() -> WishReader:
    return WishReader.load()


@pytest.mark.parametrize(
    ("text", "name", "options"),
    [
        ("high waist knickers", "briefs", {"below_waist": 2.0}),
        ("bikini bottoms", "briefs", {"below_waist": 13.0}),
        ("high waist swimming pants", "briefs", {"below_waist": 2.0}),
        ("onesie", "jumpsuit", {"collar": "hood", "leg_cuff": 5.0}),
        ("swimsuit with low back and wide straps", "bodysuit", {"strap_width": 4.5, "back_neck_depth": 30.0}),
        ("one piece swimsuit with wide straps", "bodysuit", {"strap_width": 4.5, "sleeves": False}),
        ("flared leggings", "flares", {"leg_ease": 8.0}),
        ("red swimsuit, high neck", "bodysuit", {"neck_depth": 8.5, "sleeves": False}),
        ("nightie", "empire-dress", {"sleeve_length": 22.0, "yoke": True}),
        ("nightgown", "empire-dress", {"sleeve_length": 58.0, "yoke": True}),
        ("cuffed cargo joggers", "joggers", {"leg_ease": 18.0}),
        ("boys shorts cargo", "trousers", {"length": 62.0}),
        ("maternity jeans", "leggings", {"band_height": 13.0}),
        ("skort", "leggings", {"length": 46.0}),
        ("tennis skirt with built in shorts", "leggings", {}),
        ("swim dress", "swimsuit", {}),
        ("pyjama jacket", "shirt", {"collar": "revers", "cuffs": False}),
        ("nuisette", "slip-dress", {"length": 44.0}),
        ("cigarette trousers", "jeans", {"length": 95.0, "leg_ease": 3.0}),
        ("elasticated trousers", "pull-on-trousers", {"leg_ease": 20.0}),
        ("leotard with tank straps", "bodysuit", {"sleeves": False, "strap_width": 4.5}),
        ("fencing breeches", "joggers", {"length": 73.0}),
        ("cycling jersey", "turtleneck", {"hem_dip": 5.0}),
        ("halter bodysuit", "swimsuit", {"halter": True}),
        ("tennis dress with a polo collar", "shirt-dress", {"collar": "shirt"}),
        ("gaucho pants, leg opening 80 cm", "trousers", {"leg_ease": 46.0, "flare": 0.0, "hip_ease": 4.0}),
        ("mechanic overalls", "jumpsuit", {"collar": "shirt"}),
        ("trousers with braces", "dungarees", {"bib": False}),
        ("doctor coat", "coat", {"length": 54.0}),
        ("swim trunks", "pull-on-trousers", {"length": 49.0}),
        ("cycling shorts, mid thigh", "leggings", {"length": 47.0}),
        ("yoga pants, flared", "flares", {"stretch": 8.0}),
        ("halter neck swimsuit", "swimsuit", {"halter": True}),
        ("halter bikini top", "halter-top", {"length": -9.0}),
        ("joggers, no cuffs", "pull-on-trousers", {"leg_ease": 24.0}),
        ("jumpsuit with a collar", "jumpsuit", {"collar": "shirt", "neck_depth": 10.0}),
        ("apron to the knee, black, without bib", "apron", {"bib": False, "length": 64.0}),
        ("jeans blue ripped knees", "trousers", {"length": 102.5}),
    ],
)
def test_a_name_begins_from_a_draft(text, name, options, reader):
    heard = hear_description(text, reader)
    first = heard.drafts[0]
    assert first.name == name and options.items() <= dict(first.options).items()
    assert not heard.contradictions and not heard.unread


def test_a_pinafore_with_pleats_is_pleated_and_has_the_skirt_that_its_name_means(reader):
    (pleated,) = hear_description("grey pinafore with box pleats", reader).drafts
    assert "pleats" in pleated.shows and ("skirt", "a-line") in pleated.is_to_the_eye


def test_only_swimsuits_are_held_by_a_halter():
    suit, halter = NamedDraft("swimsuit"), NamedDraft("halter-jumpsuit")
    (held,) = on_a_halter([suit, halter], [])
    assert "halter" in held.shows
    assert on_a_halter([halter], []) == [halter] and on_a_halter([suit], []) == [suit]
    (high,) = on_a_halter([NamedDraft("bodysuit"), halter], [Claim("neck_depth", "high")])
    assert high.name == "swimsuit" and dict(high.options)["neck_depth"] < 12.0
    panels = {panel.name for panel in swifttailor.draft("swimsuit", halter=True).panels}
    assert "left_btorso_strap" in panels and "pant_f_l" in panels


@pytest.mark.parametrize(
    ("text", "trims"),
    [
        ("skort", {"outer skirt"}),
        ("swimsuit with a little skirt", {"outer skirt"}),
        ("leotard with a skirt", {"outer skirt"}),
        ("trousers", {"fly", "slant pockets"}),
        ("tailored shorts", {"fly", "back welt pockets"}),
        ("hiking trousers", {"fly", "cargo pockets"}),
        ("pyjama jacket", {"buttons", "chest pocket"}),
        ("scout shirt", {"chest pockets", "epaulettes"}),
    ],
)
def test_names_mean_what_is_put_on_them(text, trims, reader):
    heard = hear_description(text, reader)
    wanted = trims_wanted(heard, draft=heard.drafts[0].name)
    assert trims <= {name for wish in wanted for name in wish.choices[0]}


@pytest.mark.parametrize(("text", "flies"), [("trousers", True), ("trousers with an elastic waist", False)])
def test_what_is_drawn_up_over_the_hips_has_a_fly_only_where_one_is_asked_for(text, flies, reader):
    heard = hear_description(text, reader)
    wanted = trims_wanted(heard, draft=heard.drafts[0].name)
    assert any("fly" in names for wish in wanted for names in wish.choices) == flies


def test_no_laces_at_the_waist_are_no_drawstring(reader):
    heard = hear_description("pull-on trousers, no laces", reader)
    assert "drawstring" in refused_trims(heard)


@pytest.mark.parametrize("depth", [7.0, 20.0])
def test_a_high_halter_is_round(depth):
    made = NamedDraft("swimsuit", (("halter", True), ("neck_depth", depth)))
    assert (("collar", "stand") in made.is_to_the_eye) == (depth < 11.0)
