"""What instructions ask for by their words alone."""

from __future__ import annotations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from swifttailor.describing.claims import Claim
from swifttailor.describing.differences import Gain, Step
from swifttailor.wishes.change_parts import PARTS, changes_of
from swifttailor.wishes.change_words import find_changes, find_parts
from swifttailor.wishes.spoken_changes import spoken_changes
from swifttailor.wishes.spoken_clauses import other_than
from swifttailor.wording.lexicon import read_words


def heard(text, kind="dress", is_so=lambda claim: False):
    return spoken_changes(text, read_words(text, kind=kind), kind, is_so)


def gain(name, value):
    return Gain(Claim(name, value))


@pytest.mark.parametrize(
    ("text", "kind", "changes"),
    [
        ("longer", "trousers", [Step("leg length", 1)]),
        ("tighter", "dress", [Step("chest", -1)]),
        ("narrower", "skirt", [Step("skirt hem", -1)]),
        ("too tight round the bust", "top", [Step("chest", 1, 6.0)]),
        ("lower the hem by 4 cm", "skirt", [Step("length", 1, 4.0)]),
        ("hem up", "dress", [Step("length", -1)]),
        ("take 6 cm off the chest", "top", [Step("chest", -1, 6.0)]),
        ("the neckline a bit higher", "top", [Step("neck depth", -1)]),
        ("less flare", "skirt", [Step("skirt hem", -1)]),
        ("etwas kürzer", "dress", [Step("length", -1)]),
        ("weitere Hosenbeine", "trousers", [Step("leg end", 1)]),
        ("más corto", "dress", [Step("length", -1)]),
        ("bigger sleeves", "dress", [Step("sleeve width", 1)]),
        ("widen both sleeves towards the hand", "dress", [Step("sleeve end", 1)]),
        ("take a tier off", "skirt", [Step("tiers", -1, 1.0)]),
        ("lose the sleeves", "dress", [gain("sleeves", "none")]),
        ("make these into shorts", "trousers", [gain("kind", "shorts")]),
        ("dress -> top", "dress", [gain("kind", "top")]),
        ("close slit", "skirt", [gain("slit", "none")]),
        ("put a slit up the side", "skirt", [gain("slit", "left")]),
        ("hem longer behind", "skirt", [gain("hem_shape", "high-low")]),
    ],
)
def test_an_instruction_in_people_s_words_asks_for(text, kind, changes):
    assert list(heard(text, kind).changes) == changes


def test_each_clause_has_its_own_part_and_number():
    said = heard("sleeves 4 cm shorter, hem 10 cm longer and a square neck").changes
    assert said == (Step("sleeve length", -1, 4.0), Step("length", 1, 10.0), gain("neckline", "square"))
    said = heard("make the sleeves a bit shorter, like 4 cm", "top").changes
    assert said == (Step("sleeve length", -1, 4.0),)


def test_what_is_to_stay_is_kept_and_asks_for_nothing():
    said = heard("keep the hood, lose the sleeves", "top")
    assert said.changes == (gain("sleeves", "none"),)
    assert "hood" in said.kept


def test_opposite_wishes_are_named_and_nothing_is_done_of_them():
    for text in ("longer and shorter", "take the sleeves off and make them longer"):
        said = heard(text)
        assert said.changes == () and said.clashes, text


def test_the_garment_that_is_there_is_not_asked_for():
    assert heard("make the dress longer").changes == (Step("length", 1),)
    square = Claim("neckline", "square")
    said = heard("the neckline is square, I'd have it boat-shaped", is_so=lambda claim: claim == square)
    assert gain("neckline", "boat") in said.changes and Gain(square) not in said.changes


def test_words_that_nothing_accounts_for_are_named():
    (clause,) = heard("make it more wuzzly").clauses
    assert "wuzzly" in " ".join(clause.left_over)
    assert all(not clause.left_over for clause in heard("shorter, please").clauses)


def test_instead_of_what_is_refused_something_is_made():
    balloon = Claim("sleeve_shape", "balloon")
    assert other_than([balloon], [balloon], []) == (gain("sleeve_shape", "slim"),)
    assert other_than([balloon], [], []) == () == other_than([balloon], [balloon], ["sleeve_shape"])


@pytest.mark.parametrize("part", [None, *sorted(PARTS)])
@pytest.mark.parametrize("what", ["length", "width", "height"])
def test_every_part_asks_for_opposite_things_in_both_directions(part, what):
    for kind in ("dress", "top", "skirt", "trousers", "jumpsuit"):
        more, less = (changes_of(part, what, sign, kind, 3.0) for sign in (1, -1))
        assert len(more) == len(less)
        for one, other in zip(more, less, strict=True):
            assert isinstance(one, Step) and isinstance(other, Step)
            assert (one.quantity, one.amount) == (other.quantity, 3.0) and one.direction == -other.direction


@settings(max_examples=150, deadline=None)
@given(st.text(max_size=120))
def test_any_text_can_be_read_and_places_lie_in_it(text):
    small = text.lower()
    for word in (*find_changes(small), *find_parts(small)):
        assert 0 <= word.start < word.end <= len(small)
    for clause in heard(text).clauses:
        assert 0 <= clause.start <= clause.end <= len(text) + 8
