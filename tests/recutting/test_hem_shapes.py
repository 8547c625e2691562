"""Hems bent high-low and slanted, slits in them or not."""

import numpy as np
import pytest

from swifttailor import draft
from swifttailor.describing.claims import Claim
from swifttailor.describing.differences import Gain, Step
from swifttailor.pattern.garmentcode_writer import to_specification
from swifttailor.recutting import alter
from swifttailor.recutting.amounts.cuts import free_hem
from swifttailor.recutting.table.cutter import Cutter
from swifttailor.recutting.ways.hem_line import slant_hem


def gain(name, value):
    return Gain(Claim(name, value))


@pytest.mark.parametrize("name", ["t-shirt", "shirt-dress", "gathered-skirt"])
@pytest.mark.parametrize(("shape", "sign"), [("lower left", 1), ("lower right", -1)])
def test_slanted(name, shape, sign):
    before = Cutter(draft(name))
    altered = alter(before.pattern, [gain("hem_shape", shape)])
    after = Cutter(altered.pattern)
    assert altered.done and after.faults <= before.faults
    was, hem = before.facts.hem, after.facts.hem
    assert sign * (hem.right - hem.left) > 6.0
    assert hem.front == pytest.approx(was.front, abs=1.5) and hem.back == pytest.approx(was.back, abs=1.5)
    for stitch in set(altered.pattern.stitches) & set(before.pattern.stitches):
        was, now = (
            np.divide(*(p.edge_length(r) for r in stitch.sides)) for p in (before.pattern, after.pattern)
        )
        assert now == pytest.approx(was, rel=0.02)


def test_one_way_is_the_mirror_of_the_other():
    cutter = Cutter(draft("t-shirt"))
    left, right = (Cutter(slant_hem(cutter.pattern, free_hem(cutter), fall)).facts.hem for fall in (5, -5))
    assert left.left == pytest.approx(right.right, abs=0.2)
    assert left.right == pytest.approx(right.left, abs=0.2)
    assert slant_hem(cutter.pattern, (), 5.0) is None


def test_slanted_and_level_again():
    cutter = Cutter(draft("shirt-dress"))
    slanted = slant_hem(cutter.pattern, free_hem(cutter), 9.0)
    level = alter(slanted, [gain("hem_shape", "level")])
    assert level.done and abs(level.facts.hem.left - level.facts.hem.right) < 8.0


@pytest.mark.parametrize("place", ["left", "back", "front"])
def test_a_hem_with_a_slit_is_bent(place):
    slit = alter(draft("shirt-dress"), [gain("slit", place)])
    assert slit.done
    bent = alter(slit.pattern, [gain("slit", place), gain("hem_shape", "high-low")])
    assert bent.open == () and Cutter(bent.pattern).faults <= Cutter(slit.pattern).faults
    assert alter(slit.pattern, [Step("dip", -1)]).done


def test_the_same_again():
    one, other = (alter(draft("t-shirt"), [gain("hem_shape", "lower left")]).pattern for _ in range(2))
    assert to_specification(one) == to_specification(other)
