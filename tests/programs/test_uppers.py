"""Upper garments: bodies, halves, asymmetry, strapless tops, other bodies."""

from __future__ import annotations

import math

import pytest
from hypothesis import HealthCheck, assume, given, settings
from hypothesis import strategies as st

from swifttailor.pattern import Pattern
from swifttailor.programs import DESIGN_PARAMETERS, DesignError, make_pattern
from swifttailor.programs.bodice_panels import (
    BodiceBackHalf,
    BodiceFrontHalf,
    TorsoBackHalfPanel,
    TorsoFrontHalfPanel,
)
from swifttailor.programs.body_parameters import BodyParameters
from swifttailor.programs.design import Design

BODY = BodyParameters.default()
UPPERS = ("Shirt", "FittedShirt")
PLAIN = Design({p.name: p.default for p in DESIGN_PARAMETERS.values()})


def value_of(parameter):
    if parameter.choices:
        return st.sampled_from(parameter.choices)
    low, high = parameter.range
    return st.integers(int(low), int(high)) if parameter.kind == "int" else st.floats(low, high)


ABOVE = ("shirt.", "collar.", "sleeve.")
above = st.fixed_dictionaries(
    {name: value_of(p) for name, p in DESIGN_PARAMETERS.items() if name.startswith(ABOVE)}
)
"""All parameters of an upper garment with two halves alike."""


def drafted(design) -> Pattern:
    """The pattern; cases that GarmentCode refuses too do not count."""
    try:
        return make_pattern(design)
    except DesignError:
        assume(False)
        raise


@settings(max_examples=40, suppress_health_check=list(HealthCheck))
@given(st.sampled_from(UPPERS), above)
def test_the_left_half_is_the_mirror_image_of_the_right_one(upper, design):
    pattern = drafted({**design, "meta.upper": upper})
    for right in pattern.panels:
        if "right" not in right.name:
            continue
        left = pattern.panel(right.name.replace("right", "left"))
        lengths = [sorted(p.edge_length(i) for i in range(len(p.edges))) for p in (left, right)]
        assert lengths[0] == pytest.approx(lengths[1], abs=1e-6)
        middle = [p.to_world(p.outline()).mean(axis=0) for p in (left, right)]
        assert middle[0] == pytest.approx(middle[1] * [-1, 1, 1], abs=0.5)


@settings(max_examples=40, suppress_health_check=list(HealthCheck))
@given(above)
def test_sides_and_shoulders_of_straight_shirts_are_sewn_at_equal_lengths(design):
    pattern = drafted({**design, "meta.upper": "Shirt", "shirt.flare": 1.0})
    for stitch in pattern.stitches:
        names = {side.panel.split("_", 1)[1] for side in stitch.sides}
        if names <= {"ftorso", "btorso"}:
            one, other = (pattern.edge_length(side) for side in stitch.sides)
            assert one == pytest.approx(other, rel=0.06, abs=0.3), stitch


@pytest.mark.parametrize("upper", UPPERS)
@pytest.mark.parametrize("panel", ["ftorso", "btorso"])
def test_halves_meet_in_the_middle(upper, panel):
    pattern = make_pattern({"meta.upper": upper})
    sides = {frozenset(side.panel for side in stitch.sides) for stitch in pattern.stitches}
    assert frozenset({f"right_{panel}", f"left_{panel}"}) in sides
    assert frozenset({"right_ftorso", "right_btorso"}) in sides


@pytest.mark.parametrize("front, back", [(TorsoFrontHalfPanel, TorsoBackHalfPanel)])
@pytest.mark.parametrize("bust", [85.0, 99.84, 120.0])
def test_a_straight_shirt_is_as_wide_as_bust_and_ease_say(front, back, bust):
    body = BODY.with_measures(bust=bust, back_width=bust * 0.48)
    width = sum(2 * panel("x", body, PLAIN).width for panel in (front, back))
    assert width == pytest.approx(PLAIN["shirt.width"] * bust)


def test_front_and_back_of_a_straight_shirt_have_sides_of_equal_length():
    sides = [
        panel("x", BODY, PLAIN.replaced({"shirt.flare": 1.3})).interfaces["outside"].edges.length()
        for panel in (TorsoFrontHalfPanel, TorsoBackHalfPanel)
    ]
    assert sides[0] == pytest.approx(sides[1], rel=0.02)


def test_a_fitted_bodice_is_as_wide_as_the_waist_when_its_darts_are_sewn():
    waist = 2 * sum(
        sum(panel("x", BODY, PLAIN).interfaces["bottom"].projecting_lengths())
        for panel in (BodiceFrontHalf, BodiceBackHalf)
    )
    assert waist == pytest.approx(BODY["waist"], rel=0.03)


def test_a_fitted_bodice_has_darts_and_a_straight_shirt_has_none():
    inside = {
        upper: [
            s for s in make_pattern({"meta.upper": upper}).stitches if len({x.panel for x in s.sides}) == 1
        ]
        for upper in UPPERS
    }
    assert inside["Shirt"] == []
    assert len(inside["FittedShirt"]) == 2 * (2 + 2)


def test_a_back_narrower_than_its_waist_needs_no_darts():
    body = BODY.with_measures(waist_back_width=BODY["back_width"] + 1)
    assert list(BodiceBackHalf("x", body, PLAIN).stitching_rules.assembly()) == []


def test_only_a_fitted_top_can_be_strapless():
    tops = [make_pattern({"meta.upper": upper, "shirt.strapless": True}) for upper in UPPERS]
    labels = [{edge.label for panel in top.panels for edge in panel.edges} for top in tops]
    assert "strapless_top" not in labels[0]
    assert "strapless_top" in labels[1]
    assert "right_armhole" not in labels[1] and "right_collar" not in labels[1]


def test_both_sides_of_a_strapless_top_are_equally_long():
    pattern = make_pattern({"meta.upper": "FittedShirt", "shirt.strapless": True})
    lengths = {"right_ftorso": 0.0, "right_btorso": 0.0}
    for stitch in pattern.stitches:
        if {side.panel for side in stitch.sides} == lengths.keys():
            for side in stitch.sides:
                lengths[side.panel] += pattern.edge_length(side)
    assert lengths["right_ftorso"] == pytest.approx(lengths["right_btorso"])


ASYMMETRIC = {"meta.upper": "FittedShirt", "left.enable_asym": True}


def test_halves_may_have_sleeves_and_necklines_of_their_own():
    pattern = make_pattern(
        {
            **ASYMMETRIC,
            "sleeve.sleeveless": True,
            "left.sleeve.sleeveless": False,
            "collar.f_collar": "VNeckHalf",
            "left.collar.f_collar": "SquareNeckHalf",
        }
    )
    assert {p.name for p in pattern.panels if "sleeve" in p.name} == {"left_sleeve_f", "left_sleeve_b"}
    counts = [
        sum(edge.label.endswith("_collar") for edge in pattern.panel(f"{side}_ftorso").edges)
        for side in ("right", "left")
    ]
    assert counts == [1, 2]


def test_halves_that_differ_have_no_collar_but_the_same_depth():
    pattern = make_pattern({**ASYMMETRIC, "collar.component.style": "Hood2Panels", "collar.fc_depth": 0.9})
    assert not [p.name for p in pattern.panels if "hood" in p.name]
    seams = 0
    for stitch in pattern.stitches:
        if {side.panel for side in stitch.sides} == {"right_ftorso", "left_ftorso"}:
            one, other = (pattern.edge_length(side) for side in stitch.sides)
            assert one == pytest.approx(other, abs=0.01)
            seams += 1
    assert seams == 1


def test_one_half_may_be_strapless():
    pattern = make_pattern({**ASYMMETRIC, "left.shirt.strapless": True})
    labels = {panel.name: {edge.label for edge in panel.edges} for panel in pattern.panels}
    assert "strapless_top" in labels["left_ftorso"] and "strapless_top" not in labels["right_ftorso"]


@pytest.mark.parametrize("length", [0.5, 1.0, 2.0])
def test_a_shirt_is_as_long_as_it_says(length):
    back = make_pattern({"meta.upper": "Shirt", "shirt.length": length}).panel("right_btorso")
    hem = back.to_world(back.outline())[:, 1].min()
    below_neck = BODY["height"] - BODY["head_l"] - hem
    slope = math.tan(math.radians(BODY["shoulder_incl"]))
    assert below_neck == pytest.approx(
        length * BODY["waist_line"] + slope * PLAIN["shirt.width"] * BODY["back_width"] / 2
    )


def test_an_armhole_for_which_there_is_no_room_names_its_parameter():
    slim = BODY.with_measures(
        bust=97.4,
        back_width=46.17,
        waist=80.34,
        waist_back_width=37.77,
        waist_line=35.75,
        shoulder_w=34.71,
        waist_over_bust_line=39.99,
    )
    deep = {"meta.upper": "FittedShirt", "sleeve.connecting_width": 2.0}
    with pytest.raises(
        DesignError, match=r"Panel 'right_.torso' has no room for an armhole .*connecting_width"
    ):
        make_pattern(deep, slim)
    make_pattern({**deep, "sleeve.connecting_width": 0.2}, slim)
