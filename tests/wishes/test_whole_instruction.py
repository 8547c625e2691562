"""What is heard word by word and as a whole, together."""

from __future__ import annotations

import pytest

import swifttailor
from swifttailor.describing import Claim
from swifttailor.describing.differences import Gain, Step
from swifttailor.describing.measuring import measure_facts
from swifttailor.wishes.hearing_changes import hear_instruction
from swifttailor.wishes.labels import change_of, statement_labels
from swifttailor.wishes.reader import Wish, WishReader
from swifttailor.wishes.whole_instruction import (
    DOUBTED,
    DOUBTED_BESIDE,
    GUESS,
    MEANT,
    MEANT_BESIDE,
    with_the_whole,
)

SHORTER, HOOD, NO_HOOD = Step("length", -1), Gain(Claim("hood", "hood")), Gain(Claim("hood", "none"))
V_NECK, SQUARE = Gain(Claim("neckline", "v")), Gain(Claim("neckline", "square"))


def together(heard, whole, *, left_over=True, accepts=lambda change, told: True, **more):
    sure = [Wish(change, 0.99) for change in heard]
    kept, found = with_the_whole(sure, whole, left_over=left_over, accepts=accepts, **more)
    return [w.change for w in kept], [w.change for w in found]


def test_what_words_miss_the_whole_says():
    assert together([HOOD], {SHORTER: MEANT, HOOD: 0.9}) == ([HOOD, SHORTER], [SHORTER])
    assert together([HOOD], {SHORTER: MEANT - 0.01, HOOD: 0.9}) == ([HOOD], [])


def test_where_all_words_are_accounted_for_more_is_needed():
    assert together([HOOD], {SHORTER: MEANT_BESIDE - 0.01, HOOD: 1.0}, left_over=False) == ([HOOD], [])
    assert together([HOOD], {SHORTER: MEANT_BESIDE, HOOD: 1.0}, left_over=False)[1] == [SHORTER]
    sure = {SHORTER: 1.0, HOOD: DOUBTED_BESIDE}
    assert together([HOOD], sure, left_over=False)[0] == [HOOD, SHORTER], "words stand"
    assert together([HOOD], sure)[0] == [SHORTER], "where words are left over they do not"


def test_what_is_all_but_excluded_gives_way_to_what_is_read():
    assert together([HOOD], {V_NECK: 0.8, HOOD: DOUBTED / 2}) == ([V_NECK], [V_NECK])
    assert together([HOOD], {V_NECK: 0.3, HOOD: DOUBTED / 2}) == ([HOOD], []), "nothing else was read"
    amount = Step("length", -1, 2.54)
    assert together([amount], {V_NECK: 0.8, SHORTER: 0.0})[0] == [V_NECK]
    assert together([amount], {V_NECK: 0.8, SHORTER: 0.9})[0] == [amount, V_NECK]


def test_where_nothing_is_heard_the_likeliest_is_a_guess():
    assert together([], {SHORTER: GUESS, V_NECK: GUESS - 0.01}) == ([SHORTER], [SHORTER])
    assert together([], {SHORTER: GUESS - 0.01, V_NECK: 0.1}) == ([], [])
    assert together([HOOD], {SHORTER: GUESS, HOOD: 0.0}) == ([HOOD], []), "something was heard"
    assert together([], {}) == ([], [])


def test_of_what_excludes_each_other_the_first_and_likeliest_stays():
    assert together([SQUARE], {V_NECK: 0.9, SQUARE: 0.5})[1] == []
    assert together([], {V_NECK: 0.7, SQUARE: 0.9, NO_HOOD: 0.6, HOOD: 0.55})[1] == [SQUARE, NO_HOOD]


def test_what_may_not_be_is_not_read():
    refuses = {"accepts": lambda change, told: False}
    assert together([HOOD], {SHORTER: 1.0}, **refuses)[0] == [HOOD]
    assert together([HOOD], {SHORTER: 1.0, HOOD: 0.0}, **refuses)[0] == [HOOD], "nothing is read in its place"
    refuses["holds"] = lambda change: change == SHORTER
    assert together([HOOD], {SHORTER: 1.0, HOOD: 0.0}, **refuses)[0] == [], "it is short already"
    seen = []
    together([HOOD], {SHORTER: 1.0}, accepts=lambda change, told: bool(seen.append((change, list(told)))))
    assert seen == [(SHORTER, [HOOD])]


class Reads:
    """The network of the package, but what a whole instruction means is given."""

    def __init__(self, reader, whole):
        self.reader, self.told = reader, whole

    def __getattr__(self, name):
        return getattr(self.reader, name)

    def whole(self, text, *, instruction=True):
        return dict.fromkeys(map(change_of, statement_labels()), 0.01) | self.told


@pytest.fixture(scope="module")
def shirt():
    return measure_facts(swifttailor.draft("t-shirt"))


def test_it_is_told_what_an_instruction_is_taken_to_mean(shirt):
    text = "my belly greets the postman"
    heard = hear_instruction(text, Reads(WishReader.load(), {Step("length", 1): 0.8}), shirt)
    assert Step("length", 1) in [w.change for w in heard.sure]
    assert (text, (Step("length", 1),)) in heard.taken


def test_what_is_so_already_or_is_not_there_is_not_read(shirt):
    told = {Gain(Claim("kind", "top")): 0.9, Gain(Claim("hood", "none")): 0.9, Step("hood depth", -1): 0.9}
    heard = hear_instruction("glorps the frump", Reads(WishReader.load(), told), shirt)
    assert not heard.sure and not heard.taken
