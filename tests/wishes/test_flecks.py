"""Tweed has flecks, and prints have the colours that go with their names."""

from __future__ import annotations

import pytest

from swifttailor.wishes.looks.flecks import flecked, is_flecked
from swifttailor.wishes.looks.heard_print import heard_print
from swifttailor.wording import read_words


def test_tweed_alone_is_flecked_and_keeps_its_colour_between_its_threads():
    assert is_flecked(read_words("a Harris tweed jacket")) and not is_flecked(read_words("a wool jacket"))
    assert not is_flecked(read_words("a jacket, no tweed"))
    dark, light = flecked("#808080").colors
    assert dark < "#808080" < light


@pytest.mark.parametrize(
    ("text", "colors"),
    [
        ("cherry print dress", ("#f6f1e6", "#b3202c", "#3f7a3c")),
        ("white dress with cherry print", ("#ffffff", "#b3202c", "#3f7a3c")),
        ("ladybird print dress", ("#f6f1e6", "#b3202c")),
        ("pj bottoms with little foxes on", ("#dfe6e2", "#d0702c", "#f8f2e6", "#33261f")),
        ("a blue dress with bees", ("#365c96", "#efc03a", "#c9d8e2", "#2b2622")),
        ("navy dress with white stars", ("#1f2a44", "#ffffff")),
        ("dress with red hearts", ("#f4f1e8", "#ab252e")),
        ("pinstripe trousers", ("#2a2f3a", "#a9afb9")),
        ("huipil", ("#a8243a", "#f3ece0")),
        ("blue huipil", ("#365c96", "#f3ece0")),
    ],
)
def test_prints_have_the_colours_of_their_names(text, colors):
    found = heard_print(text, read_words(text))
    assert found is not None and found.colors == colors
