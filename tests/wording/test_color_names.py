"""Colours are called by plain names that the tables know."""

from __future__ import annotations

import pytest

from swifttailor.wording import read_words
from swifttailor.wording.lexicon.color_names import PLAIN, color_name


@pytest.mark.parametrize("name", PLAIN)
def test_a_name_that_is_said_is_read_as_that_colour(name):
    (color,) = read_words(f"a {name} dress").colors
    assert color_name(color.rgb) == name


@pytest.mark.parametrize(
    ("rgb", "name"),
    [("#7e1522", "dark red"), ("#fafafa", "white"), ("#2a2f45", "navy"), ("#8fb9dd", "soft sky blue")],
)
def test_a_colour_has_the_name_of_the_nearest(rgb, name):
    assert color_name(rgb) == name
