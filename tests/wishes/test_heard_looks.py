"""Looks of parts as they are heard: what is assumed, what no garment can have, and edits that cut nothing."""

from __future__ import annotations

import pytest

import swifttailor
from swifttailor.describing.measuring import measure_facts
from swifttailor.garment.part_looks import SEVERAL_LAYERS, PartLook
from swifttailor.wishes.descriptions.hearing import hear_description
from swifttailor.wishes.instructions.hearing_changes import hear_instruction
from swifttailor.wishes.instructions.without_looks import without_looks
from swifttailor.wishes.reader import WishReader
from swifttailor.wording.lexicon import read_words

WHITE_COLLAR = PartLook("collar", "#ffffff")


@pytest.fixture(scope="module")
def reader() -> WishReader:
    return WishReader.load()


@pytest.fixture(scope="module")
def dress():
    return measure_facts(swifttailor.draft("shirt-dress", collar="folded"))


def looks(text, reader):
    return set(hear_description(text, reader).looks.looks)


def test_a_dress_of_lace_is_lined_but_for_its_sleeves(reader):
    heard = hear_description("black lace dress", reader)
    assert set(heard.looks.looks) == {PartLook("all", None, "lace", 1.0), PartLook("sleeves", None, "lace")}
    assert "lined" in heard.looks.assumed[0] and heard.color == "#000000"
    assert not heard.cannot and not heard.unread


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("mesh t-shirt", {PartLook("all", None, "mesh")}),
        ("white lace top", {PartLook("all", None, "lace")}),
        ("mesh dress", {PartLook("all", None, "mesh")}),
        ("see-through mesh dress", {PartLook("all", None, "mesh")}),
        ("sheer chiffon dress", {PartLook("all", None, "chiffon")}),
        (
            "tulle skirt",
            {PartLook("all", None, "tulle", 1.0), PartLook("skirt", None, "tulle", SEVERAL_LAYERS)},
        ),
        ("dress with a lace bodice", {PartLook("bodice", None, "lace", 1.0)}),
        ("dress with sheer lace sleeves", {PartLook("sleeves", None, "lace")}),
        ("navy varsity jacket", {PartLook("sleeves", "#f4f1e8")}),
        ("white varsity jacket", {PartLook("sleeves", "#1f2a44")}),
        ("varsity jacket with red sleeves", {PartLook("sleeves", "#ab252e")}),
        ("black net skirt, mini", {PartLook("all", "#000000", "net")}),
        (
            "trousers, one leg red, one leg green",
            {PartLook("left_leg", "#ab252e"), PartLook("right_leg", "#40724f")},
        ),
        (
            "tunic, half red, half white",
            {PartLook("left_half", "#ab252e"), PartLook("right_half", "#ffffff")},
        ),
    ],
)
def test_what_cloths_are_on_which_parts(text, expected, reader):
    assert looks(text, reader) == expected


def test_a_sheer_skirt_of_a_chiffon_dress_is_of_chiffon(reader):
    assert PartLook("skirt", None, "chiffon") in looks("chiffon maxi dress with a sheer skirt", reader)


@pytest.mark.parametrize(
    ("text", "cannot"),
    [
        ("jumpsuit with orange shoulders", "another colour of the shoulders"),
        (
            "dress with mesh inserts",
            "sheer insets (whole parts can be sheer: sleeves, a skirt, the back)",
        ),
        ("jumper with leather sleeves", "another cloth of the sleeves (another shade is drawn)"),
        (
            "black dress with mesh panels",
            "sheer insets (whole parts can be sheer: sleeves, a skirt, the back)",
        ),
    ],
)
def test_what_is_no_part_of_its_own_is_said_to_be_impossible(text, cannot, reader):
    heard = hear_description(text, reader)
    assert cannot in heard.cannot and not heard.unread


def test_the_colour_of_a_part_is_not_that_of_the_garment(reader):
    heard = hear_description("dress with a white collar", reader)
    assert heard.color is None and WHITE_COLLAR in heard.looks.looks
    striped = hear_description("striped shirt with a red collar", reader)
    assert striped.print is not None and "#ab252e" not in striped.print.colors
    assert heard.looks.lines == ("collar in white (#ffffff)",)


@pytest.mark.parametrize(
    "text",
    [
        "make the sleeves sheer",
        "a white collar, please",
        "make the collar white",
        "make the collar and cuffs navy",
        "I'd like the sleeves in red",
        "sleeves in black lace, please",
        "change the collar to red",
        "the skirt should be of tulle",
        "make it see-through",
    ],
)
def test_an_edit_of_looks_cuts_nothing(text, reader, dress):
    heard = hear_instruction(text, reader, dress)
    assert heard.looks.looks and heard.color is None
    assert not heard.sure and not heard.perhaps and not heard.unsure
    assert not heard.unread and not heard.cannot


@pytest.mark.parametrize(
    ("text", "rest"),
    [
        ("make the sleeves sheer and 10 cm longer", "make the sleeves 10 cm longer"),
        ("make the collar white and the skirt longer", "and the skirt longer"),
        ("make the skirt longer, and the collar white", "make the skirt longer,"),
        ("make the skirt longer", "make the skirt longer"),
        ("make it red", "make it red"),
        ("white collar and cuffs", ""),
        ("a hood in red", "a hood in"),
    ],
)
def test_what_is_left_of_an_instruction_is_about_the_cut(text, rest, dress):
    assert without_looks(text, read_words(text, kind="dress"), dress) == rest


def test_both_halves_of_an_instruction_are_heard(reader, dress):
    heard = hear_instruction("make the sleeves sheer and 10 cm longer", reader, dress)
    assert heard.looks.looks == (PartLook("sleeves", None, "sheer"),)
    (wish,) = heard.sure
    assert wish.change.quantity == "sleeve length" and wish.change.amount == 10
    assert heard.text == "make the sleeves sheer and 10 cm longer"


def test_a_part_that_is_not_there_is_asked_for_in_its_colour(reader):
    plain = measure_facts(swifttailor.draft("skater-dress"))
    heard = hear_instruction("add a white collar", reader, plain)
    assert heard.looks.looks == (WHITE_COLLAR,)
    assert any(
        getattr(wish.change, "claim", None) and wish.change.claim.name == "collar" for wish in heard.sure
    )


@pytest.mark.parametrize(
    ("text", "look"),
    [
        ("a pink dirndl", PartLook("sleeves", "#f7f5ef")),
        ("a vyshyvanka", PartLook("edging", "#a8202c")),
        ("a Lucia gown", PartLook("belt", "#b3202b")),
        ("a dirndl with black sleeves", PartLook("sleeves", "#000000")),
        ("red saree with gold border", PartLook("edging", "#c9a227")),
        ("a dinner jacket", PartLook("collar", "#35353c")),
        ("a white blazer with satin lapels", PartLook("collar", "#dbdbdb")),
        ("a red tuxedo jacket with black satin lapels", PartLook("collar", "#000000")),
        ("a black jacket with leather sleeves", PartLook("sleeves", "#292929")),
        ("blue sari with a gold blouse", PartLook("bodice", "#c9a227")),
    ],
)
def test_names_have_parts_of_their_own_colour_unless_another_is_said(text, look, reader):
    of_part = [each for each in looks(text, reader) if each.part == look.part]
    assert of_part == [look]


def test_a_colour_of_a_name_is_said_to_be_assumed(reader):
    heard = hear_description("a dirndl", reader).looks
    assert any(line.startswith("sleeves in ") for line in heard.assumed)
