"""Two colours that a text names side by side are both seen; what is left over is told."""

from __future__ import annotations

import pytest

from swifttailor.describing.differences import Gain
from swifttailor.garment.part_looks import PartLook
from swifttailor.wishes.heard import Heard
from swifttailor.wishes.looks.joined_colors import joined_colors
from swifttailor.wishes.looks.refused_colors import color_besides, is_like
from swifttailor.wishes.looks.second_colors import second_where_it_fits
from swifttailor.wishes.outfits.two_garments import two_garments
from swifttailor.wishes.reader import Wish
from swifttailor.wording import read_words


def heard(text: str) -> Heard:
    words = read_words(text)
    kinds = [i.claim for i in words.implications if i.claim.name == "kind"]
    sure = tuple([Wish(Gain(claim), 1.0) for claim in kinds])
    return Heard(text, words=words, lacks=words.lacks, sure=sure).with_looks()


@pytest.mark.parametrize(
    ("text", "colors"),
    [
        ("black and white dress", ("black", "white")),
        ("red/black t-shirt", ("red", "black")),
        ("dress in navy, dark red & cream", ("navy", "dark red", "cream")),
        ("a red or blue dress", ()),
        ("navy blue dress", ()),
        ("a red dress like the blue one", ()),
    ],
)
def test_colours_are_joined_where_they_stand_side_by_side(text, colors):
    assert tuple(color.words for color in joined_colors(text, read_words(text))) == colors


@pytest.mark.parametrize(
    ("text", "part", "color"),
    [
        ("black and white dress", "blocks", "#ffffff"),
        ("white and red tracksuit bottoms", "side_stripes", "#ab252e"),
        ("green and pink dirndl", "apron", "#f2a9bb"),
        ("black and gold dress", "edging", "#c9a227"),
    ],
)
def test_the_second_colour_is_on_what_differs_anyway_else_on_blocks(text, part, color):
    said = heard(text)
    assert said.looks.second == part and not said.missed_colors
    assert [look.color for look in said.looks.looks if look.part == part] == [color]


@pytest.mark.parametrize(
    "text", ["black dress with white collar", "navy and white striped top", "a red or blue dress"]
)
def test_no_second_colour_where_a_text_says_where_it_goes(text):
    assert not heard(text).looks.second and not heard(text).missed_colors


def test_a_colour_that_nothing_is_in_is_told():
    assert heard("green tank top with yellow").cannot == ("one more colour (yellow)",)


def test_what_a_garment_has_not_does_not_hide_the_second_colour():
    looks = heard("green and pink dirndl").looks
    found = second_where_it_fits(looks, {"blocks", "sleeves"}.__contains__)
    assert found.second == "blocks" and PartLook("blocks", "#f2a9bb") in found.looks
    assert second_where_it_fits(looks, lambda _: True) is looks


@pytest.mark.parametrize(
    ("text", "motif", "count"),
    [
        ("black and white skirt", "two_blocks", 2),
        ("red, white and blue dress", "blocks", 3),
        ("colour block dress in red, yellow, blue and green", "four_blocks", 4),
    ],
)
def test_bands_have_as_many_colours_as_are_named(text, motif, count):
    found = heard(text).print
    assert found is not None and (found.motif, len(found.colors)) == (motif, count)


@pytest.mark.parametrize(
    ("text", "upper", "lower"),
    [
        ("white and red suit", "white blazer", "red tailored trousers"),
        ("a suit in light blue and white", "a light blue blazer", "white tailored trousers"),
        ("black and white pinstripe suit", "black and white pinstripe blazer", None),
    ],
)
def test_the_halves_of_a_suit_share_its_colours(text, upper, lower):
    outfit = two_garments(text)
    assert outfit is not None and outfit.upper == upper
    assert lower is None or outfit.lower == lower


@pytest.mark.parametrize(
    ("text", "parts"),
    [
        ("dress with one red sleeve and one white sleeve", {"left_sleeve": "red", "right_sleeve": "white"}),
        ("trousers, one leg black the other white", {"left_leg": "black", "right_leg": "white"}),
        ("a tee with one red and one blue sleeve", {"left_sleeve": "blue", "right_sleeve": "red"}),
        ("dress with red sleeves", {"sleeves": "red"}),
    ],
)
def test_sleeves_and_legs_may_differ(text, parts):
    assert {look.part: look.color.words for look in read_words(text).looks if look.color} == parts


def test_what_is_refused_is_not_nearly_so():
    assert is_like("4a4f5a", "000000") and not is_like("365c96", "000000")
    assert color_besides([]) is None
    assert color_besides(["365c96"]) != color_besides(["000000"])
    assert heard("trousers, anything but black").color is None
    assert heard("trousers, anything but black").color_besides is not None
