"""What photographs show is put into words, and made as these are."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from scripted_maker import scripted_maker
from seeing import Seeing, worn

from swifttailor.describing import Claim, measure_facts
from swifttailor.pattern.drafts import draft
from swifttailor.tailor import Tailor
from swifttailor.tailor.picture_words import in_words, over_trousers
from swifttailor.wishes.descriptions.hearing import hear_description
from swifttailor.wishes.reader import WishReader

PHOTO = np.random.default_rng(0).integers(0, 255, (90, 60, 3), np.uint8)
HOODIE = {"kind": ("top", 0.9), "hood": ("hood", 0.8), "sleeves": ("long", 0.9), "top_hem": ("hip", 0.9)}
DRESS = {"kind": ("dress", 0.9), "sleeves": ("none", 0.8), "neckline": ("v", 0.6), "skirt_hem": ("midi", 0.7)}
TOP = {"kind": ("top", 0.9)}
LEGS = {"kind": ("shorts", 0.9), "leg_hem": ("mid-thigh", 0.6), "legs": ("wide", 0.4)}


def seen(name, said):
    return worn(name, {claim: (word, sure) for claim, (word, sure) in said.items()})


@pytest.mark.parametrize(
    ("part", "said", "words", "details"),
    [
        ("upper", HOODIE, "hoodie", "long-sleeved"),
        ("upper", DRESS, "midi dress, sleeveless, V neck", "midi, sleeveless, V neck"),
        ("upper", DRESS | {"straps": ("narrow", 0.9)}, "midi dress with thin straps, V neck", None),
        (
            "upper",
            {"kind": ("top", 0.9), "sleeves": ("short", 0.7), "fit": ("loose", 0.7)},
            "loose T-shirt",
            None,
        ),
        ("upper", TOP | {"sleeves": ("none", 0.7)}, "tank top", "sleeveless"),
        ("upper", TOP | {"collar": ("lapel", 0.7), "sleeves": ("long", 0.4)}, "shirt", ""),
        ("lower", LEGS, "mid-thigh shorts", "mid-thigh"),
        ("lower", {"kind": ("skirt", 0.9), "skirt": ("a-line", 0.8)}, "A-line skirt", "A-line"),
        ("lower", {"kind": ("trousers", 0.9), "leg_hem": ("knee", 0.8)}, "knee-length shorts", "knee-length"),
        ("lower", {}, "trousers", ""),
    ],
)
def test_what_was_read_is_said_as_people_ask_for_it(part, said, words, details):
    reading = seen(part, said)
    assert in_words(reading).startswith(words)
    if details is not None:
        assert in_words(reading, named=True) == details
    assert in_words(reading, frozenset({"neckline"})) == in_words(reading).replace(", V neck", "")


@pytest.mark.parametrize(
    ("called", "said", "words"),
    [
        ("Shirt", {"sleeves": ("short", 0.9), "collar": ("lapel", 0.8)}, "shirt, short-sleeved"),
        ("Blazer", {"sleeves": ("long", 0.9), "top_hem": ("long", 0.9)}, "long blazer"),
        ("Outwear", {"sleeves": ("none", 0.9)}, "gilet"),
        (
            "Longsleeve",
            {"sleeves": ("long", 0.9), "collar": ("turtleneck", 0.8)},
            "roll neck top, long-sleeved",
        ),
        ("Shirt", {"kind": ("dress", 0.95)}, "dress"),
    ],
)
def test_what_photographs_are_called_outweighs_details(called, said, words):
    part = replace(seen("upper", TOP | said), called=called)
    assert in_words(part) == words
    assert in_words(replace(seen("lower", {}), called=called)) == "trousers"
    heard = hear_description(words, WishReader.load())
    assert heard.kind == ("dress" if words == "dress" else "top") and not heard.unread


@pytest.mark.parametrize(
    ("sleeves", "below", "words"),
    [
        ("long", "trousers", "knee-length coat"),
        ("long", "skirt", "knee-length dress, long-sleeved"),
        ("short", "trousers", "knee-length dress, short-sleeved"),
        ("long", None, "knee-length dress, long-sleeved"),
    ],
)
def test_what_looks_like_a_dress_over_trousers_is_a_coat(sleeves, below, words):
    said = {"kind": ("dress", 0.8), "sleeves": (sleeves, 0.9), "skirt_hem": ("knee", 0.7)}
    upper = seen("upper", said)
    lower = [] if below is None else [seen("lower", {"kind": (below, 0.9)})]
    assert in_words(upper, over=over_trousers(upper, [upper, *lower])) == words
    assert not any(over_trousers(one, [one]) for one in (upper, *lower))


def test_every_kind_can_be_said_and_is_heard_again():
    reader = WishReader.load()
    for kind in ("top", "tunic", "dress", "jumpsuit", "playsuit", "skirt", "trousers", "shorts"):
        part = "lower" if kind in ("skirt", "trousers", "shorts") else "upper"
        heard = hear_description(in_words(seen(part, {"kind": (kind, 0.9)})), reader)
        assert heard.kind == kind and not heard.unread


@pytest.fixture
def asked(sewer):
    def asked(said, *, is_photograph=True, is_laid=False):
        eyes = Seeing((seen("upper", said),), is_photograph=is_photograph, is_laid=is_laid)
        return Tailor(scripted_maker([draft("t-shirt")]), sewer, picture_reader=eyes)

    return asked


def test_a_photograph_is_made_of_its_words(asked):
    made = asked(HOODIE).generate(image=PHOTO)
    assert made.answer.draft == "hoodie" and Claim("hood", "hood").holds(measure_facts(made.pattern))
    assert "The picture was put into words: hoodie." in made.notes
    assert made.report["pictures"]["part"] == "upper"
    asked_for = made.report["wishes"]
    assert asked_for and all(wish["from"] == "picture" for wish in asked_for)
    drawn = asked(HOODIE, is_photograph=False).generate(image=PHOTO)
    assert not drawn.answer.draft and not any("put into words" in note for note in drawn.notes)


@pytest.mark.parametrize(("is_laid", "words"), [(False, "loose hoodie"), (True, "hoodie")])
def test_how_close_clothes_are_is_not_seen_on_a_floor(asked, is_laid, words):
    made = asked(HOODIE | {"fit": ("loose", 0.9)}, is_laid=is_laid).generate(image=PHOTO)
    assert f"The picture was put into words: {words}." in made.notes


def test_words_outrank_a_photograph(asked):
    made = asked(HOODIE).generate("a sleeveless dress", PHOTO)
    facts = measure_facts(made.pattern)
    assert facts.kind == "dress" and Claim("sleeves", "none").holds(facts)
    assert any("overruled" in note and "long" in note for note in made.notes)
    longer = asked(HOODIE).generate("in red", PHOTO)
    red = longer.answer.wanted.color
    assert longer.answer.draft == "hoodie" and red is not None and int(red[1:3], 16) > 2 * int(red[3:5], 16)
