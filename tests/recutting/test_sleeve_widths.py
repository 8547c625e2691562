"""Sleeves made wider and narrower, their heads and ends more and less gathered."""

import numpy as np
import pytest

from swifttailor import draft
from swifttailor.describing.claims import Claim
from swifttailor.describing.differences import Gain, Step
from swifttailor.describing.measuring.parts import Part
from swifttailor.pattern.garmentcode_writer import to_specification
from swifttailor.recutting import alter
from swifttailor.recutting.amounts.sleeve_cuts import gather_sleeve_ends, gather_sleeve_heads, widen_sleeves
from swifttailor.recutting.table.cutter import Cutter
from swifttailor.recutting.ways.sleeve_width import sleeve_halves


def gain(name, value):
    return Gain(Claim(name, value))


def assert_alike(pattern):
    """Left like right."""
    panels = {p.name: p for p in pattern.panels}
    for name in (n for n in panels if n.startswith("left_sleeve")):
        left, right = (panels[n].to_world(panels[n].vertices) for n in (name, name.replace("left", "right")))
        assert all(np.abs(left - point * [-1, 1, 1]).max(axis=1).min() < 1e-3 for point in right)


@pytest.mark.parametrize("name", ["t-shirt", "shirt-dress", "hoodie"])
@pytest.mark.parametrize("by", [3.0, -5.0])
def test_width_at_the_underarm_with_heads_as_they_were(name, by):
    before = Cutter(draft(name))
    altered = alter(before.pattern, [Step("sleeve width", 1 if by > 0 else -1, abs(by))])
    after = Cutter(altered.pattern)
    assert altered.done and after.faults <= before.faults
    was, now = before.facts.left_sleeve, after.facts.left_sleeve
    assert now.upper_width - was.upper_width == pytest.approx(by, abs=1.5)
    assert now.head_gather == pytest.approx(was.head_gather, abs=0.02)
    assert now.length == pytest.approx(was.length, abs=1.5)
    assert {p for p in before.pattern.panels if "sleeve" not in p.name} == {
        p for p in altered.pattern.panels if "sleeve" not in p.name
    }
    assert_alike(altered.pattern)
    for stitch in altered.pattern.stitches:
        if all("sleeve" in r.panel for r in stitch.sides):
            lengths = [altered.pattern.edge_length(r) for r in stitch.sides]
            assert lengths[0] == pytest.approx(lengths[1], rel=0.02)


@pytest.mark.parametrize("shape", ["puffed", "wide", "bell", "tapered", "balloon"])
def test_shapes(shape):
    altered = alter(draft("shirt-dress"), [gain("sleeve_shape", shape)])
    assert altered.done
    assert Cutter(altered.pattern).faults <= Cutter(draft("shirt-dress")).faults
    assert_alike(altered.pattern)


def test_puffed_and_smooth_again():
    puffed = alter(draft("t-shirt"), [gain("sleeve_shape", "puffed")])
    assert puffed.facts.left_sleeve.head_gather > 1.2
    smooth = alter(puffed.pattern, [gain("sleeve_shape", "set smooth")])
    assert smooth.done and smooth.facts.left_sleeve.head_gather < 1.12


def test_sleeve_width_in_cm():
    altered = alter(draft("t-shirt"), [gain("sleeve_width_cm", 44.0)])
    assert altered.done and altered.facts.left_sleeve.upper_width == pytest.approx(44.0, abs=2.0)


def test_more_gathered_into_the_cuff():
    cuffed = alter(draft("shirt-dress"), [gain("cuffs", "band")]).pattern
    cutter = Cutter(cuffed)
    made = Cutter(gather_sleeve_ends(cutter, 1.5))
    assert made.facts.left_sleeve.end_gather == pytest.approx(1.5 * cutter.facts.left_sleeve.end_gather)
    assert {p for p in cuffed.panels if cutter.anatomy.parts[p.name].part is not Part.SLEEVE} <= set(
        made.pattern.panels
    )
    assert alter(cuffed, [Step("sleeve gathers", 1)]).done


def test_where_no_sleeve_can_be_widened():
    bare = Cutter(draft("tank-top"))
    assert widen_sleeves(bare, 1.2, 1.2) is None
    assert gather_sleeve_heads(bare, 1.2, 1.0) is None
    assert gather_sleeve_ends(bare, 1.2) is None
    assert sleeve_halves(bare.anatomy, "left") is None
    assert widen_sleeves(Cutter(draft("t-shirt")), 4.0, 4.0) is None


def test_the_same_again():
    one, other = (alter(draft("t-shirt"), [Step("sleeve width", 1)]).pattern for _ in range(2))
    assert to_specification(one) == to_specification(other)
