"""What is heard word by word and as a whole, together."""

from __future__ import annotations

import pytest

import swifttailor
from swifttailor.describing import Claim
from swifttailor.describing.differences import Gain, Step
from swifttailor.describing.measuring import measure_facts
from swifttailor.wishes.instructions.hearing_changes import hear_instruction
from swifttailor.wishes.instructions.whole_instruction import (
    AT_ODDS,
    DOUBTED,
    GUESS,
    KNOWN,
    MEANT,
    MEANT_BESIDE,
    is_disputed,
    uncertain,
    with_the_whole,
)
from swifttailor.wishes.labels import change_of, statement_labels
from swifttailor.wishes.reader import Wish, WishReader

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
    sure = {SHORTER: 1.0, HOOD: AT_ODDS}
    assert together([HOOD], sure, left_over=False)[0] == [HOOD, SHORTER], "words stand"
    assert together([HOOD], sure)[0] == [SHORTER], "where words are left over they do not"


def test_what_is_all_but_excluded_gives_way_to_what_is_read():
    assert together([HOOD], {V_NECK: 0.8, HOOD: DOUBTED / 2}) == ([V_NECK], [V_NECK])
    assert together([HOOD], {V_NECK: 0.3, HOOD: DOUBTED / 2}) == ([HOOD], []), "nothing else was read"
    amount = Step("length", -1, 2.54)
    assert together([amount], {V_NECK: 0.8, SHORTER: 0.0})[0] == [V_NECK]
    assert together([amount], {V_NECK: 0.8, SHORTER: 0.9})[0] == [amount, V_NECK]


def test_what_is_at_odds_with_all_that_is_read_counts_like_a_word_left_over():
    odd = AT_ODDS - 0.01
    assert together([HOOD], {V_NECK: MEANT, HOOD: odd}, left_over=False) == ([V_NECK], [V_NECK])
    assert together([HOOD], {V_NECK: MEANT - 0.01, HOOD: odd}, left_over=False) == ([HOOD], [])
    assert together([HOOD], {V_NECK: MEANT, HOOD: odd}, left_over=False, firm=[HOOD])[0] == [HOOD], (
        "it is said"
    )


def test_slits_of_both_sides_go_together_and_necklines_do_not():
    left, right = Gain(Claim("slit", "left")), Gain(Claim("slit", "right"))
    assert together([left], {right: 0.9, left: 0.9})[0] == [left, right]
    assert together([SQUARE], {V_NECK: 0.9, SQUARE: 0.9})[0] == [SQUARE]
    puffed, tapered, slim = (Gain(Claim("sleeve_shape", v)) for v in ("puffed", "tapered", "slim"))
    assert together([], {puffed: 0.9, tapered: 0.8})[0] == [puffed, tapered]
    assert together([puffed], {slim: 0.9, puffed: 0.9})[0] == [puffed], "no sleeve is both"


def test_what_says_why_is_not_asked_for():
    extra_long, less = Gain(Claim("sleeves", "extra-long")), Step("sleeve length", -1)
    assert together([], {extra_long: 0.9, less: 0.6})[0] == [less]
    assert together([], {extra_long: 0.9, less: MEANT - 0.01})[0] == [extra_long]
    assert together([], {extra_long: 0.9, Step("sleeve length", 1): 0.6})[0][0] == extra_long


def test_readers_that_disagree_are_said_to_be_unsure():
    def doubts(heard, whole, read=(), accepts=lambda change, told: True, firm=()):
        return uncertain([Wish(c, 0.97) for c in heard], read, whole, accepts, firm)

    assert doubts([HOOD], {HOOD: AT_ODDS - 0.01}) == ((HOOD,), ())
    assert doubts([HOOD], {HOOD: AT_ODDS}) == ((), ())
    assert doubts([HOOD], {HOOD: 0.0}, firm=[HOOD]) == ((), ())
    assert doubts([HOOD], {HOOD: 0.9, SHORTER: MEANT}) == ((), (SHORTER,))
    assert doubts([HOOD], {HOOD: 0.9, NO_HOOD: MEANT}) == ((), ()), "the hood was spoken of"
    assert doubts([HOOD], {HOOD: 0.9, SHORTER: 1.0}, accepts=lambda change, told: False) == ((), ())
    guessed, known = Wish(SHORTER, KNOWN - 0.01), Wish(SHORTER, KNOWN)
    assert doubts([SHORTER], {SHORTER: guessed.certainty}, [guessed]) == ((SHORTER,), ())
    assert doubts([SHORTER], {SHORTER: known.certainty}, [known]) == ((), ())


def test_nobody_decides_for_a_text_that_asks_for_opposites():
    longer, hem = Step("length", 1), Gain(Claim("skirt_hem", "floor"))
    disputed, sure = {"length"}, {longer: 0.95, SHORTER: 0.1, hem: 0.95}
    assert is_disputed(longer, disputed, sure, 3)
    assert is_disputed(hem, disputed, sure, 3), "the hem is where it is longer"
    assert not is_disputed(V_NECK, disputed, sure | {V_NECK: 0.1}, 3)
    assert not is_disputed(longer, disputed, sure, 20), "in many words the opposite is why"
    assert is_disputed(longer, disputed, sure | {SHORTER: 0.9}, 20)
    assert is_disputed(longer, disputed, {longer: 0.6}, 20)


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


@pytest.mark.parametrize(
    "text", ["longer and shorter", "shorter sleeves, and longer sleeves", "tight but very loose"]
)
def test_of_a_contradiction_nothing_is_done(text):
    heard = hear_instruction(text, WishReader.load(), measure_facts(swifttailor.draft("shirt-dress")))
    assert heard.clashes and not heard.sure


def test_what_is_unsure_stands_beside_what_was_heard(shirt):
    told = {Step("length", 1): 0.55, Step("chest", -1): 0.2}
    heard = hear_instruction("the bottom edge, hmm", Reads(WishReader.load(), told), shirt)
    assert heard.unsure == (Step("length", 1),)
    heard = hear_instruction("my belly greets the postman", Reads(WishReader.load(), told), shirt)
    assert not heard.sure and heard.perhaps == (Step("length", 1),), "no word names what it would change"
    known = {Step("length", 1): KNOWN, Step("chest", -1): 0.2}
    heard = hear_instruction("my belly greets the postman", Reads(WishReader.load(), known), shirt)
    assert [w.change for w in heard.sure] == [Step("length", 1)]
    bare = Gain(Claim("sleeves", "none"))
    heard = hear_instruction(
        "no sleeves", Reads(WishReader.load(), {Step("neck depth", 1): 0.8, bare: 0.9}), shirt
    )
    assert heard.perhaps == (Step("neck depth", 1),)
    assert [w.change for w in heard.sure] == [bare] and not heard.unsure


def test_of_a_letter_what_is_plain_is_let_go_less_easily():
    whole = {SHORTER: 0.8, HOOD: (AT_ODDS + DOUBTED) / 2}
    assert together([HOOD], whole)[0] == [SHORTER]
    assert together([HOOD], whole, clear=[HOOD])[0] == [HOOD, SHORTER]


def test_no_reading_makes_another_garment_of_a_dress():
    told = {Gain(Claim("top_hem", "hip")): 0.95, Gain(Claim("leg_cuffs", "gathered")): 0.95}
    dress = measure_facts(swifttailor.draft("shirt-dress"))
    assert not hear_instruction("lovely on the hips", Reads(WishReader.load(), told), dress).sure
