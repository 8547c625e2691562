"""Hems of known patterns trued as tailors do: everywhere as far from the waist."""

from __future__ import annotations

import pytest

from swifttailor.describing import Claim
from swifttailor.describing.differences import Gain
from swifttailor.pattern import Pattern, check_pattern
from swifttailor.pattern.drafts import draft
from swifttailor.pattern_library import PatternLibrary
from swifttailor.pattern_maker.maker import WrittenPattern
from swifttailor.recutting.hems_below_waists import hem_below_waist
from swifttailor.recutting.level_hems import LEVEL_CM, level_hem, unevenness
from swifttailor.recutting.table.cutter import Cutter
from swifttailor.tailor.fitting import fit
from swifttailor.tailor.order import Order
from swifttailor.tailor.reading import Wanted
from swifttailor.wishes.reader import Wish

FITTED_DRESSES = ("gc_50001685", "gc_50011825", "gc_2002151")
"""Known patterns that were sewn and hang level within 4 cm as they are."""
BOWED_GORES = "gc_4001286"


@pytest.fixture(scope="module")
def library():
    return PatternLibrary.load()


@pytest.fixture(scope="module")
def gored(library) -> Pattern:
    return library.pattern(list(library.ids).index(BOWED_GORES))


def uneven(pattern: Pattern) -> float:
    hem = hem_below_waist(Cutter(pattern))
    assert hem is not None
    return unevenness(hem)


def fitted(pattern: Pattern, *claims: Claim) -> Pattern:
    """What words alone make of a known pattern."""
    wishes = tuple(Wish(Gain(claim), 1.0) for claim in claims)
    found = WrittenPattern(pattern, findings=tuple(check_pattern(pattern)))
    return fit(found, Wanted(Order("words"), "words", wishes=wishes)).pattern


@pytest.mark.parametrize("name", FITTED_DRESSES)
def test_the_way_over_the_bust_does_not_make_a_hem_uneven(library, name):
    pattern = library.pattern(list(library.ids).index(name))
    as_worn = Cutter(pattern).facts.hem
    assert as_worn is not None
    assert unevenness(as_worn) > LEVEL_CM  # its front bodice is longer
    assert uneven(pattern) < 3.0
    assert level_hem(pattern, below_waist=True) == (pattern, "")


def test_hems_of_gores_in_bows_are_trued_and_seams_still_fit(gored):
    trued, words = level_hem(gored, below_waist=True)
    assert words.startswith("hem made level")
    assert uneven(gored) > 7.0
    assert uneven(trued) < 1.5
    assert not [f for f in check_pattern(trued) if f.severity.name == "ERROR"]
    for stitch in trued.stitches:
        before, after = (
            p.edge_length(stitch.first) / p.edge_length(stitch.second) for p in (gored.canonical(), trued)
        )
        assert after == pytest.approx(before, abs=0.02)
    before, after = Cutter(gored).facts.hem, Cutter(trued).facts.hem
    assert before is not None and after is not None
    assert after.level == pytest.approx(before.level, abs=5.0)


def test_words_true_a_hem_and_keep_one_that_is_asked_for_in_bows(gored):
    assert uneven(fitted(gored, Claim("kind", "skirt"))) < 1.5
    asked = fitted(gored, Claim("kind", "skirt"), Claim("hem_shape", "scalloped"))
    assert Claim("hem_shape", "scalloped").holds(Cutter(asked).facts)


def test_without_being_asked_for_by_words_bows_stay(gored):
    assert level_hem(gored) == (gored, "")


def test_a_top_has_no_hem_below_a_waist(gored):
    assert hem_below_waist(Cutter(draft("t-shirt"))) is None
    assert hem_below_waist(Cutter(gored)) is not None
