"""Godets and tiers, slits over joints."""

from __future__ import annotations

import numpy as np
import pytest

from swifttailor import draft
from swifttailor.describing.claims import Claim
from swifttailor.describing.differences import Gain, Step
from swifttailor.describing.measuring.parts import SKIRT_PARTS, Part
from swifttailor.recutting import alter
from swifttailor.recutting.table.cutter import Cutter
from swifttailor.recutting.ways.godets import add_godets, remove_godets
from swifttailor.recutting.ways.slits import open_side


def gain(name, value):
    return Gain(Claim(name, value))


@pytest.mark.parametrize("name", ["fitted-skirt", "gathered-skirt", "fitted-dress"])
def test_godets_let_in(name, sound):
    before = draft(name)
    after = sound(before, alter(before, [gain("skirt", "godets")]))
    assert after.facts.skirt.godets == 6
    for own, other in after.anatomy.seam(Part.GODET, Part.SKIRT).pairs:
        assert after.anatomy.edge_length(own) == pytest.approx(after.anatomy.edge_length(other), rel=1e-6)


@pytest.mark.parametrize(
    "step",
    [
        Step("godets", 1),
        Step("godets", -1),
        Step("godet width", 1, 6.0),
        Step("godet width", -1),
        Step("godet height", 1),
        Step("godet height", -1, 5.0),
    ],
)
def test_godets_of_another_number_and_size(step, sound):
    before = alter(draft("gathered-skirt", flare=0.0), [gain("skirt", "godets")]).pattern
    after = sound(before, alter(before, [step]))
    was, now = Cutter(before).facts.skirt, after.facts.skirt
    changed = {"godets": was.godets != now.godets, "godet width": was.godet_width != now.godet_width}
    assert all(has == (name == step.quantity) for name, has in changed.items())
    assert now.godets % 2 == 0


def test_a_narrower_hem_keeps_the_godets(sound):
    before = alter(draft("gathered-skirt", flare=0.0), [gain("skirt", "godets")]).pattern
    after = sound(before, alter(before, [Step("skirt hem", -1)]))
    assert after.facts.skirt.godets == Cutter(before).facts.skirt.godets


@pytest.mark.parametrize("count", [1, 3, 5])
def test_taken_out_the_skirt_is_as_it_was(count):
    before = Cutter(draft("gathered-skirt", flare=0.0))
    pattern = add_godets(before.pattern, before.hem_of(*SKIRT_PARTS), count, 20.0, 30.0)
    names = Cutter(pattern).names(Part.GODET)
    assert len(names) == 2 * count
    plain = remove_godets(pattern, names)
    for panel in before.pattern.panels:
        same = plain.panel(panel.name)
        assert len(same.edges) == len(panel.edges)
        assert abs(same.signed_area()) == pytest.approx(abs(panel.signed_area()))
    assert Cutter(plain).facts.hem == before.facts.hem


def test_godets_too_high_or_too_many_do_not_fit():
    before = Cutter(draft("gathered-skirt", flare=0.0))
    hem = before.hem_of(*SKIRT_PARTS)
    assert add_godets(before.pattern, hem, 40, 20.0, 30.0) is None
    assert add_godets(before.pattern, hem, 2, 20.0, 500.0) is None


@pytest.mark.parametrize("name", ["gathered-skirt", "fitted-skirt", "shirt-dress"])
def test_tiers_sewn_on(name, sound):
    before = Cutter(draft(name))
    altered = alter(before.pattern, [Step("tiers", 1, 2.0)])
    after = sound(before.pattern, altered)
    assert after.facts.skirt.tiers == before.facts.skirt.tiers + 2
    assert after.facts.length == pytest.approx(before.facts.length, abs=2.0)
    assert after.facts.skirt.tier_gather == pytest.approx(1.35, abs=0.05)
    one_less = sound(after.pattern, alter(after.pattern, [Step("tiers", -1, 1.0)]))
    assert one_less.facts.skirt.tiers == before.facts.skirt.tiers + 1


def test_slits_go_over_joints_in_the_side_seam(sound):
    low = alter(draft("shirt-dress"), [gain("slit_cm", 12.0), gain("slit", "left")]).pattern
    closed = alter(low, [gain("slit", "none")]).pattern  # leaves a joint where the slit ended
    cutter = Cutter(closed)
    high = Cutter(open_side(closed, cutter.hem, 30.0, "left"))
    (slit,) = high.facts.skirt.slits
    assert slit.height == pytest.approx(30.0, abs=1.0) and high.faults <= cutter.faults
    assert open_side(closed, cutter.hem, 500.0, "left") is None


def test_skirts_with_slits_are_lengthened_and_flared(sound):
    before = alter(draft("fitted-skirt"), [gain("slit", "left")]).pattern
    for wish in (Step("length", 1, 8.0), Step("skirt hem", 1, 20.0)):
        after = sound(before, alter(before, [wish, gain("slit", "left")]))
        assert np.isfinite(after.facts.hem.level)
