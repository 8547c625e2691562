"""Tops to the knee and below, which are dresses and coats; what only goes with something that is so long."""

from __future__ import annotations

import pytest

from swifttailor.wishes.descriptions.hearing import hear_description
from swifttailor.wishes.reader import WishReader
from swifttailor.wording.lexicon import read_words


@pytest.fixture(scope="module")
def reader() -> WishReader:
    return WishReader.load()


@pytest.mark.parametrize(
    ("text", "hem", "draft"),
    [
        ("a soldier tunic, red, knee length, short sleeves", "knee", "t-shirt"),
        ("a kurta to the knee", "knee", "shift-dress"),
        ("a cardigan to the knee", "knee", "cardigan"),
        ("a longline waistcoat, to the knee", "knee", "waistcoat"),
        ("a linen shirt to the knee", "knee", "shirt"),
        ("a tunic to mid calf", "midi", "t-shirt"),
        ("a jumper down to the knees", "knee", "sweatshirt"),
        ("an oversized tee to mid thigh", "mini", "t-shirt"),
        ("a shirt to mid-thigh", "mini", "shirt"),
    ],
)
def test_a_top_to_the_knee_is_cut_as_a_dress(reader, text, hem, draft):
    heard = hear_description(text, reader)
    sure = {(w.change.claim.name, w.change.claim.value) for w in heard.sure}
    assert {("kind", "dress"), ("skirt_hem", hem)} <= sure
    assert not {("kind", "top"), ("kind", "tunic")} & sure
    begun = heard.drafts[0]
    assert begun.name == draft and dict(begun.options)["length"] >= 40.0


@pytest.mark.parametrize(
    "text",
    [
        "a top with boots to the knee",
        "a blouse to go with a knee-length skirt",
        "a tunic with full-length sleeves",
        "a jumper, hip length",
        "a tunic falling to the upper thigh",
    ],
)
def test_other_tops_stay_tops(text):
    kinds = {str(i.claim.value) for i in read_words(text).implications if i.claim.name == "kind"}
    assert kinds <= {"top", "tunic"}
