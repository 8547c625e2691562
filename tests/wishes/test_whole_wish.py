"""What is heard of a wish word by word and as a whole, together."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from swifttailor.describing import Claim
from swifttailor.describing.differences import Gain, Step
from swifttailor.wishes.descriptions.hearing import hear_description
from swifttailor.wishes.descriptions.whole_wish import DOUBTED, LIKELY, MEANT, described_as_a_whole
from swifttailor.wishes.labels import change_of, statement_labels
from swifttailor.wishes.reader import Wish, WishReader
from swifttailor.wishes.text.whole_sides import is_of_one_side, speaks_of_sides
from swifttailor.wording.lexicon import SURENESS, exclude

DRESS, SHORTS = Gain(Claim("kind", "dress")), Gain(Claim("kind", "shorts"))
LONG, SHORT = Gain(Claim("sleeves", "long")), Gain(Claim("sleeves", "short"))
V_NECK, SLIT = Gain(Claim("neckline", "v")), Gain(Claim("slit", "left"))


def together(heard, whole, **more):
    return [w.change for w in described_as_a_whole([Wish(c, 0.97) for c in heard], whole, **more)]


def test_what_words_do_not_say_the_whole_does():
    found = described_as_a_whole([Wish(DRESS, 0.97)], {DRESS: 1.0, LONG: MEANT, V_NECK: LIKELY})
    assert {w.change: w.certainty for w in found} == {
        DRESS: 0.97, LONG: SURENESS["certain"], V_NECK: SURENESS["likely"]
    }  # fmt: skip
    assert together([DRESS], {DRESS: 1.0, LONG: LIKELY - 0.01}) == [DRESS]
    assert together([DRESS], {}) == [DRESS], "there is no such network"


def test_a_length_that_is_named_is_not_the_next_one_too():
    midi, floor = Gain(Claim("skirt_hem", "midi")), Gain(Claim("skirt_hem", "floor"))
    whole = {DRESS: 1.0, midi: 0.7, floor: 0.9}
    assert together([DRESS, midi], whole, stated=[midi]) == [DRESS, midi]
    assert floor in together([DRESS, midi], whole)


def test_what_the_network_all_but_excludes_was_misheard():
    assert together([DRESS, LONG], {DRESS: 1.0, LONG: DOUBTED - 0.01}) == [DRESS]
    assert together([DRESS, LONG], {DRESS: 1.0, LONG: DOUBTED}) == [DRESS, LONG]
    for how in ("stated", "named", "said"):
        assert together([DRESS, LONG], {DRESS: 1.0, LONG: 0.0}, **{how: [LONG]}) == [DRESS, LONG]


def test_what_a_name_usually_means_does_not_take_the_place_of_a_detail():
    hip, cropped = Gain(Claim("top_hem", "hip")), Gain(Claim("top_hem", "cropped"))
    whole = {hip: MEANT, cropped: 0.0}
    assert together([cropped], whole, said=[cropped]) == [hip]
    assert together([cropped], whole, said=[cropped], outdone=[hip]) == [cropped]
    assert together([cropped], whole, outdone=[hip]) == [hip], "no word says it"


@pytest.mark.parametrize(
    "change", [Gain(Claim("sleeves", "left only")), Gain(Claim("sides", "different")),
               Gain(Claim("left_sleeve", "short")), Gain(Claim("shoulders", "bare right"))]
)  # fmt: skip
def test_sides_differ_where_they_are_spoken_of(change):
    assert is_of_one_side(change) and not is_of_one_side(DRESS) and not is_of_one_side(LONG)
    assert speaks_of_sides("a dress with one bare arm") and not speaks_of_sides("a short-sleeved wrap dress")
    assert speaks_of_sides("one pocket and one sleeve") and not speaks_of_sides(
        "a tabard with one big pocket"
    )
    reader = WishReader.load()
    assert change not in reader.whole("a short-sleeved wrap dress", instruction=False)
    assert change in reader.whole("a dress with one bare arm", instruction=False)


def test_of_what_excludes_each_other_the_likelier_counts():
    assert together([DRESS, LONG], {DRESS: 1.0, LONG: 0.3, SHORT: 0.8}, named=[LONG]) == [DRESS, SHORT]
    assert together([DRESS, LONG], {DRESS: 1.0, LONG: 0.9, SHORT: 0.8}) == [DRESS, LONG]
    assert together([DRESS, LONG], {DRESS: 1.0, SHORT: 1.0}, stated=[LONG]) == [DRESS, LONG]


def test_a_name_that_the_network_does_not_know_is_left_to_the_lexicon():
    found = together([SHORTS, LONG], {SHORTS: 0.01, DRESS: 0.9, LONG: 0.0, SHORT: 0.9, V_NECK: 0.9})
    assert set(found) == {SHORTS, LONG}, "nothing is taken away, and shorts have no neckline"


def test_a_kind_that_is_refused_is_not_taken_from_it():
    """Of "anything but shorts" it reads shorts."""
    whole = {SHORTS: 1.0}
    assert together([DRESS], whole, never=[SHORTS.claim]) == [DRESS]
    assert together([DRESS], whole) == [SHORTS]


def test_what_is_refused_or_cannot_be_had_is_not_taken_from_it():
    assert together([DRESS], {DRESS: 1.0, V_NECK: 1.0}, never=[V_NECK.claim]) == [DRESS]
    assert together([SHORTS], {SHORTS: 1.0, SLIT: 1.0, V_NECK: 1.0}) == [SHORTS]
    assert together([DRESS], {DRESS: 1.0, Step("length", 1): 1.0}) == [DRESS], "a wish changes nothing"


CHANGES = st.sampled_from([change_of(label) for label in statement_labels()])


@given(st.lists(CHANGES, max_size=3, unique=True), st.dictionaries(CHANGES, st.floats(0, 1), max_size=12))
def test_nothing_that_is_added_contradicts_anything_and_the_surest_come_first(heard, whole):
    found = described_as_a_whole([Wish(c, 0.97) for c in heard], whole)
    added = [w.change for w in found if w.change not in heard]
    gains = [w.change for w in found if isinstance(w.change, Gain)]
    assert all(isinstance(c, Gain) and whole[c] >= LIKELY for c in added)
    assert not any(exclude(a.claim, b.claim) for a in added for b in gains if a != b)
    certainties = [w.certainty for w in found]
    assert certainties == sorted(certainties, reverse=True)
    assert len({w.change for w in found}) == len(found)


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        ("knickerbockers that blouse out over the sock", {"kind": "trousers"}),
        (
            "I want to stride, so nothing tight round my legs, and the hem at mid-calf: a skirt",
            {"kind": "skirt"},
        ),
        ("a gown whose neck goes straight across from shoulder to shoulder", {"neckline": "boat"}),
    ],
)
def test_the_package_hears_what_no_table_has(text, meant):
    heard = hear_description(text, WishReader.load())
    said = {w.change.claim.name: w.change.claim.value for w in heard.sure}
    assert meant.items() <= said.items()


def test_a_length_that_a_word_says_stands_unless_another_is_meant():
    maxi, mini = Gain(Claim("skirt_hem", "maxi")), Gain(Claim("skirt_hem", "mini"))
    assert together([DRESS, maxi], {DRESS: 1.0, maxi: 0.0}, said=[maxi]) == [DRESS, maxi]
    assert together([DRESS, maxi], {DRESS: 1.0, maxi: 0.0, mini: 0.9}, said=[maxi]) == [DRESS, mini]
    assert together([DRESS, maxi], {DRESS: 1.0, maxi: 0.0}) == [DRESS], "no word says it"
