"""Names the wrong way round in search boxes, and German adjectives that read as comparisons."""

from __future__ import annotations

import pytest

from swifttailor.wishes.text.german_adjectives import adjectives_plainly
from swifttailor.wishes.text.names_turned import names_turned


@pytest.mark.parametrize(
    ("text", "turned"),
    [
        ("skirt pencil black", "pencil skirt black"),
        ("grey skirt school", "grey school skirt"),
        ("black trousers work", "black work trousers"),
        ("jacket leather brown", "leather jacket brown"),
        ("dress slip black satin", "slip dress black satin"),
        ("jacket bomber olive", "bomber jacket olive"),
        ("summer frock", "summer dress"),
        ("dress wedding guest", "wedding guest dress"),
    ],
)
def test_a_garment_stands_behind_what_it_is(text, turned):
    assert names_turned(text) == turned


@pytest.mark.parametrize(
    "text",
    [
        "shirt dress white",
        "skirt suit navy",
        "tea dress floral",
        "top lace sleeves",
        "a skirt with a pencil in its pocket",
        "skirt, school",
        "dress and jacket leather",
        "frock",
        "frock coat",
        "jacket jeans",
    ],
)
def test_other_texts_stay(text):
    assert names_turned(text) == text


@pytest.mark.parametrize(
    ("text", "plain"),
    [
        ("Kleid, enge Taille, weiter Rock", "Kleid, enge Taille, weite Rock"),
        ("ein dunkler Mantel", "ein dunkle Mantel"),
        ("den Rock etwas weiter", "den Rock etwas weiter"),
        ("weiter unten", "weiter unten"),
    ],
)
def test_adjectives_before_nouns_are_no_comparisons(text, plain):
    assert adjectives_plainly(text) == plain
