"""Armholes of other shapes, bare shoulders, necklines in curves."""

from __future__ import annotations

import pytest

from swifttailor import draft
from swifttailor.describing.claims import Claim
from swifttailor.describing.differences import Gain
from swifttailor.describing.measuring.parts import Part
from swifttailor.recutting import alter
from swifttailor.recutting.table.cutter import Cutter


def gain(name, value):
    return Gain(Claim(name, value))


@pytest.mark.parametrize("name", ["tank-top", "fitted-dress"])
@pytest.mark.parametrize("shape", ["square", "angled"])
def test_armholes_there_and_back(name, shape, sound):
    before = Cutter(draft(name))
    after = sound(before.pattern, alter(before.pattern, [gain("armholes", shape)]))
    round_again = sound(after.pattern, alter(after.pattern, [gain("armholes", "round")]))
    for cutter in (after, round_again):
        was, now = before.facts.torso, cutter.facts.torso
        assert now.left_armhole.depth == pytest.approx(was.left_armhole.depth, abs=0.1)
        assert now.left_shoulder == pytest.approx(was.left_shoulder, abs=0.01)
        assert cutter.facts.front_neck == before.facts.front_neck
        assert cutter.facts.hem.level == pytest.approx(before.facts.hem.level, abs=0.3)


def test_armholes_with_sleeves_are_left_alone():
    wish = gain("armholes", "square")
    assert alter(draft("t-shirt"), [wish]).open == (wish,)


def test_strapless(sound):
    before = draft("fitted-dress")
    after = sound(before, alter(before, [gain("shoulders", "strapless")]))
    # It hangs from its upper edge now, and not from the shoulders.
    assert after.facts.hem.level == pytest.approx(Cutter(before).facts.hem.level, abs=3.0)
    lower = {Part.SKIRT, Part.WAISTBAND}
    kept = {p.name: p for p in before.canonical().panels if after.anatomy.parts[p.name].part in lower}
    assert kept and all(after.pattern.panel(name) == panel for name, panel in kept.items())
    # It covers the bust in front, and does not rise to a point behind.
    figure = after.anatomy.figure
    for face, least in (("front", figure.bust_y - 2.0), ("back", 0.0)):
        panels = after.anatomy.panels(Part.TORSO, face=face)
        tops = [float(p.to_world(p.vertices)[:, 1].max()) for p in panels]
        assert least < max(tops) < figure.armpit_y + 8.0


@pytest.mark.parametrize("side", ["left", "right"])
def test_one_bare_shoulder_and_then_the_other(side, sound):
    one = alter(draft("fitted-dress"), [gain("shoulders", f"bare {side}")])
    assert one.open == () and one.facts.one_shoulder and not Cutter(one.pattern).faults
    both = alter(one.pattern, [gain("shoulders", "strapless")])
    at_once = alter(draft("fitted-dress"), [gain("shoulders", "strapless")])
    assert both.open == ()
    areas = [sorted(abs(p.signed_area()) for p in a.pattern.panels) for a in (both, at_once)]
    assert areas[0] == pytest.approx(areas[1], rel=1e-6)


@pytest.mark.parametrize("on", [gain("collar", "stand"), gain("sleeves", "short")])
def test_a_collar_or_sleeves_go_before_the_shoulders(on, sound):
    before = alter(draft("fitted-dress"), [on]).pattern
    after = sound(before, alter(before, [gain("shoulders", "strapless")]))
    assert after.facts.left_sleeve is None and after.facts.collar is None


def test_a_wide_shirt_would_slip():
    wish = gain("shoulders", "strapless")
    assert alter(draft("t-shirt"), [wish]).open == (wish,)


@pytest.mark.parametrize("shape", ["s-curve", "pointed"])
@pytest.mark.parametrize("half", ["", "left_", "right_"])
def test_curved_necklines(shape, half, sound):
    before = draft("tank-top")
    altered = alter(before, [gain(f"{half}neckline", shape)])
    assert altered.open == () and Cutter(altered.pattern).faults <= Cutter(before).faults
    if not half:
        sound(before, altered)
    was, now = Cutter(before).facts.front_neck, altered.facts.front_neck
    assert now.width == pytest.approx(was.width, abs=0.05)
