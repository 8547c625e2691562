"""A second colour on blocks, and on what is said to contrast."""

import pytest

from swifttailor.garment.color_blocks import block_panels
from swifttailor.pattern.panel_parts import Part
from swifttailor.wording.lexicon import read_words


@pytest.mark.parametrize(
    ("text", "own", "parts"),
    [
        ("mod shift dress, black and white colour block", "black", {"blocks": "white"}),
        ("bowling shirt, two tone, turquoise and black", "turquoise", {"blocks": "black"}),
        ("kimono robe, contrast band, black/gold", "black", {"edging": "gold"}),
        ("shirt, contrast collar and cuffs, white and navy", "white", {"collar": "navy", "cuffs": "navy"}),
        ("jersey, yellow with black side panels", "yellow", {"side_panels": "black"}),
        ("two tone jacket, green with cream sleeves", "green", {"sleeves": "cream"}),
        (
            "track pants, navy, white stripes down the sleeves and legs",
            "navy",
            {"side_stripes": "white"},
        ),
    ],
)
def test_the_second_colour_is_said_of_a_part(text, own, parts):
    reading = read_words(text)
    assert reading.colors[0].words == own
    assert {look.part: look.color.words for look in reading.looks if look.color} == parts


@pytest.mark.parametrize(
    ("parts", "second"),
    [
        ({"a": Part.TORSO, "s": Part.SLEEVE, "k": Part.SKIRT}, ("k",)),
        ({"a": Part.TORSO, "s": Part.SLEEVE, "c": Part.COLLAR}, ("s", "c")),
        ({"left_ftorso": Part.TORSO, "right_ftorso": Part.TORSO}, ("right_ftorso",)),
        ({"skirt_front": Part.SKIRT, "skirt_back": Part.SKIRT}, ("skirt_back",)),
        ({"only": Part.SKIRT}, ()),
    ],
)
def test_blocks_are_some_panels_and_never_all(parts, second):
    assert block_panels(parts) == second
