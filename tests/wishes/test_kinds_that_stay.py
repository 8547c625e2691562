"""Garments stay what they are called, whatever details are told of them; and names are what they are."""

from __future__ import annotations

import pytest

from swifttailor.wishes.descriptions.hearing import hear_description
from swifttailor.wishes.heard import Heard
from swifttailor.wishes.reader import WishReader
from swifttailor.wording.wish_lines import wish_line


@pytest.fixture(scope="module")
def hear():
    reader = WishReader.load()
    return lambda text: hear_description(text, reader)


def told(heard: Heard) -> set[str]:
    return {wish_line(w.change) for w in (*heard.sure, *heard.likely)}


@pytest.mark.parametrize(
    ("text", "kind", "never_told"),
    [
        ("running shorts w side slits and a lining", "shorts", "slits"),
        ("proper tailored wide trousers, flat at the front, side zip", "trousers", "chest"),
        ("fitted trousers with a split at the ankle", "trousers", "slits"),
    ],
)
def test_details_never_change_the_kind(hear, text, kind, never_told):
    heard = hear(text)
    assert heard.kind == kind
    assert not any(never_told in line for line in told(heard))


@pytest.mark.parametrize(
    "text",
    [
        "black to the floor, long sleeves, and I would rather have one piece than a skirt and top",
        "something in one piece, not a skirt and top, navy, to the knee, long sleeves",
        "I'd rather wear one piece than separates, long sleeves, to the floor",
    ],
)
def test_one_piece_rather_than_two_is_a_dress(hear, text):
    assert hear(text).kind == "dress"
    assert "separate_pieces" not in {lack.what for lack in hear(text).lacks}


@pytest.mark.parametrize(
    ("text", "draft", "options"),
    [
        ("burkini", "jumpsuit", {"sleeves": True}),
        ("muscle tee", "tank-top", {"strap_width": 11.0}),
        ("long line sports bra", "tank-top", {"length": -5.0}),
        ("velvet smoking jacket", "blazer", {"lapels": "shawl"}),
        ("a coat dress in plum wool, with a shawl collar", "coat", {"lapels": "shawl"}),
        ("long sleeveless gilet in camel wool", "coat", {"length": 62.0}),
        ("wool cape coat with arm slits", "cape", {}),
        ("a twinset", "cardigan", {}),
        ("for karate: jacket crossing over in front, elbow sleeves", "cardigan", {"opening": -8.0}),
    ],
)
def test_names_are_what_they_are_called(hear, text, draft, options):
    first = hear(text).drafts[0]
    assert first.name == draft and options.items() <= dict(first.options).items()


@pytest.mark.parametrize(
    ("text", "line"),
    [
        ("a top thats like a shirt but cut off under the boobs", "where a top ends: bra"),
        ("a column gown cut high at the throat", "how deep the front neckline is, where it is seen: high"),
        ("Hochgeschlossene Bluse", "how deep the front neckline is, where it is seen: high"),
        (
            "a dress with sleeves narrow to the elbow and then open over the hand",
            "shape of both sleeves: bell",
        ),
        ("a blouse whose sleeves are huge and gathered at the wrist", "shape of both sleeves: balloon"),
    ],
)
def test_what_people_say_of_cuts(hear, text, line):
    assert line in told(hear(text))


def test_what_somebody_is_tired_of_is_no_wish(hear):
    heard = hear("I'm fed up of sacks. I want tailored wide trousers")
    assert heard.kind == "trousers" and not heard.contradictions


def test_shoes_that_are_worn_with_it_are_no_garment(hear):
    heard = hear("wide trousers in navy crepe, hemmed so I can wear them with trainers")
    assert {lack.what for lack in heard.lacks}.isdisjoint({"shoes", "separate_pieces"})
    assert not heard.unread


@pytest.mark.parametrize(
    ("text", "kind"),
    [
        ("a shepherd costume for the nativity, so a plain brown tunic with big sleeves", "tunic"),
        ("Receptionist uniform, fitted shirt with short sleeves, teal", "top"),
    ],
)
def test_a_costume_is_what_it_is_said_to_be(hear, text, kind):
    heard = hear(text)
    assert heard.kind == kind and "separate_pieces" not in {lack.what for lack in heard.lacks}


def test_a_rope_round_a_tunic_is_a_belt_and_at_trousers_a_drawstring(hear):
    assert "belt" in {lack.what for lack in hear("a brown tunic with a rope belt").lacks}
    assert "drawstring" in {lack.what for lack in hear("linen trousers with a rope belt").lacks}


@pytest.mark.parametrize(
    ("text", "color"), [("jeans in a dark wash", "#22304a"), ("a black tie jumpsuit", "#18181b")]
)
def test_washes_and_dress_codes_have_their_colours(hear, text, color):
    assert hear(text).color == color
