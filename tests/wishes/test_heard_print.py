"""Prints that texts ask for, and languages and spellings that are told."""

from __future__ import annotations

import pytest

from swifttailor.wishes.looks.heard_print import asks_for_plain, heard_print, print_line
from swifttailor.wishes.text.lexicon_spelling import guessed_name, lexicon_spelling
from swifttailor.wording.lexicon import foreign_language, read_words


def asked(text):
    return heard_print(text, read_words(text))


@pytest.mark.parametrize(
    ("text", "kind", "colors"),
    [
        ("navy and white striped top", "stripes", ("#1f2a44", "#ffffff")),
        ("a red dress with white polka dots", "dots", ("#ab252e", "#ffffff")),
        ("white dots on a dark blue dress", "dots", ("#1d2f5e", "#ffffff")),
        ("dress with red dots", "dots", ("#f4f1e8", "#ab252e")),
        ("a Breton top", "stripes", ("#f4f1e8", "#1f2a44")),
        ("gingham skirt in red", "checks", ("#ab252e", "#f4f1e8")),
    ],
)
def test_colours_have_their_places_in_a_print(text, kind, colors):
    found = asked(text)
    assert found is not None and (found.kind, found.colors) == (kind, colors)


def test_direction_and_size_are_obeyed():
    down = asked("shirt with 2 cm vertical stripes")
    assert down is not None and (down.size("angle"), down.size("width"), down.size("gap")) == (90, 2, 2)
    around = asked("stripy dress, horizontal")
    assert around is not None and around.size("angle") == 0
    dots = asked("dots 3 cm wide")
    assert dots is not None and dots.size("radius") == 1.5
    assert "down the body" in print_line(down) and "2 and 2 cm" in print_line(down)


@pytest.mark.parametrize(
    ("text", "angle", "width"),
    [
        ("a striped shirt", 90, 1.2),
        ("striped pyjama bottoms", 90, 1.2),
        ("wide striped shirt", 90, 6),
        ("shirt with 3 cm stripes", 90, 3),
        ("shirt with horizontal stripes", 0, 2.5),
        ("a striped tee", 0, 2.5),
        ("a striped jumper", 0, 2.5),
    ],
)
def test_stripes_run_down_shirts_and_trousers_and_around_knits(text, angle, width):
    found = asked(text)
    assert found is not None and (found.size("angle"), found.size("width")) == (angle, width)


def test_no_print_is_heard_where_none_is_asked_for():
    assert asked("a plain blue dress") is None and asks_for_plain(read_words("a plain blue dress"))
    assert asked("a dress without stripes") is None and asks_for_plain(read_words("a dress without stripes"))
    assert asked("a dress") is None and not asks_for_plain(read_words("a dress"))


@pytest.mark.parametrize(
    ("text", "language"),
    [
        ("czarna sukienka do kolan bez rękawów", "Polish"),
        ("en klänning med långa ärmar", "Swedish"),
        ("黒いロングスカート", "Japanese"),
        ("赤いワンピース、長袖", "Japanese"),
        ("abito da sera nero senza spalline", None),
        ("een spijkerbroek met wijde pijpen", None),
        ("saia preta até o joelho", None),
        ("a nice dress with pockets", None),
        ("robe noire sans manches", None),
    ],
)
def test_languages_that_are_not_read_are_told(text, language):
    assert foreign_language(text, read_words(text).unknown) == language


def test_spellings_that_sound_alike_are_put_right_and_others_are_guesses():
    assert lexicon_spelling("assymetric") == "asymmetric"
    assert lexicon_spelling("batteau") == "bateau"
    assert lexicon_spelling("hoddie") == "hoodie"
    assert lexicon_spelling("wuzzle") is None and lexicon_spelling("cardagan") is None
    assert guessed_name(["cardagan"]) == ("cardagan", "cardigan")
    assert guessed_name(["wuzzle"]) is None


def test_a_print_has_all_colours_that_its_name_says() -> None:
    found = heard_print("a tie dye t-shirt", read_words("a tie dye t-shirt"))
    assert found is not None
    assert len(set(found.colors)) == 4
    assert "#f0b63f" in found.colors


@pytest.mark.parametrize(
    ("text", "kind", "colors"),
    [
        ("a broderie anglaise blouse", "dots", ("#f7f6f1", "#b4b1aa")),
        ("a crochet top", "dots", ("#f2ebde", "#b3a48f")),
        ("sequin mini skirt silver", "dots", ("#c0c0c0", "#d9d9d9")),
    ],
)
def test_holes_and_sequins_are_in_the_colour_of_their_cloth(text, kind, colors):
    found = heard_print(text, read_words(text))
    assert found is not None and (found.kind, found.colors) == (kind, colors)
