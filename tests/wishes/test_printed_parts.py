"""Prints that are said of parts alone."""

from __future__ import annotations

import pytest

from swifttailor.garment.part_looks import PartLook, plain_but_for
from swifttailor.wishes.looks.heard_looks import heard_looks
from swifttailor.wishes.looks.heard_print import heard_print
from swifttailor.wishes.looks.printed_parts import printed_parts
from swifttailor.wording.lexicon import read_words


@pytest.mark.parametrize(
    ("text", "parts", "unmade"),
    [
        ("white tee with striped sleeves", ("sleeves",), ()),
        ("grey sweatshirt with leopard print sleeves", ("sleeves",), ()),
        ("shirt with a floral collar and cuffs", ("collar", "cuffs"), ()),
        ("blue shirt, sleeves in tartan", ("sleeves",), ()),
        ("white dress with a floral skirt", ("skirt",), ()),
        ("navy dress with white polka dot skirt", ("skirt",), ()),
        ("blue jeans with leopard print pockets", (), ("pockets",)),
        ("white dress with gingham trim", (), ("trim",)),
        ("polka dot dress with striped sleeves", (), ("sleeves",)),
        ("navy dress with striped sleeves and floral collar", ("sleeves",), ("collar",)),
        ("floral skirt", (), ()),
        ("floral ruffle dress", (), ()),
        ("striped shirt with white collar", (), ()),
        ("polka dot tie neck blouse", (), ()),
        ("a floral top with sleeves", (), ()),
    ],
)
def test_a_print_is_on_the_parts_that_it_is_said_of(text, parts, unmade):
    found = printed_parts(text, read_words(text))
    assert (found.parts, found.unmade) == (parts, unmade)


@pytest.mark.parametrize(
    ("text", "kind", "colors"),
    [
        ("grey sweatshirt with leopard sleeves", "motif", ("#cfa266", "#2b1d14", "#9a6a36")),
        ("white tee with red striped sleeves", "stripes", ("#ffffff", "#ab252e")),
        ("polka dot dress with striped sleeves", "dots", ("#f4f1e8", "#1f2a44")),
        ("checked shirt with floral cuffs", "plaid", None),
        ("jeans with leopard print pockets", None, None),
    ],
)
def test_its_colours_are_its_own_and_the_whole_keeps_its_print(text, kind, colors):
    words = read_words(text)
    found = heard_print(text, words, printed_parts(text, words))
    assert (found and found.kind) == kind and (colors is None or (found and found.colors) == colors)


def test_it_is_told_which_parts_have_it_and_which_cannot():
    text = "navy dress with striped sleeves and floral collar"
    words = read_words(text)
    parts = printed_parts(text, words)
    looks = heard_looks(words.looks, "dress", "#1f2a44", heard_print(text, words, parts), parts)
    assert looks.lines == ("sleeves in the print",)
    assert looks.refused == ("another print of the collar",)


def test_the_rest_is_in_the_colour_of_the_garment():
    sleeves = PartLook("sleeves", printed=True)
    assert plain_but_for([sleeves], "#808080") == (PartLook("all", "#808080"), sleeves)
    white = (PartLook("collar", "#ffffff"),)
    assert plain_but_for(white, "#808080") == white
