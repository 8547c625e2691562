"""What instructions ask for by their words alone."""

from __future__ import annotations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from swifttailor.describing.claims import Claim
from swifttailor.describing.differences import Gain, Step
from swifttailor.wishes.instructions.change_parts import PARTS, changes_of
from swifttailor.wishes.instructions.change_words import find_changes, find_parts
from swifttailor.wishes.instructions.spoken_amounts import by_a_bit
from swifttailor.wishes.instructions.spoken_changes import spoken_changes
from swifttailor.wishes.instructions.spoken_clauses import other_than
from swifttailor.wording.lexicon import read_words


def heard(text, kind="dress", is_so=lambda claim: False):
    return spoken_changes(text, read_words(text, kind=kind), kind, is_so)


def gain(name, value):
    return Gain(Claim(name, value))


@pytest.mark.parametrize(
    ("text", "kind", "changes"),
    [
        ("longer", "trousers", [Step("leg length", 1)]),
        ("slouchier", "jumpsuit", [Step("chest", 1)]),
        ("the waistband can be 3 cm taller", "trousers", [Step("waistband height", 1, 3.0)]),
        ("inseam +3, hem opening -2", "trousers", [Step("leg length", 1, 3.0), Step("leg end", -1, 2.0)]),
        ("hem sweep plus 10", "dress", [Step("skirt hem", 1, 10.0)]),
        ("make it a wrap", "dress", []),
        ("ein tieferer Ausschnitt vorne", "dress", [Step("neck depth", 1)]),
        ("mit engeren Ärmeln", "top", [Step("sleeve width", -1)]),
        ("etwas mehr Platz am Oberschenkel", "trousers", [Step("thigh", 1)]),
        ("zur Shorts kürzen", "trousers", [Step("leg length", -1), gain("kind", "shorts")]),
        ("the band is too wide; 3 cm would be plenty", "skirt", [gain("waistband_cm", 3.0)]),
        ("the waistband digs in", "trousers", [Step("waistband width", 1, 3.0)]),
        ("a wider waistband", "skirt", [Step("waistband height", 1)]),
        ("open the neck up a little", "dress", [Step("neck depth", 1)]),
        (
            "raise the hem 8, and let out the bust 6",
            "dress",
            [Step("length", -1, 8.0), Step("chest", 1, 6.0)],
        ),
        ("take the body in 2cm each side", "top", [Step("chest", -1, 4.0)]),
        ("the collar is too high, make it 4 cm", "top", [gain("collar_cm", 4.0)]),
        (
            "side vents, both sides, 12 cm",
            "skirt",
            [gain("slit", "left"), gain("slit", "right"), gain("slit_cm", 12.0)],
        ),
        ("flared from the knee like the trousers in that film", "trousers", [gain("legs", "flared")]),
        ("trousers under there instead of the skirt", "dress", [gain("kind", "jumpsuit")]),
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
        ("bring the waist in a touch", "dress", [Step("chest", -1, 6.0)]),
        ("let the bust out by 4cm", "dress", [Step("chest", 1, 4.0)]),
        ("take the hem up 3cm", "dress", [Step("length", -1, 3.0)]),
        ("put more cloth in the skirt", "skirt", [Step("skirt hem", 1)]),
        ("take the fullness out of the sleeve", "top", [Step("sleeve width", -1)]),
        ("reduce sweep", "dress", [Step("skirt hem", -1)]),
        ("raise the neckline an inch", "dress", [Step("neck depth", -1, 2.54)]),
        ("deeper V", "dress", [Step("neck depth", 1)]),
        ("widen the hems to 52 cm", "trousers", [gain("leg_width_cm", 52.0)]),
        ("sleeve +4", "top", [Step("sleeve length", 1, 4.0)]),
        ("trim 5cm off sleeves & hem", "top", [Step("sleeve length", -1, 5.0), Step("length", -1, 5.0)]),
        ("another tier", "skirt", [Step("tiers", 1, 1.0)]),
        ("one tier less", "skirt", [Step("tiers", -1, 1.0)]),
        ("two more gores", "skirt", [Step("gores", 1, 2.0)]),
        ("the tiers are too frilly", "skirt", [Step("tier gathers", -1)]),
        ("drop the waist seam to the hip", "dress", [gain("waist_seam", "dropped")]),
        ("raise the waist to under the bust", "dress", [gain("waist_seam", "empire")]),
        ("just the top half of this", "dress", [gain("kind", "top")]),
        ("I only want the skirt part", "dress", [gain("kind", "skirt")]),
        ("drop the right sleeve altogether", "top", [gain("sleeves", "left only")]),
        ("take the right shoulder off", "dress", [gain("shoulders", "bare right")]),
        ("a touch more room in the seat", "trousers", [Step("thigh", 1)]),
        ("nip the waist by three", "dress", [Step("chest", -1, 3.0)]),
        ("straighten the hem", "dress", [gain("hem_shape", "level")]),
        ("back neck down 8", "dress", [Step("back depth", 1, 8.0)]),
        ("take the legs in from the knee down", "trousers", [Step("leg end", -1)]),
        ("two slits at the sides", "skirt", [gain("slit", "left"), gain("slit", "right")]),
        ("split the hem front, about 30cm", "skirt", [gain("slit", "front"), gain("slit_cm", 30.0)]),
        ("not so tight", "top", [Step("chest", 1, 6.0)]),
    ],
)
def test_an_instruction_in_people_s_words_asks_for(text, kind, changes):
    assert list(heard(text, kind).changes) == changes


def test_vague_words_are_taken_to_mean_something_where_nothing_else_is_asked_for():
    sleeveless = [Claim("sleeves", "none"), Claim("skirt_hem", "mini")]
    winter = heard("make it work for winter", is_so=sleeveless.__contains__)
    assert winter.changes == (gain("sleeves", "long"),)
    assert winter.taken == (("winter", winter.changes),)
    assert heard("more modest", is_so=sleeveless.__contains__).changes == (
        gain("skirt_hem", "knee"),
        gain("shoulders", "both"),
    )
    long = [Claim("sleeves", "long")]
    assert heard("make it work for winter", is_so=long.__contains__).changes == ()  # long enough
    said = heard("for a summer party, but hem 3 cm up", is_so=[Claim("sleeves", "long")].__contains__)
    assert said.taken == ()


def test_what_is_so_already_names_what_it_is_said_of():
    v_neck = [Claim("neckline", "v")].__contains__
    assert heard("deeper V", is_so=v_neck).changes == (Step("neck depth", 1),)


@pytest.mark.parametrize(
    ("text", "kind", "so", "changes"),
    [
        ("both sleeves the same please", "dress", ("sides", "different"), [gain("sides", "alike")]),
        ("cover the left shoulder too", "top", ("shoulders", "bare left"), [gain("shoulders", "both")]),
        ("let the darts out", "top", ("bodice", "darted"), [gain("bodice", "undarted")]),
        ("sit it a bit lower on my hips", "skirt", ("rise", "high"), [gain("rise", "mid")]),
        ("raise the waist", "trousers", ("rise", "low"), [gain("rise", "mid")]),
        ("to the knee and with sleeves", "dress", ("sleeves", "none"), [gain("sleeves", "short")]),
        ("the slit is too long", "skirt", ("slit", "left"), [Step("left slit", -1)]),
    ],
)
def test_what_is_so_says_what_a_word_of_the_whole_garment_asks_for(text, kind, so, changes):
    found = heard(text, kind, is_so=lambda claim: claim == Claim(*so)).changes
    assert [c for c in found if c in changes] == changes
    assert not set(heard(text, kind).changes) & set(changes)


def test_what_is_denied_stays_as_it_is():
    said = heard("Don't make it shorter, just narrower at the hem", "skirt")
    assert said.changes == (Step("skirt hem", -1),)
    assert "length" in said.kept
    assert "length" in heard("lower the waist by 3 cm, keep overall length").kept
    assert "sleeve width" in heard("everything tighter except the sleeves", "top").kept


def test_what_is_swapped_is_not_asked_for():
    asked = heard("swap the long sleeves for short sleeves").changes
    assert gain("sleeves", "short") in asked and gain("sleeves", "long") not in asked


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


@pytest.mark.parametrize(
    ("text", "gain", "step"),
    [
        ("sleeves long and the skirt 10 cm shorter", "long", -1),
        ("make the sleeves short and the skirt 10 cm longer", "short", 1),
        ("sleeves really long and skirt 10 cm shorter", "long", -1),
        ("the skirt 10 cm longer and the sleeves long", "long", 1),
    ],
)
def test_what_stands_behind_its_noun_is_said_of_it(text, gain, step):
    words = read_words(text, kind="dress")
    found = spoken_changes(text, words, "dress")
    assert set(found.changes) == {Gain(Claim("sleeves", gain)), Step("length", step, 10.0)}


def test_who_has_none_asks_for_some():
    bare = {Claim("sleeves", "none")}.__contains__
    for text in ("a bit of sleeve", "sleeves, but not long ones", "some sleeves please"):
        assert heard(text, "dress", bare).changes == (gain("sleeves", "short"),), text
    assert heard("a bit of sleeve", "dress").changes == ()


def test_what_is_to_stay_is_told_from_habits_and_likeness():
    assert "sleeve length" in heard("like the sleeves, lose the collar", "top").kept
    assert "sleeve length" in heard("keep the sleeves", "top").kept
    assert not heard("I keep dipping the sleeves in the soup", "top").kept
    assert not heard("puffed like the sleeves of a queen", "top").kept


def test_what_opposite_things_are_asked_of_is_named():
    assert heard("longer and shorter").disputed == {"length"}
    assert not heard("longer and wider").disputed


@pytest.mark.parametrize(
    "text", ["don't make it any tighter than it is", "not much tighter", "never tighter"]
)
def test_a_comparison_that_is_refused_is_not_done(text):
    assert heard(text).changes == () and "chest" in heard(text).kept


@pytest.mark.parametrize("text", ["ankle-length micro skirt", "a mini maxi skirt"])
def test_of_words_that_contradict_each_other_none_counts(text):
    found = heard(text, "skirt", lambda claim: claim == Claim("kind", "skirt"))
    assert not found.changes and found.clashes


def test_all_that_contradictory_words_say_is_left_open():
    found = heard("strapless, with nice broad straps", "top", lambda claim: claim == Claim("sleeves", "none"))
    assert not found.changes and found.clashes


def test_what_everybody_likes_stays_but_for_what_is_excepted():
    found = heard("I like everything about it except the neckline, which should be square")
    assert found.changes == (gain("neckline", "square"),) and "neck depth" not in found.kept


@pytest.mark.parametrize("text", ["I want both sleeves", "give it a second sleeve", "sleeves on both arms"])
def test_what_has_one_sleeve_gets_the_other(text):
    so = {Claim("sleeves", "left only"), Claim("sides", "different")}
    assert heard(text, "top", so.__contains__).changes == (gain("sides", "alike"),)
    assert gain("sides", "alike") not in heard(text, "top").changes


@pytest.mark.parametrize(
    ("said", "amount"),
    [
        ("shorten it a bit", 5),
        ("etwas kürzer", 5),
        ("shorten it", None),
        ("a bit too long, shorten it", None),
    ],
)
def test_a_bit_is_little(said, amount):
    assert by_a_bit(said, Step("length", -1)) == Step("length", -1, amount)
    assert by_a_bit(said, Step("length", -1, 9.0)) == Step("length", -1, 9.0)
