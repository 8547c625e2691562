"""Which way instructions say that something is to change, what they describe, and what goes together."""

from __future__ import annotations

import pytest

import swifttailor
from swifttailor.describing.claims import Claim
from swifttailor.describing.differences import Gain, Step
from swifttailor.describing.measuring import measure_facts
from swifttailor.wishes.instructions.described import with_their_names, without_described
from swifttailor.wishes.instructions.hearing_changes import hear_instruction
from swifttailor.wishes.instructions.shared_removals import parted
from swifttailor.wishes.reader import WishReader
from swifttailor.wording.lexicon import read_words

DRAFTS = ("t-shirt", "shirt-dress", "skater-dress", "trousers", "hoodie", "fitted-skirt", "strappy-dress")


@pytest.fixture(scope="module")
def facts():
    return {name: measure_facts(swifttailor.draft(name)) for name in DRAFTS}


@pytest.fixture(scope="module")
def reader():
    return WishReader.load()


def gain(name, value):
    return Gain(Claim(name, value))


@pytest.mark.parametrize(
    ("text", "garment", "changes"),
    [
        # Which way
        ("make the sleeves more fitted", "t-shirt", {Step("sleeve width", -1)}),
        ("less tight sleeves", "t-shirt", {Step("sleeve width", 1)}),
        ("way too loose sleeves", "t-shirt", {Step("sleeve width", -1)}),
        ("the sleeves aren't long enough", "t-shirt", {Step("sleeve length", 1)}),
        ("I don't like how long the sleeves are", "t-shirt", {Step("sleeve length", -1)}),
        ("can the neckline be less shallow", "t-shirt", {Step("neck depth", 1)}),
        ("less short", "trousers", {Step("leg length", 1)}),
        ("the legs are too big", "trousers", {Step("leg end", -1)}),
        ("a more fitted hem", "skater-dress", {Step("skirt hem", -1)}),
        ("i hate that the hood is so big", "hoodie", {Step("hood depth", -1)}),
        # Of which part
        ("the hood 3 cm deeper", "hoodie", {Step("hood depth", 1, 3.0)}),
        ("not so skinny round the calf", "trousers", {Step("leg end", 1)}),
        ("it's too low in front", "skater-dress", {Step("neck depth", -1)}),
        ("lower in the back", "skater-dress", {Step("back depth", 1)}),
        ("longer in the back", "skater-dress", {gain("hem_shape", "high-low")}),
        ("longer straps", "strappy-dress", set()),
        ("a slit at the ankle on both sides", "trousers", set()),
        ("make it a different colour", "skater-dress", set()),
        ("zip up the back", "shirt-dress", set()),
        # What is there, and what is to take its place
        ("make the short sleeves long", "t-shirt", {gain("sleeves", "long")}),
        ("long ones instead of the short sleeves", "t-shirt", {gain("sleeves", "long")}),
        ("make the crew neck a v neck", "t-shirt", {gain("neckline", "v")}),
        ("same thing with a hood", "t-shirt", {gain("hood", "hood")}),
        ("drop the collar", "shirt-dress", {gain("collar", "none")}),
        ("instead of the skirt I want trousers", "skater-dress", {gain("kind", "jumpsuit")}),
        ("make them shorts", "trousers", {gain("leg_hem", "mid-thigh")}),
        # Several things
        ("remove the collar and the cuffs", "shirt-dress", {gain("collar", "none"), gain("cuffs", "none")}),
        ("longer sleeves, these aren't long enough", "t-shirt", {Step("sleeve length", 1)}),
        ("tighter at the chest and a v neck", "shirt-dress", {Step("chest", -1), gain("neckline", "v")}),
        ("longer, looser", "t-shirt", {Step("length", 1), Step("chest", 1)}),
        (
            "looser sleeves, and take 5 cm off the hem",
            "shirt-dress",
            {Step("sleeve width", 1), Step("length", -1, 5.0)},
        ),
        ("v neck & add a hood", "t-shirt", {gain("neckline", "v"), gain("hood", "hood")}),
        ("longer sleeves\nlower the neckline", "t-shirt", {Step("sleeve length", 1), Step("neck depth", 1)}),
        ("it's long enough but too wide", "t-shirt", {Step("chest", -1, 6.0)}),
        ("shorten everything but the sleeves", "shirt-dress", {Step("length", -1)}),
    ],
)  # fmt: skip
def test_an_instruction_asks_for_no_more_than_it_says(text, garment, changes, facts, reader):
    heard = hear_instruction(text, reader, facts[garment])
    assert {wish.change for wish in heard.sure} == changes


def test_what_cannot_be_had_is_told(facts, reader):
    slits = hear_instruction("a slit at the ankle on both sides", reader, facts["trousers"])
    assert "slit (not of trousers)" in slits.unread
    straps = hear_instruction("longer straps", reader, facts["strappy-dress"])
    assert any("longer" in words for words in straps.unread)


def test_sleeves_that_are_elbow_length_at_their_border_are_lengthened(facts, reader):
    heard = hear_instruction("a bit longer sleeves, to the elbow", reader, facts["t-shirt"])
    (step,) = [w.change for w in heard.sure if isinstance(w.change, Step)]
    assert step.quantity == "sleeve length" and step.direction == 1 and step.amount > 4.0


@pytest.mark.parametrize(
    ("text", "so", "left"),
    [
        ("make the long sleeves short", ("sleeves", "long"), "make the sleeves short"),
        ("the v neck could be square", ("neckline", "v"), "the neck could be square"),
        ("shorten the long sleeves", ("sleeves", "long"), "shorten the long sleeves"),
        ("make the long sleeves short", ("sleeves", "short"), "make the long sleeves short"),
    ],
)
def test_what_is_there_is_not_asked_for(text, so, left):
    words = read_words(text, kind="dress")
    assert " ".join(without_described(text, words, lambda c: c == Claim(*so)).split()) == left


def test_ones_are_the_part_that_is_named():
    assert with_their_names("swap the sleeves for short ones") == "swap the sleeves for short sleeves"
    assert with_their_names("wide ones eat me, a narrow waistband") == "wide ones eat me, a narrow waistband"


@pytest.mark.parametrize(
    ("text", "plain"),
    [
        ("no collar or cuffs", "no collar and no cuffs"),
        ("remove the hood and the cuffs", "remove the hood and remove the cuffs"),
        ("remove the hood and the cuffs wider", "remove the hood and the cuffs wider"),
        ("no collar and a hood", "no collar and a hood"),
    ],
)
def test_parts_that_go_together_are_each_removed(text, plain):
    assert parted(text) == plain == parted(plain)
