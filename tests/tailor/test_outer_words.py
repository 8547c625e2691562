"""Jackets and coats in photographs are asked for as such."""

from __future__ import annotations

from dataclasses import replace

import pytest
from seeing import worn

from swifttailor.tailor.picture_words import in_words
from swifttailor.wishes.descriptions.hearing import hear_description
from swifttailor.wishes.reader import WishReader


@pytest.mark.parametrize(
    ("said", "words"),
    [
        ({"collar": ("lapel", 0.8)}, "jacket with a zip and a shirt collar, long-sleeved"),
        ({}, "jacket with a zip and a stand collar, long-sleeved"),
        ({"hood": ("hood", 0.8)}, "hooded jacket with a zip, long-sleeved"),
        ({"sleeves": ("none", 0.9)}, "gilet"),
        ({"sleeves": ("short", 0.9)}, "T-shirt, short-sleeved"),
        ({"kind": ("dress", 0.95), "skirt_hem": ("knee", 0.8)}, "knee-length coat"),
    ],
)
def test_outerwear_is_asked_for_by_its_name(said, words):
    part = worn("upper", {"kind": ("top", 0.9), "sleeves": ("long", 0.9)} | said)
    assert in_words(replace(part, called="Outwear")) == words
    assert not hear_description(words, WishReader.load()).unread


def test_a_jumpsuit_over_trousers_is_a_top():
    part = worn("upper", {"kind": ("jumpsuit", 0.9), "sleeves": ("long", 0.9), "leg_hem": ("full", 0.9)})
    assert in_words(part, over=True) == "top, long-sleeved"
    assert in_words(part).endswith("jumpsuit, long-sleeved")
