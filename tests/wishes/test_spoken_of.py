"""What an instruction names, and what a network may guess beside it."""

from __future__ import annotations

import pytest

import swifttailor
from swifttailor.describing import Claim
from swifttailor.describing.differences import Gain, Step, subject_of
from swifttailor.describing.dimensions import QUANTITIES
from swifttailor.describing.measuring import measure_facts
from swifttailor.wishes.instructions.hearing_changes import hear_instruction
from swifttailor.wishes.instructions.spoken_of import (
    NEVER,
    UNNAMED,
    is_lacking,
    is_of_places,
    parts_spoken_of,
)
from swifttailor.wishes.instructions.whole_instruction import AT_ODDS, without_guesses
from swifttailor.wishes.reader import Wish, WishReader

LONGER_SLEEVES, LONGER = Step("sleeve length", 1), Step("length", 1)


@pytest.fixture(scope="module")
def reader() -> WishReader:
    return WishReader.load()


@pytest.fixture(scope="module")
def dress():
    return measure_facts(swifttailor.draft("shirt-dress"))


@pytest.fixture(scope="module")
def trousers():
    return measure_facts(swifttailor.draft("trousers"))


def heard(text, reader, facts):
    return hear_instruction(text, reader, facts)


def asked(text, reader, facts):
    return [wish.change for wish in heard(text, reader, facts).sure]


def test_less_is_enough_where_the_part_is_named():
    named = parts_spoken_of("the sleeves are annoying", "dress")
    assert named.speaks_of(LONGER_SLEEVES) and named.least(LONGER_SLEEVES) == 0.0
    assert not named.speaks_of(LONGER) and named.least(LONGER) == UNNAMED
    assert parts_spoken_of("make it cuter", "dress").least(LONGER) == UNNAMED
    assert parts_spoken_of("the sleeves", "trousers").least(LONGER) == NEVER > 1.0


@pytest.mark.parametrize(
    ("part", "kind", "lacks"),
    [
        ("sleeves", "trousers", True),
        ("collar", "skirt", True),
        ("hood", "shorts", True),
        ("skirt", "trousers", True),
        ("sleeves", "top", False),
        ("skirt", "dress", False),
        ("legs", "dress", False),  # a dress may show more leg
        ("waist", "trousers", False),
        (None, "dress", False),
    ],
)
def test_parts_that_a_garment_lacks(part, kind, lacks):
    assert is_lacking(part, kind) is lacks


def test_what_tells_left_from_right():
    for name, value in (
        ("hem_shape", "lower left"),
        ("shoulders", "bare right"),
        ("sleeves", "left only"),
        ("left_sleeve", "short"),
    ):
        assert is_of_places(Gain(Claim(name, value)))
    assert not is_of_places(Gain(Claim("sleeves", "short"))) and not is_of_places(LONGER)


def test_what_one_network_guesses_and_the_other_excludes_is_set_apart():
    guess, word = Wish(LONGER, 0.97), Wish(LONGER_SLEEVES, 0.97)
    whole = {LONGER: AT_ODDS - 0.01, LONGER_SLEEVES: AT_ODDS - 0.01}
    assert without_guesses([guess, word], whole, lambda c: c == LONGER_SLEEVES) == ([word], [guess])
    assert without_guesses([guess], {LONGER: AT_ODDS}, lambda c: False) == ([guess], [])
    assert without_guesses([guess], {}, lambda c: False) == ([guess], []), "nobody doubts it"


@pytest.mark.parametrize("text", ["raglan", "bustle", "panniers please", "give it more zing"])
def test_names_that_ask_for_nothing_here_change_nothing(text, reader, dress):
    found = heard(text, reader, dress)
    assert not found.sure
    assert found.unread or found.perhaps or found.cannot, "and it is said"


@pytest.mark.parametrize("text", ["make the sleeves longer", "wider sleeves", "a bigger collar"])
def test_parts_that_are_not_there_move_no_others(text, reader, trousers):
    subjects = {subject_of(change) for change in asked(text, reader, trousers)}
    assert not subjects & {"leg length", "leg end", "thigh", "legs", "leg_hem", "rise"}


@pytest.mark.parametrize("text", ["make the left leg shorter", "one leg longer than the other please"])
def test_one_leg_alone_is_not_cut(text, reader, trousers):
    found = heard(text, reader, trousers)
    assert not found.sure
    assert any("alike" in word for word in found.unread)


@pytest.mark.parametrize(
    ("text", "change"),
    [
        ("hem higher on the left", Gain(Claim("hem_shape", "lower right"))),
        ("the hem longer on the left side", Gain(Claim("hem_shape", "lower left"))),
        ("the left sleeve torn off", Gain(Claim("sleeves", "right only"))),
        ("right sleeve missing", Gain(Claim("sleeves", "left only"))),
        ("add 12 cm to the hem circumference", Step("skirt hem", 1, 12.0)),
        ("take 8 cm out of the width of the hem", Step("skirt hem", -1, 8.0)),
        ("give it a huge slit", Gain(Claim("slit", "left"))),
        ("gathers instead of the darts", Gain(Claim("bodice", "gathered"))),
        ("it pulls across the bust", Step("chest", 1)),
    ],
)
def test_grammar_stands_against_a_network(text, change, reader, dress):
    told = asked(text, reader, dress)
    if isinstance(change, Step):
        like = [c for c in told if isinstance(c, Step) and c.quantity == change.quantity]
        assert [(c.direction, c.amount if change.amount else None) for c in like] == [
            (change.direction, change.amount)
        ]
    else:
        assert change in told
    assert not any(subject_of(c) == "fit" for c in told)


def test_the_size_of_a_small_part_is_not_that_of_the_garment(reader, dress):
    for text in ("a big hood", "a gigantic collar", "huge cuffs"):
        found = heard(text, reader, dress)
        assert not any(subject_of(w.change) in ("fit", "chest") for w in found.sure)
        assert any(word in found.unread for word in text.split()), "what the word says is not done"


@pytest.fixture(scope="module")
def skirt():
    return measure_facts(swifttailor.draft("gored-skirt"))


@pytest.fixture(scope="module")
def top():
    return measure_facts(swifttailor.draft("t-shirt"))


def test_what_a_text_says_first_of_all_is_no_guess(reader, top):
    assert Step("chest", 1) in asked("way baggier like i stole it from my brother", reader, top)


def test_a_length_named_after_a_garment_asks_for_no_such_garment(reader, top):
    assert asked("tunic length", reader, top) == [Gain(Claim("top_hem", "long"))]


def test_counted_pieces_are_halved(reader, skirt):
    found = asked("that is too many gores, halve them", reader, skirt)
    assert [c.amount for c in found if subject_of(c) == "gores"] == [3.0]


def test_where_a_hem_is_to_end_outweighs_a_small_step(reader, skirt):
    found = asked("too short, down to the floor", reader, skirt)
    assert Gain(Claim("skirt_hem", "floor")) in found
    assert not any(isinstance(c, Step) and c.amount for c in found)


@pytest.mark.parametrize(("text", "quantity"), [("thigh 60 cm", "thigh"), ("thigh 70 cm", "thigh")])
def test_a_part_and_a_number_say_where_it_is_to_end(reader, trousers, text, quantity):
    (step,) = asked(text, reader, trousers)
    was = QUANTITIES[quantity].of(trousers)
    assert was + step.direction * step.amount == pytest.approx(float(text.split()[1]), abs=0.1)


@pytest.mark.parametrize("text", ["armhole 24 cm", "knee width 40 cm"])
def test_a_number_of_a_part_is_no_length(reader, dress, text):
    assert not any(isinstance(c, Gain) for c in asked(text, reader, dress))


@pytest.mark.parametrize("text", ["tight and loose", "make it shorter and longer at the same time"])
def test_who_asks_for_opposites_gets_neither(reader, dress, text):
    assert not asked(text, reader, dress) and heard(text, reader, dress).clashes
