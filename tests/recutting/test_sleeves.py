"""Sewing sleeves on to what has none."""

import numpy as np
import pytest

from swifttailor import draft
from swifttailor.describing.claims import Claim
from swifttailor.describing.differences import Gain
from swifttailor.describing.measuring import measure_facts
from swifttailor.pattern.garmentcode_writer import to_specification
from swifttailor.recutting import alter
from swifttailor.recutting.amounts.sleeve_cuts import add_sleeves
from swifttailor.recutting.table.cutter import Cutter
from swifttailor.recutting.ways.sleeves import find_hole

NEW = {"left_sleeve_f", "left_sleeve_b", "right_sleeve_f", "right_sleeve_b"}


def gain(name, value):
    return Gain(Claim(name, value))


def bare(name):
    return alter(draft(name), [gain("sleeves", "none")]).pattern


@pytest.mark.parametrize("name", ["t-shirt", "shirt-dress", "tank-top", "fitted-dress", "jumpsuit"])
@pytest.mark.parametrize("wish", [gain("sleeves", "short"), gain("sleeves", "long"), gain("sleeve_cm", 35.0)])
def test_sleeves_are_sewn_on_and_nothing_else_changes(name, wish):
    pattern = bare(name)
    before = Cutter(pattern)
    assert before.facts.left_sleeve is None
    altered = alter(pattern, [wish])
    after = Cutter(altered.pattern)

    assert altered.done == (wish,) and wish.holds(before.facts, after.facts)
    assert after.faults <= before.faults
    old = {p.name: p for p in before.pattern.panels}
    made = {p.name: p for p in altered.pattern.panels if p.name not in old}
    assert set(made) == NEW
    assert all(p == old[p.name] for p in altered.pattern.panels if p.name in old)
    assert set(before.pattern.stitches) <= set(altered.pattern.stitches)
    for stitch in set(altered.pattern.stitches) - set(before.pattern.stitches):
        lengths = [altered.pattern.edge_length(r) for r in stitch.sides]
        assert lengths[0] == pytest.approx(lengths[1], rel=1e-6) and not stitch.right_wrong
    for panel in made.values():
        assert panel.label == "arm"
        assert np.sign(panel.normal()[2]) == (1 if panel.name.endswith("_f") else -1)
    assert len(altered.pattern.components()) == 1


def test_both_sleeves_are_alike_and_fit_arm_and_hand():
    for length in (12.0, 22.0, 40.0, 55.0):
        cutter = Cutter(add_sleeves(Cutter(bare("t-shirt")), length))
        left, right, figure = cutter.facts.left_sleeve, cutter.facts.right_sleeve, cutter.anatomy.figure
        assert left is not None and right is not None
        assert left.length == pytest.approx(length, abs=0.5)
        assert left.upper_width > figure.upper_arm + 3.0 and left.end_width > 1.3 * figure.wrist
        assert left.end_width > figure.arm_girth(length) + 3.0
        assert left.head_gather == pytest.approx(1.0, abs=1e-6)
        for name in ("f", "b"):
            panels = {p.name: p for p in cutter.pattern.panels}
            points = [panels[f"{s}_sleeve_{name}"] for s in ("left", "right")]
            world = [p.to_world(p.vertices) for p in points]
            mirrored = world[1] * [-1.0, 1.0, 1.0]
            assert all(np.abs(world[0] - m).max(axis=1).min() < 1e-3 for m in mirrored)


def test_an_armhole_with_joints_gets_a_cap_with_joints():
    pattern = draft("t-shirt")
    cutter = Cutter(alter(pattern, [gain("sleeves", "none")]).pattern)
    hole = find_hole(cutter.anatomy, "left")
    assert hole is not None
    split = cutter.pattern
    for ref in (hole.front[0], hole.back[0]):
        split = _split(split, ref)
    made = add_sleeves(Cutter(split), 30.0)
    assert made is not None and Cutter(made).faults <= cutter.faults
    assert {len(p.edges) for p in made.panels if p.name.startswith("left_sleeve")} == {5}
    assert {len(p.edges) for p in made.panels if p.name.startswith("right_sleeve")} == {4}


def _split(pattern, ref):
    from swifttailor.recutting.table.workbench import Workbench

    bench = Workbench(pattern)
    bench.split(bench.at[ref], 0.4)
    return bench.pattern()


def test_one_sleeve_alone_and_the_second_like_the_first():
    one = alter(bare("t-shirt"), [gain("left_sleeve", "long")])
    assert one.done and one.facts.left_sleeve is not None and one.facts.right_sleeve is None
    only = alter(bare("t-shirt"), [gain("sleeves", "right only")])
    assert only.done and only.facts.left_sleeve is None

    for name in ("hoodie", "t-shirt"):
        whole = draft(name)
        half = alter(whole, [gain("sleeves", "left only")]).pattern
        length = measure_facts(whole).left_sleeve.length
        both = alter(half, [gain("sleeve_cm", length)])
        assert both.done and both.cuts == ("second sleeve sewn on",)
        assert both.facts.right_sleeve.end_width == pytest.approx(both.facts.left_sleeve.end_width)
        assert Cutter(both.pattern).faults <= Cutter(half).faults
        assert len(both.pattern.panels) == len(whole.panels)
        assert len(both.pattern.stitches) == len(whole.stitches)


def test_several_wishes_with_new_sleeves():
    wishes = [gain("sleeves", "long"), gain("neckline", "v"), gain("cuffs", "band")]
    altered = alter(draft("tank-top"), wishes)
    assert altered.open == ()


def test_where_no_sleeve_can_be_sewn_on():
    assert alter(draft("trousers"), [gain("sleeves", "long")]).open
    assert add_sleeves(Cutter(draft("t-shirt")), 30.0) is None
    assert add_sleeves(Cutter(bare("t-shirt")), 4.0) is None
    assert find_hole(Cutter(draft("t-shirt")).anatomy, "left") is None


def test_the_same_again():
    one, other = (alter(bare("shirt-dress"), [gain("sleeves", "elbow")]).pattern for _ in range(2))
    assert to_specification(one) == to_specification(other)
