"""Halves exchanged for newly drafted ones, bands between them, bodices gathered more or less."""

from __future__ import annotations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from swifttailor import draft
from swifttailor.describing.claims import Claim
from swifttailor.describing.differences import Gain, Step
from swifttailor.describing.measuring.parts import LOWER_PARTS, Part
from swifttailor.pattern import Severity, check_pattern
from swifttailor.recutting import alter
from swifttailor.recutting.amounts import part_swaps
from swifttailor.recutting.amounts.part_swaps import FlaredCut
from swifttailor.recutting.amounts.peplum import sew_peplum
from swifttailor.recutting.table.cutter import Cutter


def gain(name, value):
    return Gain(Claim(name, value))


@pytest.mark.parametrize(
    ("name", "kind"),
    [
        ("trousers", "skirt"),
        ("fitted-skirt", "trousers"),
        ("circle-skirt", "shorts"),
        ("jumpsuit", "dress"),
        ("fitted-dress", "jumpsuit"),
        ("fitted-skirt", "dress"),
        ("circle-skirt", "dress"),
        ("trousers", "jumpsuit"),
    ],
)
def test_another_kind_of_garment(name, kind, sound):
    before = draft(name)
    sound(before, alter(before, [gain("kind", kind)]))


def test_the_other_half_stays_as_it_is(sound):
    before = draft("jumpsuit")
    after = sound(before, alter(before, [gain("kind", "dress")]))
    for panel in Cutter(before).anatomy.panels((Part.TORSO, Part.SLEEVE)):
        # Only its lower edge may be cut where the skirt has a joint.
        assert abs(after.pattern.panel(panel.name).signed_area()) == pytest.approx(abs(panel.signed_area()))
    assert after.facts.front_neck == Cutter(before).facts.front_neck


@pytest.mark.parametrize("name", ["fitted-skirt", "circle-skirt", "shirt-dress", "fitted-dress"])
@pytest.mark.parametrize("shape", ["half circle", "circle", "more than a circle", "pencil", "straight"])
def test_skirts_of_another_shape(name, shape, sound):
    before = Cutter(draft(name))
    wish = gain("skirt", shape)
    if wish.holds(before.facts, before.facts):
        return
    after = sound(before.pattern, alter(before.pattern, [wish]))
    assert after.facts.skirt.length == pytest.approx(before.facts.skirt.length, abs=2.5)
    assert after.facts.skirt.upper == pytest.approx(before.facts.skirt.upper, rel=0.02)
    was, now = before.facts.torso, after.facts.torso
    assert was is None or (now.chest == pytest.approx(was.chest) and now.darts == was.darts)
    assert was is None or now.lower_level == pytest.approx(was.lower_level, abs=0.5)
    assert after.facts.skirt.hips > after.facts.body.hip_girth - 2.0


@given(st.floats(0.3, 1.7), st.floats(30.0, 80.0))
@settings(max_examples=15, deadline=None)
def test_circles_fit_what_holds_them(fraction, length):
    before = Cutter(draft("shirt-dress"))
    after = Cutter(part_swaps.exchange_lower(before, FlaredCut(fraction, length)))
    assert after.faults <= before.faults
    assert after.facts.skirt.circle == pytest.approx(fraction, rel=0.02)
    assert after.facts.skirt.length == pytest.approx(length, rel=0.02)
    for face in ("front", "back"):
        seam = after.anatomy.seam(Part.TORSO, LOWER_PARTS, face=face)
        assert seam.other_length == pytest.approx(seam.length, rel=1e-3)


def test_slits_are_opened_again(sound):
    before = alter(draft("fitted-skirt"), [gain("slit", "left")]).pattern
    after = sound(before, alter(before, [gain("skirt", "half circle"), gain("slit", "left")]))
    was, now = (c.facts.skirt.slits[0].height for c in (Cutter(before), after))
    assert now == pytest.approx(was, abs=1.0)


@pytest.mark.parametrize("name", ["shirt-dress", "fitted-dress", "jumpsuit"])
def test_waistbands_set_in_and_taken_out(name, sound):
    before = Cutter(draft(name))
    with_band = sound(before.pattern, alter(before.pattern, [gain("waistband", "waist")]))
    band = with_band.facts.waistband
    assert not band.at_hem and band.upper == pytest.approx(band.lower, rel=1e-6)
    again = sound(with_band.pattern, alter(with_band.pattern, [gain("waistband", "none")]))
    assert again.facts.hem.level == pytest.approx(before.facts.hem.level, abs=1.0)
    assert len(again.pattern.panels) == len(before.pattern.panels)


def test_bodices_are_gathered_into_their_band(sound):
    before = draft("hoodie")
    for wishes in ([Step("chest", 1, 8.0)], [Step("bodice gathers", 1)]):
        after = sound(before, alter(before, wishes))
        assert after.facts.hood == Cutter(before).facts.hood
    more = alter(before, [Step("bodice gathers", 1)])
    assert more.facts.torso.chest == pytest.approx(Cutter(before).facts.torso.chest, abs=8.0)
    assert more.facts.waistband.upper == pytest.approx(Cutter(before).facts.waistband.upper)
    sound(more.pattern, alter(more.pattern, [Step("bodice gathers", -1)]))


def test_what_has_no_upper_edge_on_both_faces_is_not_exchanged():
    shirt = Cutter(draft("t-shirt"))
    assert part_swaps.exchange_lower(shirt, FlaredCut(0.5, 40.0)) is None
    assert part_swaps.sew_bodice(shirt) is None
    assert part_swaps.take_band_out(shirt) is None
    assert part_swaps.put_band_in(shirt, 5.0) is None


@pytest.mark.parametrize("name", ["t-shirt", "tank-top", "waistcoat"])
def test_peplum_is_sewn_to_the_waist_and_the_rest_stays(name):
    before = draft(name)
    done = alter(before, ["skirt=peplum"])
    assert not done.open
    assert done.facts.kind == "top" and done.facts.skirt is not None and done.facts.torso is not None
    assert done.facts.torso.lower_level == pytest.approx(done.facts.body.waist, abs=5.0)
    assert [f for f in check_pattern(done.pattern) if f.severity is not Severity.INFO] == []
    kept = [panel for panel in before.panels if "torso" not in panel.name]
    assert [done.pattern.panel(panel.name) for panel in kept] == kept


def test_no_peplum_on_what_has_a_lower_part_or_a_band():
    for name in ("hoodie", "fitted-dress", "trousers"):
        assert sew_peplum(Cutter(draft(name))) is None
