"""Words about gowns: trains, overskirts, layers of tulle, capes, cups, guests of weddings, slits."""

from __future__ import annotations

import pytest

from swifttailor.pattern.trims.layers import LAYERS
from swifttailor.wishes.descriptions.sayings_of_wishes import without_asides
from swifttailor.wishes.heard import Heard
from swifttailor.wishes.looks.heard_looks import heard_looks
from swifttailor.wishes.trims.trims_wanted import trims_wanted
from swifttailor.wording.lexicon import read_words


def first_trims(text: str, draft: str = "strapless-dress") -> set[str]:
    words = read_words(text)
    kind = next(str(i.claim.value) for i in words.implications if i.claim.name == "kind")
    looks = heard_looks(words.looks, kind, None, None)
    heard = Heard(text, lacks=tuple(words.lacks), words=words, looks=looks)
    return {name for wish in trims_wanted(heard, draft, kind) for name in wish.choices[0]}


@pytest.mark.parametrize(
    ("text", "trim"),
    [
        ("a wedding dress with a chapel train", "train"),
        ("wedding gown with a cathedral train", "long train"),
        ("a mermaid gown with a long train", "long train"),
        ("a fitted dress with a detachable overskirt", "overskirt"),
        ("wedding dress with a removable tulle overskirt", "tulle overskirt"),
        ("black dress with a tulle overlay", "tulle layers"),
        ("a tulle ball gown with layers", "tulle layers"),
        ("a dress with a big tulle skirt", "tulle layers"),
        ("Cinderella dress in blue", "tulle layers"),
        ("corset dress with cups", "cups"),
        ("a black dress with a peplum", "peplum"),
        ("peplum dress", "peplum"),
        ("a gown with cape sleeves", "back cape"),
        ("a mini dress with a feather hem", "hem fringe"),
    ],
)
def test_is_put_on(text, trim):
    assert trim in first_trims(text)


@pytest.mark.parametrize(
    ("text", "draft"),
    [
        ("a wedding dress", "strapless-dress"),
        ("a lined black dress", "fitted-dress"),
        ("a cape", "cape"),
        ("a cropped jacket with a lining", "blazer"),
        ("a satin skirt", "gathered-skirt"),
    ],
)
def test_nothing_is_put_on_unasked(text, draft):
    assert (LAYERS | {"cups"}).isdisjoint(first_trims(text, draft))


def test_a_skirt_of_tulle_has_layers():
    assert "tulle layers" in first_trims("a tulle skirt", "gathered-skirt")


@pytest.mark.parametrize(
    ("text", "plain"),
    [
        ("something to wear to a summer wedding", "something wedding guest"),
        ("a dress for a beach wedding", "a beach maxi dress"),
        ("a dress for my wedding", "a dress for my wedding"),
        ("the dress for a wedding guest", "the dress for a wedding guest"),
        ("a homecoming dress short and poofy", "a homecoming dress short with a very full skirt"),
        ("a poofy pink prom dress", "a pink prom dress with a very full skirt"),
        ("a dress with poofy sleeves", "a dress with poofy sleeves"),
        ("a puffy jacket", "a puffy jacket"),
        ("a dress, not too poofy", "a dress, not too poofy"),
        ("a dress, no poofy skirt", "a dress, no poofy skirt"),
    ],
)
def test_is_put_plainly(text, plain):
    assert without_asides(text) == plain


def test_a_part_is_as_long_and_wide_as_its_dress():
    reading = read_words("a wedding dress with a full satin skirt")
    hems = {i.claim.value for i in reading.implications if i.claim.name == "skirt_hem"}
    shapes = {i.claim.value for i in reading.implications if i.claim.name == "skirt"}
    assert hems == {"floor"} and "a-line" not in shapes


def test_long_is_said_of_bell_sleeves():
    reading = read_words("a mini wrap dress with long bell sleeves")
    found = {(i.claim.name, i.claim.value) for i in reading.implications}
    assert not reading.contradictions and {("sleeves", "long"), ("skirt_hem", "mini")} <= found


@pytest.mark.parametrize("text", ["a gown with a leg slit", "a gown with a leg split"])
def test_a_slit_over_the_leg_is_one(text):
    reading = read_words(text)
    assert ("slit", "left") in {(i.claim.name, i.claim.value) for i in reading.implications}
    assert not reading.unknown


def test_pastel_alone_is_a_color():
    assert [color.words for color in read_words("a pastel dress").colors] == ["pastel"]
    (blue,) = read_words("a pastel blue dress").colors
    assert blue.rgb != read_words("a pastel dress").colors[0].rgb
