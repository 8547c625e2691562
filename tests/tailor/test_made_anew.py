"""Edits that cutting does not lead to: what a known pattern may stand in for."""

import pytest
from own_library import library_of

import swifttailor
from swifttailor.describing import Claim, measure_facts
from swifttailor.describing.differences import Gain
from swifttailor.recutting.unasked import spoken_parts, unasked
from swifttailor.tailor.made_anew import anew_from_known
from swifttailor.tailor.order import Order
from swifttailor.tailor.reading import Wanted
from swifttailor.wishes.reader import Wish

LOW = Gain(Claim("rise", "low"))
WIDE = swifttailor.draft("trousers", leg_ease=30.0)


def asked(edit, *changes):
    return Wanted(Order("words", edit=edit), "words", wishes=tuple(Wish(c, 1.0) for c in changes))


@pytest.fixture(scope="module")
def library(tmp_path_factory):
    known = {
        "like": swifttailor.draft("fitted-skirt", length=60.0),
        "flared": swifttailor.draft("circle-skirt", length=58.0),
        "legs": WIDE,
    }
    return library_of(known, tmp_path_factory.mktemp("library"))


def test_what_it_is_made_of_does_all_that_is_asked(library):
    edit = swifttailor.draft("trousers", leg_ease=4.0)
    wide = Gain(Claim("legs", "wide"))
    before = measure_facts(edit)
    answer = anew_from_known(asked(edit, wide), lambda: library)
    assert answer is not None
    after = measure_facts(answer.pattern)
    assert answer.known == "legs" and answer.anew and not answer.of_edit
    assert wide.holds(before, after)
    assert before.waistband and after.waistband
    assert after.waistband.height == pytest.approx(before.waistband.height, abs=0.1)
    assert unasked(spoken_parts([wide]), before, after) == ()


def test_nothing_is_made_anew_where_no_known_pattern_does_it(library):
    assert anew_from_known(asked(swifttailor.draft("fitted-skirt"), LOW), lambda: library) is None


def test_without_known_patterns_nothing_is_made_anew():
    assert anew_from_known(asked(swifttailor.draft("fitted-skirt"), LOW), lambda: None) is None


def test_another_garment_does_not_stand_in(library):
    edit = swifttailor.draft("shirt-dress")
    assert anew_from_known(asked(edit, Gain(Claim("collar", "lapel"))), lambda: library) is None
