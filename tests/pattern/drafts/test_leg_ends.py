"""Slits in legs, waistbands that rise behind, and straps that cross."""

from __future__ import annotations

import pytest

from swifttailor.describing.measuring import measure_facts
from swifttailor.pattern.drafts import draft
from swifttailor.pattern.pattern import EdgeRef
from swifttailor.pattern.trims.front_view import FrontView


def free_edges(pattern, panel):
    sewn = {side for stitch in pattern.stitches for side in stitch.sides}
    refs = [EdgeRef(panel, k) for k in range(len(pattern.panel(panel).edges))]
    return [ref for ref in refs if ref not in sewn]


@pytest.mark.parametrize(
    ("name", "length"), [("pull-on-trousers", 40.0), ("jeans", 78.0), ("leggings", 98.0)]
)
def test_slits_are_as_long_in_front_as_behind(name, length):
    pattern = draft(name, length=length, side_slits=8.0)
    for panel in ("pant_f_l", "pant_b_l"):
        shortest = min(pattern.edge_length(ref) for ref in free_edges(pattern, panel))
        assert shortest == pytest.approx(8.0, abs=0.05)


def test_the_waistband_rises_in_the_middle_of_the_back():
    tops = []
    for rise in (0.0, 4.0):
        middle = FrontView(draft("trousers", back_rise=rise).panel("wb_back")).column(0.0)
        tops.append(0.0 if middle is None else middle[1])
    assert tops[1] - tops[0] == pytest.approx(4.0, abs=0.05)


def test_straps_that_cross_end_on_the_other_side():
    for crossed in (False, True):
        pattern = draft("dungarees", crossed=crossed)
        strap = pattern.panel("left_btorso")
        low = min(strap.to_world(strap.outline(0.5)).tolist(), key=lambda point: point[1])
        assert (low[0] < 0) is crossed


@pytest.mark.parametrize("name", ["trousers", "pull-on-trousers"])
def test_legs_that_taper_much_do_so_at_the_side_seams_too(name):
    """Else they hang beside the calves, which catch their hems."""
    hems = {}
    for flare in (-8.0, -18.0):
        front = draft(name, length=92.0, leg_ease=18.0, flare=flare).panel("pant_f_l")
        points = front.to_world(front.outline(0.5))
        low = points[points[:, 1] < points[:, 1].min() + 0.5]
        hems[flare] = (points[:, 0].max() - low[:, 0].max(), low[:, 0].max() - low[:, 0].min())
    assert hems[-18.0][0] > hems[-8.0][0] + 2.0 and hems[-18.0][1] < hems[-8.0][1] - 3.0


def test_bell_bottoms_are_far_wider_than_the_knee_and_reach_the_floor():
    legs = measure_facts(draft("flares")).trousers
    assert legs.hem > 1.04 * legs.thigh and measure_facts(draft("flares")).hem.level < 8.0
    mild = measure_facts(draft("flares", flare=12.0, leg_ease=10.0)).trousers
    assert mild.hem < 0.85 * legs.hem


@pytest.mark.parametrize("flare", [-7.0, -8.0])
@pytest.mark.parametrize("length", [60.0, 95.0])
def test_pencil_skirts_narrow_and_leave_room_for_both_legs(flare, length):
    skirt = measure_facts(draft("fitted-skirt", flare=flare, length=length)).skirt
    hips = measure_facts(draft("fitted-skirt", flare=0.0, length=length)).skirt.hem
    assert 0.74 * hips < skirt.hem < 0.86 * hips


def test_tiers_may_sit_on_the_hips():
    facts = [measure_facts(draft("tiered-skirt", length=44.0, tiers=2, below_waist=b)) for b in (0.0, 14.0)]
    assert facts[0].top_level - facts[1].top_level > 9.0
    assert facts[0].hem.level == pytest.approx(facts[1].hem.level, abs=5.0)
