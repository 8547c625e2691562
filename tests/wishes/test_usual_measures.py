"""Measures that known patterns are chosen by where nobody speaks of them."""

from __future__ import annotations

import numpy as np

from swifttailor.describing import Claim
from swifttailor.describing.claims import CLAIM_TYPES
from swifttailor.describing.differences import Gain
from swifttailor.pattern_library.sought import Sought
from swifttailor.picture_reader.labels import measure_labels
from swifttailor.wishes.assumed.usual_measures import (
    CLOSE_NECK,
    FULL_GATHERS,
    FULL_TIERS,
    LOW_STAND,
    OPEN_NECK,
    usual_measures,
    usual_necks,
)
from swifttailor.wishes.reader import Wish


def of(kind, *told, certainty=0.97):
    return usual_measures([Wish(Gain(Claim(*one)), certainty) for one in told], kind)


def test_all_are_measures_that_a_library_knows():
    told = [(kind.name, value) for kind in CLAIM_TYPES.values() for value in kind.words]
    for kind in CLAIM_TYPES["kind"].words:
        for one in told:
            assert set(of(kind, one)) <= set(measure_labels())


def test_a_collar_that_stands_stands_close_and_one_that_stands_in_is_low():
    assert of("top", ("collar", "stand")) == dict(CLOSE_NECK)
    assert of("top", ("collar", "stand"), certainty=0.85) == {**CLOSE_NECK, **LOW_STAND}
    assert of("top", ("collar", "stand"), ("neck_depth", "low")) == {}
    assert of("top", ("collar", "lapel")) == {}


def test_gathers_and_tiers_are_full():
    assert of("dress", ("skirt", "gathered")) == dict(FULL_GATHERS)
    assert of("skirt", ("skirt", "tiered")) == dict(FULL_TIERS)
    assert of("skirt", ("skirt", "tiered"), ("hips", "close")) == {}


def test_a_band_is_as_wide_as_the_waist_unless_it_is_to_be_otherwise():
    assert set(of("trousers", ("waistband", "waist"))) == {"waistband width"}
    for other in (("waistband", "loose"), ("rise", "low")):
        assert of("trousers", ("waistband", "waist"), other) == {}
    assert of("top", ("waistband", "hem")) == {}


def test_what_is_known_of_a_measure_stays():
    usual = {"neck width": (17.0, 1.5)}
    number = measure_labels().index("neck width")
    known = Sought.nothing()
    known.measures[number], known.measured[number] = 1.0, (2.5, 0.1)
    assert known.with_measures(usual).measures[number] == 1.0
    assert known.with_measures({}) is known
    plain = Sought.nothing()
    found = plain.with_measures(usual)
    assert found.measures[number] > 0.0 and plain.measures[number] == 0.0
    assert np.delete(found.measures, number).max() == 0.0


def test_a_neckline_of_which_nobody_speaks_is_sought_as_it_is_usual():
    assert usual_necks([], "dress") == OPEN_NECK
    assert usual_necks([], "skirt") == {} and usual_necks([], None) == {}
    for spoken in (Claim("neck_depth", "low"), Claim("collar", "stand"), Claim("shoulders", "strapless")):
        assert usual_necks([Wish(Gain(spoken), 0.97)], "dress") == {}
    assert usual_necks([Wish(Gain(Claim("shoulders", "both")), 0.97)], "dress") == OPEN_NECK
