"""Trims that are told by their place, and how far they go."""

from __future__ import annotations

import pytest

from swifttailor.pattern.drafts.draft_names import NamedDraft
from swifttailor.wishes.descriptions.sayings_of_wishes import plainly_wished, without_asides
from swifttailor.wishes.drafts.legs_by_words import legs_as_said
from swifttailor.wishes.heard import Heard
from swifttailor.wishes.trims.trims_by_place import is_elastic_behind, trims_by_place
from swifttailor.wishes.trims.trims_wanted import trims_wanted
from swifttailor.wording import read_words


def first(text: str, kind: str, draft: str = "") -> tuple[str, ...]:
    """The trims of the first thing that is put on for a text."""
    text = plainly_wished(without_asides(text))
    words = read_words(text)
    wanted = trims_wanted(Heard(text, lacks=tuple(words.lacks), words=words), draft, kind)
    return next(wish.choices[0] for wish in wanted if wish.said)


@pytest.mark.parametrize(
    ("text", "kind", "names"),
    [
        ("a cotton dress with buttons down to the waist", "dress", ("waist placket",)),
        ("a dress buttoned as far as the waist", "dress", ("waist placket",)),
        ("a dress with pearl buttons from the neck to the waist", "dress", ("waist placket",)),
        ("a dress with a buttoned bodice", "dress", ("waist placket",)),
        ("ein Kleid mit Knöpfen bis zur Taille", "dress", ("waist placket",)),
        ("une robe boutonnée jusqu'à la taille", "dress", ("waist placket",)),
        ("a cycling top with pockets at the back", "top", ("lower back pockets",)),
        ("trousers with pockets at the back", "trousers", ("back pockets",)),
        ("leggings with a pocket for my phone on the thigh", "trousers", ("thigh pocket",)),
        ("trousers with pockets on both thighs", "trousers", ("cargo pockets",)),
        ("trousers with slanted pockets", "trousers", ("slant pockets",)),
        ("a tunic with two big pockets low down", "top", ("patch pockets",)),
        ("a tunic with two pockets at hip height", "top", ("patch pockets",)),
        ("a tabard with a big pocket on the front", "top", ("front pocket",)),
        ("a tunic with one big pocket", "top", ("front pocket",)),
        ("a shirt with one pocket on the chest", "top", ("chest pocket",)),
        ("ein Hemd mit Taschen auf der Brust", "top", ("chest pockets",)),
        ("a dress with a long zip down the back", "dress", ("back zip",)),
        ("a jumper with a zip to the chest", "top", ("half zip",)),
        ("a skirt with a zip at the side", "skirt", ("side zip",)),
        ("trousers with elastic at the back of the waistband only", "trousers", ("back elastic",)),
        ("trousers with double knees", "trousers", ("knee patches",)),
        ("trousers with patches on the knees", "trousers", ("knee patches",)),
    ],
)
def test_lies_where_it_is_told(text, kind, names):
    assert first(text, kind) == names


def test_a_pocket_in_front_of_a_hoodie_is_a_kangaroos():
    assert first("a hoodie with a pocket on the front", "top", "hoodie") == ("kangaroo pocket",)


@pytest.mark.parametrize(
    ("text", "what"),
    [
        ("a dress with pockets and a bow at the back", "pockets"),
        ("a dress without pockets at the back", "pockets"),
        ("a coat with buttons at the waist", "buttons"),
        ("a shirt with buttons, a zip at the back", "buttons"),
    ],
)
def test_places_of_others_are_not_its(text, what):
    assert trims_by_place(text, what) == ()


@pytest.mark.parametrize(
    "text",
    ["elastic at the back only", "flat front, elasticated back", "a part-elasticated waist", "half elastic"],
)
def test_trousers_that_are_gathered_behind_alone_are_smooth_in_front(text):
    assert is_elastic_behind(text)
    legs = NamedDraft("pull-on-trousers", (("length", 99.0),))
    assert legs_as_said(legs, text, ("elastic",), ()).name == "trousers"
    assert not is_elastic_behind("elastic at the waist")


@pytest.mark.parametrize(
    "text", ["a really deep v neck", "v-neck that goes to the breastbone", "a super deep v neckline"]
)
def test_a_really_deep_v_is_the_deepest(text):
    claims = [i.claim for i in read_words(plainly_wished(without_asides(text))).implications]
    assert ("neck_depth", "plunging") in [(c.name, c.value) for c in claims]
