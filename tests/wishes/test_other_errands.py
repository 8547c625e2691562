"""Texts that ask for no clothes for people."""

from __future__ import annotations

import pytest

from swifttailor.describing.claims import Claim
from swifttailor.describing.differences import Gain
from swifttailor.wishes.descriptions.no_garment import asks_for_none
from swifttailor.wishes.heard import Heard
from swifttailor.wishes.reader import Wish
from swifttailor.wording import read_words


def refused(text: str, sure: tuple[Wish, ...] = ()) -> str:
    words = read_words(text)
    return asks_for_none(Heard(text, sure, lacks=tuple(words.lacks), words=words), text)


@pytest.mark.parametrize(
    "text",
    [
        "a dog coat for my dachshund",
        "jumper for my cat",
        "a rain jacket for our old greyhound, in red",
        "dress for my daughter's doll",
        "ein Mantel für meinen Hund",
        "un manteau pour mon chien",
    ],
)
def test_animals_and_dolls_are_dressed_by_others(text):
    assert "animal or a doll" in refused(text)


@pytest.mark.parametrize(
    "text",
    [
        "can i get a refund on order 4471",
        "I want a refund for my dress",
        "can i return these trousers",
        "write me a poem about autumn",
        "tell me a joke",
        "who won the football",
        "a necklace with a silver heart",
        "a bracelet with my name on it",
    ],
)
def test_services_talk_and_jewellery_are_no_garments(text):
    assert "No garment is asked for" in refused(text)


@pytest.mark.parametrize(
    "text",
    [
        "a dress with a dog print",
        "a coat I can wear to walk the dog",
        "dog walking coat",
        "a hat for the horse race and a dress",
        "a dress to go with my pearl necklace",
        "pussy bow blouse",
        "a puppy print pyjama top",
        "donkey jacket",
        "a corgi jumper with hearts",
        "where is my little black dress, make one",
        "a waterproof coat for walking the dog",
        "breeches for riding my horse, in brown",
        "a long dress for the horse and carriage",
        "cat pyjamas",
        "a skirt like the one I had to send back because it was far too short, so longer, to the knee, in "
        "navy wool, with pockets, please",
    ],
)
def test_clothes_for_people_are_made(text):
    assert not refused(text)


GUESSED = (Wish(Gain(Claim("kind", "top")), 0.97),)
"""What a network says of anything."""


@pytest.mark.parametrize("text", ["a chair", "a table", "house"])
def test_words_that_people_only_tell_stories_with_ask_for_nothing(text):
    assert "No garment is asked for" in refused(text, GUESSED)


@pytest.mark.parametrize("text", ["something nice to wear", "a dress", "a dress to wear in the office chair"])
def test_beside_a_garment_they_ask_for_it(text):
    assert refused(text, GUESSED) == ""
