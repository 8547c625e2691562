"""What of a text no wish came from."""

from __future__ import annotations

import pytest

from swifttailor.describing import Claim
from swifttailor.describing.differences import Change, Gain, Step
from swifttailor.wishes.reader import SURE, WishReader
from swifttailor.wishes.text.unread import MOST_TESTED, not_understood, says_nothing_else


@pytest.fixture(scope="module")
def unread():
    reader = WishReader.load()

    def named(text: str, *, instruction: bool = True) -> tuple[str, ...]:
        def sure(text: str) -> set[Change]:
            return {w.change for w in reader.read(text, instruction=instruction) if w.certainty >= SURE}

        return not_understood(text, sure(text), sure)

    return named


@pytest.mark.parametrize(
    ("text", "named"),
    [
        ("make it red and of denim", ("red", "denim")),
        ("make it blue and 10 cm shorter with pockets", ("blue", "pockets")),
        ("make it wider and longer", ("wider",)),
        ("make it longer and give it puffins", ("puffins",)),
        ("make it twice as long", ("twice", "long")),
        ("make it 20 percent longer", ("20 percent longer",)),
        ("Gib ihm lange Ärmel", ("Gib ihm lange Ärmel",)),
        ("make it longer, 长裙", ("长裙",)),
        ("make it longer and longer and RED and red", ("RED", "red")),
    ],
)
def test_words_that_asked_for_nothing_are_named(unread, text, named):
    assert unread(text) == named


@pytest.mark.parametrize(
    "text",
    [
        "give it long sleeves and make it 20 cm longer",
        "Could you please lengthen the dress by 20 cm?",
        "make it shorter but keep the sleeves",
        "don't change the length but give it a V neck",
        "make it 5 cm wider at the chest and 10 cm longer",
        "make it knee length",
        "",
    ],
)
def test_what_was_understood_is_not_named(unread, text):
    assert unread(text) == ()


def test_known_words_alone_leave_no_doubt():
    knee, v_neck = Gain(Claim("skirt_hem", "knee")), Gain(Claim("neckline", "v"))
    assert says_nothing_else("please make the dress knee-length", {knee})
    assert says_nothing_else("V neck, knee-length", {knee, v_neck})
    assert not says_nothing_else("V neck, knee-length", {knee})
    assert not says_nothing_else("make it cheaper", {Gain(Claim("fit", "close"))})
    assert not says_nothing_else("make it 90 cm knee-length", {knee})


def test_of_a_description_too(unread):
    assert unread("a red knee-length dress with pockets", instruction=False) == ("red", "pockets")
    assert unread("an elegant maxi dress", instruction=False) == ("elegant",)


def test_a_number_in_no_wish_is_named():
    longer, text = Step("length", 1), "make it 20 cm longer"
    assert not_understood(text, {longer}, lambda _: {longer}) == ("20 cm",)
    by_20 = Step("length", 1, 20.0)
    assert not_understood(text, {by_20}, lambda _: {by_20}) == ()
    assert (
        not_understood("one dress of 3/4 sleeves", {Gain(Claim("sleeves", "three-quarter"))}, lambda _: ())
        == ()
    )


def test_a_word_without_which_less_is_read_was_understood():
    hood = Gain(Claim("hood", "hood"))
    assert not_understood("with a cowl", {hood}, lambda text: {hood} if "cowl" in text else set()) == ()
    assert not_understood("with a cowl", {hood}, lambda text: {hood}) == ("cowl",)


def test_a_long_text_is_looked_into_to_a_limit():
    read: list[str] = []
    text = " ".join(f"{'abcdefghij'[k % 10]}{'klmnopqrst'[k // 10 % 10]}x" for k in range(100)) * 50
    named = not_understood(text, set(), lambda other: read.append(other) or set())
    assert len(read) == MOST_TESTED and named
