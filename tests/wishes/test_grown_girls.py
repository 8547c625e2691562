"""Girls who are grown, and such as are not."""

from __future__ import annotations

import pytest

from swifttailor.wishes.wearers.grown_girls import with_grown_girls
from swifttailor.wishes.wearers.wearer_words import hear_wearer


@pytest.mark.parametrize(
    "text",
    [
        "bridesmaid dresses for three girls of very different sizes",
        "hey girl, I need a red dress",
        "dresses for the tall girls",
        "an office girl skirt, I'm the girl who works late",
        "tops for the girls on the hen do",
    ],
)
def test_grown_girls_wear_no_childrens_sizes(text):
    assert hear_wearer(text).wearer is None


@pytest.mark.parametrize(
    ("text", "height"),
    [
        ("Tall girl looking for wide leg jeans", 180.0),
        ("I'm a short girl, I need jeans", 157.0),
        ("I am a petite girl and want a maxi dress", 157.0),
    ],
)
def test_their_heights_are_those_of_women(text, height):
    wearer = hear_wearer(text).wearer
    assert wearer is not None and wearer.figure == "women"
    assert wearer.measures is not None and wearer.measures["height"] == height


@pytest.mark.parametrize(
    "text",
    [
        "a skirt for a tall girl, 10 years old",
        "flower girl dress",
        "a dress for a little girl",
        "a dress for my little one",
        "a coat for my granddaughter",
        "a party dress for a girl of 7",
    ],
)
def test_children_still_do(text):
    assert with_grown_girls(text) == text
    wearer = hear_wearer(text).wearer
    assert wearer is not None and (wearer.size or "").startswith("children")
