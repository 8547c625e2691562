"""What names of legs, underwear, nightwear and working clothes begin from."""

from __future__ import annotations

import pytest

import swifttailor
from swifttailor.describing.claims import Claim
from swifttailor.pattern.drafts.draft_names import NamedDraft
from swifttailor.wishes.descriptions.hearing import hear_description
from swifttailor.wishes.drafts.swimsuits_as_asked import on_a_halter
from swifttailor.wishes.reader import WishReader


@pytest.fixture(scope="module")
def reader() -> WishReader:
    return WishReader.load()


@pytest.mark.parametrize(
    ("text", "name", "options"),
    [
        ("high waist knickers", "briefs", {"below_waist": 2.0}),
        ("bikini bottoms", "briefs", {"below_waist": 10.0}),
        ("nightie", "shift-dress", {"sleeve_length": 22.0}),
        ("nightgown", "shift-dress", {"sleeve_length": 58.0}),
        ("cuffed cargo joggers", "joggers", {"leg_ease": 18.0}),
        ("boys shorts cargo", "trousers", {"length": 62.0}),
        ("maternity jeans", "leggings", {"band_height": 13.0}),
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
        ("jeans blue ripped knees", "trousers", {"length": 100.0}),
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
