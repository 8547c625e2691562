"""Close tops made longer: what is added is wide enough for the hips, what is above stays close."""

from __future__ import annotations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from swifttailor.describing import measure_facts
from swifttailor.pattern import Severity, check_pattern
from swifttailor.programs import make_pattern
from swifttailor.recutting import alter
from swifttailor.recutting.amounts.cuts import OVER_HIPS, lengthen_over_hips
from swifttailor.recutting.table.cutter import Cutter

FEW = settings(max_examples=12, deadline=None)
DARTED = make_pattern({"meta.upper": "FittedShirt", "meta.wb": None, "meta.bottom": None}).canonical()


@given(st.floats(4.0, 19.0))
@FEW
def test_the_waist_stays_and_the_hem_goes_over_what_is_below(distance):
    start = Cutter(DARTED)
    longer = lengthen_over_hips(start, distance)
    assert longer is not None
    before, after = start.facts, measure_facts(longer)
    assert before.hem.level - after.hem.level == pytest.approx(distance, abs=2.0)
    body = after.body
    assert body.waist_girth < after.hem.length < OVER_HIPS * body.hip_girth + 1.0
    assert after.torso.chest == pytest.approx(before.torso.chest, abs=0.1)
    for panel in longer.panels:  # nothing above the former hem is turned
        short = DARTED.panel(panel.name)
        known = {tuple(v) for v in short.to_world(short.vertices).round(3)}
        kept = {tuple(v) for v in panel.to_world(panel.vertices).round(3)}
        high = {v for v in known if v[1] > before.hem.level + 2.0}
        assert high and high <= kept
    assert not [f for f in check_pattern(longer) if f.severity is Severity.ERROR]
    for pair, ratio in Cutter(longer).seam_ratios.items():
        assert ratio == pytest.approx(start.seam_ratios[pair], rel=0.02)


def test_a_close_top_reaches_the_hips_and_stays_close():
    cut = alter(DARTED, ["top_hem=hip", "fit=close", "bodice=darted"])
    assert cut.open == ()
    assert cut.facts.body.waist_girth < cut.facts.hem.length < 1.06 * cut.facts.body.hip_girth


def test_what_is_wide_enough_already_is_not_widened():
    wide = make_pattern({"meta.upper": "Shirt", "meta.wb": None, "meta.bottom": None}).canonical()
    assert lengthen_over_hips(Cutter(wide), 8.0) is None
