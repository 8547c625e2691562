"""Armholes of garments without sleeves: deeper, shallower, further out on the shoulder."""

import numpy as np
import pytest

from swifttailor import draft
from swifttailor.describing.claims import Claim
from swifttailor.describing.differences import Gain, Step
from swifttailor.pattern.garmentcode_writer import to_specification
from swifttailor.recutting import alter
from swifttailor.recutting.amounts.sleeve_cuts import deepen_armholes, widen_shoulders
from swifttailor.recutting.table.cutter import Cutter


def gain(name, value):
    return Gain(Claim(name, value))


def bare(name):
    return alter(draft(name), [gain("sleeves", "none")]).pattern


def assert_seams_fit(before, after):
    assert after.faults <= before.faults
    for pair, ratio in after.seam_ratios.items():
        assert ratio == pytest.approx(before.seam_ratios[pair], rel=0.02)
    for face in "fb":
        left, right = (after.pattern.panel(f"{s}_{face}torso") for s in ("left", "right"))
        points = [p.to_world(p.vertices) for p in (left, right)]
        assert all(np.abs(points[0] - p * [-1, 1, 1]).max(axis=1).min() < 1e-3 for p in points[1])


@pytest.mark.parametrize("name", ["t-shirt", "tank-top"])
@pytest.mark.parametrize(("direction", "amount"), [(1, 4.0), (-1, 4.0), (1, None)])
def test_depth(name, direction, amount):
    before = Cutter(bare(name))
    altered = alter(before.pattern, [Step("armholes", direction, amount)])
    after = Cutter(altered.pattern)
    assert altered.done
    assert_seams_fit(before, after)
    was, now = before.facts.torso.left_armhole, after.facts.torso.left_armhole
    assert direction * (now.depth - was.depth) > 1.5 and now.shape == was.shape
    assert after.facts.torso.left_shoulder == pytest.approx(before.facts.torso.left_shoulder)


def test_deep_armholes():
    assert alter(bare("t-shirt"), [gain("armholes", "deep")]).done


@pytest.mark.parametrize("by", [2.5, -2.5])
def test_shoulder_seams(by):
    before = Cutter(bare("t-shirt"))
    after = Cutter(widen_shoulders(before, by))
    assert_seams_fit(before, after)
    assert after.facts.torso.left_shoulder - before.facts.torso.left_shoulder == pytest.approx(by, abs=0.1)
    assert after.facts.front_neck.width == pytest.approx(before.facts.front_neck.width, abs=0.1)


def test_straps():
    wide = alter(bare("t-shirt"), [gain("straps", "wide")]).pattern
    narrow = alter(wide, [gain("straps", "narrow")])
    assert narrow.done and narrow.facts.torso.left_shoulder < 5.0


def test_where_there_is_no_free_armhole():
    for name in ("t-shirt", "trousers"):
        assert deepen_armholes(Cutter(draft(name)), 3.0) is None
        assert widen_shoulders(Cutter(draft(name)), 3.0) is None
    assert deepen_armholes(Cutter(bare("t-shirt")), 80.0) is None
    assert widen_shoulders(Cutter(bare("t-shirt")), -30.0) is None


def test_the_same_again():
    one, other = (alter(bare("t-shirt"), [Step("armholes", 1)]).pattern for _ in range(2))
    assert to_specification(one) == to_specification(other)
