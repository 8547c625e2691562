"""Sleeves and cuffs."""

from __future__ import annotations

import math

import pytest

from swifttailor.pattern import Pattern
from swifttailor.programs import make_pattern
from swifttailor.programs.body_parameters import BodyParameters
from swifttailor.programs.cuffs import CUFFS
from swifttailor.programs.design import Design
from swifttailor.programs.design_parameters import DESIGN_PARAMETERS

BODY = BodyParameters.default()
SHIRT = {"meta.upper": "Shirt", "sleeve.sleeveless": False}


def shirt(**values) -> Pattern:
    """A shirt with sleeves."""
    return make_pattern({**SHIRT, **{f"sleeve.{name}": value for name, value in values.items()}})


def under_arm(pattern: Pattern, panel: str = "right_sleeve_f") -> float:
    """Length of the longest straight edge of a sleeve panel but the upper one: the seam under the arm."""
    lengths = {}
    for stitch in pattern.stitches:
        if {side.panel for side in stitch.sides} == {"right_sleeve_f", "right_sleeve_b"}:
            lengths[stitch.sides] = pattern.edge_length(next(s for s in stitch.sides if s.panel == panel))
    return min(lengths.values())


def test_without_sleeves_there_are_no_panels_of_them():
    names = {p.name for p in make_pattern({**SHIRT, "sleeve.sleeveless": True}).panels}
    assert names == {"right_ftorso", "right_btorso", "left_ftorso", "left_btorso"}


@pytest.mark.parametrize("length", [0.2, 0.6, 1.1])
def test_front_and_back_of_a_sleeve_are_sewn_to_each_other_at_equal_lengths(length):
    pattern = shirt(length=length)
    for stitch in pattern.stitches:
        panels = {side.panel for side in stitch.sides}
        if all("sleeve" in name for name in panels):
            one, other = (pattern.edge_length(side) for side in stitch.sides)
            assert one == pytest.approx(other, abs=0.3)


def test_longer_sleeves_are_longer_and_none_is_shorter_than_the_least():
    lengths = [under_arm(shirt(length=length)) for length in (0.1, 0.3, 0.6, 0.9)]
    assert lengths == sorted(lengths)
    assert lengths[0] >= 5 - 1e-6
    assert lengths[3] - lengths[2] == pytest.approx(0.3 * BODY["arm_length"], rel=0.2)


def test_an_armhole_without_a_sleeve_is_labelled():
    pattern = make_pattern({**SHIRT, "sleeve.sleeveless": True})
    for name in ("right_ftorso", "left_btorso"):
        labels = [edge.label for edge in pattern.panel(name).edges]
        assert labels.count(f"{name.split('_')[0]}_armhole") == 1


def test_an_armhole_is_as_long_as_the_sleeve_that_goes_in():
    pattern = shirt(connect_ruffle=1.0)
    sewn_in = armhole = 0.0
    for stitch in pattern.stitches:
        sides = {side.panel.split("_", 1)[1]: side for side in stitch.sides if side.panel.startswith("right")}
        torso = sides.get("ftorso") or sides.get("btorso")
        sleeve = sides.get("sleeve_f") or sides.get("sleeve_b")
        if torso and sleeve:
            sewn_in += pattern.edge_length(sleeve)
            armhole += pattern.edge_length(torso)
    assert armhole > 40
    assert sewn_in == pytest.approx(armhole, rel=0.01)


def test_a_gathered_sleeve_is_wider_than_its_armhole():
    widths = []
    for ruffle in (1.0, 2.0):
        low, high = shirt(connect_ruffle=ruffle).panel("right_sleeve_f").bounding_box()
        widths.append(high[1] - low[1])
    assert widths[1] > 1.5 * widths[0]


@pytest.mark.parametrize("angle, stands", [(24, False), (40, True)])
def test_a_square_shoulder_needs_a_sleeve_steeper_than_the_shoulder(angle, stands):
    edges = [
        len(shirt(sleeve_angle=angle, standing_shoulder=on).panel("right_sleeve_f").edges)
        for on in (False, True)
    ]
    assert edges[1] - edges[0] == int(stands)


def test_no_sleeve_ends_narrower_than_the_wrist():
    panel = shirt(end_width=0.2, length=1.1).panel("right_sleeve_f")
    ends = [panel.edge_length(i) for i in range(len(panel.edges))]
    assert min(ends) >= BODY["wrist"] / 2 - 1e-6


@pytest.mark.parametrize("cuff", CUFFS)
def test_a_cuff_shortens_the_sleeve_by_its_length(cuff):
    values = {"length": 0.9, "cuff.cuff_len": 0.2}
    plain, with_cuff = shirt(**values), shirt(**values, **{"cuff.type": cuff})
    assert under_arm(plain) - under_arm(with_cuff) == pytest.approx(0.2 * BODY["arm_length"], rel=0.25)
    assert any(p.name.startswith("sl_right_cuff") for p in with_cuff.panels)


def test_a_cuff_takes_seven_tenths_of_a_short_sleeve_at_most():
    values = {"length": 0.3, "cuff.cuff_len": 0.9}
    cuff = shirt(**values, **{"cuff.type": "CuffBand"}).panel("sl_right_cuff_f")
    assert min(cuff.edge_length(i) for i in range(4)) == pytest.approx(0.7 * 0.3 * BODY["arm_length"])


def test_a_band_with_a_skirt_divides_the_length():
    values = {p.name.removeprefix("sleeve."): p.default for p in DESIGN_PARAMETERS.values()}
    own = {**values, "cuff.b_width": 20.0, "cuff.cuff_len": 10.0, "cuff.skirt_fraction": 0.3}
    both = CUFFS["CuffBandSkirt"]("x", Design(own))
    lengths = {p.name: p.length() for p in both.panels()}
    assert lengths["x_cuff_f"] == pytest.approx(7)
    assert lengths["x_cuff_skirt_f"] == pytest.approx(3)
    assert both.length() == pytest.approx(10)


def test_a_flared_cuff_is_wider_at_its_hem():
    values = {"cuff.b_width": 20.0, "cuff.cuff_len": 8.0, "cuff.skirt_ruffle": 1.0, "cuff.skirt_flare": 1.5}
    cuff = CUFFS["CuffSkirt"]("x", Design(values))
    top, bottom = (cuff.interfaces[name].edges.length() for name in ("top", "bottom"))
    assert top == pytest.approx(20)
    assert bottom == pytest.approx(20 + 2 * (1.5 - 1) * 20)


def test_sleeves_hang_as_the_arms_do():
    angles = {p.name: p.placement.rotation for p in shirt(length=0.9).panels if "sleeve" in p.name}
    for name, (x, y, z) in angles.items():
        side = 1 if name.startswith("right") else -1
        assert (x, y) == pytest.approx((0, 0), abs=1e-6)
        assert z == pytest.approx(side * BODY["arm_pose_angle"])
    assert not math.isclose(angles["right_sleeve_f"][2], 0)
