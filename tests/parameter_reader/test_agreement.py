"""Choices of designs that agree with the panels that are seen."""

from __future__ import annotations

import random
from itertools import islice

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from swifttailor.errors import SwiftTailorError
from swifttailor.parameter_reader import ParameterReader
from swifttailor.parameter_reader.agreement import LEAST_SHARE, MAKE_PANELS, agreeing_design
from swifttailor.parameter_reader.drawn import drawn_designs
from swifttailor.parameter_reader.reader import SHIPPED
from swifttailor.pattern.names import PANEL_NAMES
from swifttailor.pattern_library.sought import Sought
from swifttailor.programs import make_pattern
from swifttailor.programs.read_parameter import ReadParameter

CUFFS = ReadParameter("sleeve.cuff.type", ("CuffBand", "CuffSkirt", "CuffBandSkirt", None))
BOTTOM = ReadParameter("meta.bottom", ("SkirtCircle", "Pants", None))
LENGTH = ReadParameter("sleeve.length", (0.3, 0.6), (0.45,))
PARAMETERS = (CUFFS, BOTTOM, LENGTH)
PLAIN = {"meta.upper": "FittedShirt", "sleeve.sleeveless": False, "meta.wb": "StraightWB"}
FIRST = PLAIN | {CUFFS.name: "CuffBand", BOTTOM.name: "SkirtCircle", LENGTH.name: 0.3}
"""The likeliest of `shares_of`, with what is not read."""


def names_of(design) -> set[str]:
    return {panel.name for panel in make_pattern(design).panels}


def seen_panels(design, certainty: float = 0.9) -> Sought:
    names, sought = names_of(design), Sought.nothing()
    sought.named[:] = 1.0
    sought.panels[:] = [certainty if name in names else 1 - certainty for name in PANEL_NAMES]
    return sought


def shares_of(cuffs, bottom=(0.9, 0.08, 0.02)):
    return [np.array(cuffs), np.array(bottom), np.array([0.6, 0.4])]


def test_without_panels_the_likeliest_stays():
    shares = shares_of((0.4, 0.3, 0.2, 0.1))
    assert agreeing_design(FIRST, PARAMETERS, shares, Sought.nothing()) == FIRST


@pytest.mark.parametrize("cuffs", CUFFS.values)
def test_the_cuff_is_the_one_whose_panels_are_seen(cuffs):
    true = FIRST | {CUFFS.name: cuffs}
    found = agreeing_design(FIRST, PARAMETERS, shares_of((0.4, 0.3, 0.2, 0.1)), seen_panels(true))
    assert found == true


def test_several_choices_change_in_turn_and_numbers_never():
    true = FIRST | {CUFFS.name: "CuffSkirt", BOTTOM.name: "Pants"}
    found = agreeing_design(FIRST, PARAMETERS, shares_of((0.5, 0.3, 0.1, 0.1)), seen_panels(true))
    assert found == true and found[LENGTH.name] == 0.3


def test_what_is_hardly_likely_is_not_tried_and_what_is_likelier_than_its_panels_stays():
    true = FIRST | {CUFFS.name: "CuffSkirt"}
    hardly = shares_of((0.9, LEAST_SHARE / 2, 0.08, 0.02 - LEAST_SHARE / 2))
    assert agreeing_design(FIRST, PARAMETERS, hardly, seen_panels(true))[CUFFS.name] != "CuffSkirt"
    sure = shares_of((0.96, 0.04, 0.0, 0.0))
    assert agreeing_design(FIRST, PARAMETERS, sure, seen_panels(true, 0.51)) == FIRST
    assert agreeing_design(FIRST, PARAMETERS, sure, seen_panels(true, 0.9)) == true


def test_a_design_that_is_refused_gives_way():
    sliding = {"meta.upper": None, "meta.wb": None, "flare-skirt.suns": 1.9, BOTTOM.name: "SkirtCircle"}
    design = FIRST | sliding
    found = agreeing_design(design, PARAMETERS, shares_of((1, 0, 0, 0), (0.6, 0.4, 0.0)), seen_panels(FIRST))
    assert found == design | {BOTTOM.name: "Pants"}


@pytest.mark.skipif(not SHIPPED.is_file(), reason="the package has no weights")
def test_no_other_choice_makes_other_panels():
    chance = random.Random(3)
    read = [one for one in ParameterReader.load().parameters if one.name not in MAKE_PANELS]
    for design, pattern in islice(drawn_designs(8), 12):
        names = {panel.name for panel in pattern.panels}
        for one in read:
            try:
                other = make_pattern(design | {one.name: chance.choice(one.values)})
            except SwiftTailorError:
                continue
            assert {panel.name for panel in other.panels} == names, one.name


@settings(max_examples=30, deadline=None)
@given(
    st.lists(st.floats(0.01, 1.0), min_size=7, max_size=7),
    st.floats(0.55, 0.95),
    st.sampled_from(CUFFS.values),
)
def test_the_whole_is_never_less_likely_than_it_was(lots, certainty, cuffs):
    cuff_shares, bottom_shares = np.array(lots[:4]), np.array(lots[4:])
    shares = shares_of(cuff_shares / cuff_shares.sum(), bottom_shares / bottom_shares.sum())
    first = FIRST | {
        one.name: one.values[int(share.argmax())] for one, share in zip(PARAMETERS[:2], shares, strict=False)
    }
    sought = seen_panels(FIRST | {CUFFS.name: cuffs}, certainty)

    def likelihood(design) -> float:
        names = names_of(design)
        of_panels = sum(
            np.log(p if name in names else 1 - p) for name, p in zip(PANEL_NAMES, sought.panels, strict=True)
        )
        chosen = zip(PARAMETERS[:2], shares, strict=False)
        return of_panels + sum(np.log(share[one.values.index(design[one.name])]) for one, share in chosen)

    assert likelihood(agreeing_design(first, PARAMETERS, shares, sought)) >= likelihood(first) - 1e-6
