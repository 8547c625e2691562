"""Hems of round skirts that are lower behind or cut in arcs, side seams that follow the body, bowed legs."""

from __future__ import annotations

import numpy as np
import pytest

from swifttailor.describing import Claim, measure_facts
from swifttailor.pattern.drafts import draft

ROUND = [("circle-skirt", "length", "fraction"), ("skater-dress", "skirt_length", "skirt_fraction")]


def middle(pattern, panel):
    """Waist to hem near the middle of a panel, cm."""
    points = np.concatenate([pattern.panel(panel).sample_edge(k, 33) for k in range(_count(pattern, panel))])
    return np.ptp(points[abs(points[:, 0] - points[:, 0].mean()) < 4.0][:, 1])


def _count(pattern, panel):
    return len(pattern.panel(panel).edges)


@pytest.mark.parametrize(("name", "length", "fraction"), ROUND)
@pytest.mark.parametrize("dip", [20.0, 40.0])
def test_dips_lower_the_back_alone(name, length, fraction, dip):
    level = draft(name, **{length: 45.0, fraction: 0.5})
    dipped = draft(name, **{length: 45.0, fraction: 0.5, "hem_dip": dip})
    front, back = (middle(dipped, panel) - middle(level, panel) for panel in ("skirt_front", "skirt_back"))
    assert front == pytest.approx(0.0, abs=0.5) and back == pytest.approx(dip, abs=0.5)
    hem = measure_facts(dipped).hem
    assert hem is not None and hem.front - hem.back > 0.6 * dip


@pytest.mark.parametrize(("name", "length", "fraction"), ROUND)
def test_arcs_are_shallow_and_of_the_width_asked_for(name, length, fraction):
    arcs = draft(name, **{length: 50.0, fraction: 0.4, "scallop_width": 10.0})
    panel = arcs.panel("skirt_front")
    ends = [panel.chord(k) for k in range(len(panel.edges))]
    widths = [float(np.hypot(*(end - start))) for start, end in ends]
    deep = []
    for k, (start, end) in enumerate(ends):
        along = (end - start) / widths[k]
        deep.append(np.ptp((panel.sample_edge(k, 33) - start) @ np.array([-along[1], along[0]])))
    scallops = [w for w, depth in zip(widths, deep, strict=True) if 3.0 < depth < 5.0 and 7.0 < w < 13.0]
    assert len(scallops) >= 5
    found = measure_facts(arcs)
    assert Claim("hem_shape", "scalloped").holds(found) and not Claim("hem_shape", "level").holds(found)
    level = measure_facts(draft(name, **{length: 50.0, fraction: 0.4}))
    assert level.hem is not None and level.hem.arcs == 0


@pytest.mark.parametrize(("name", "length", "fraction"), ROUND)
def test_points_hang_down_at_the_sides_and_between(name, length, fraction):
    level, pointed = (
        draft(name, **{length: 50.0, fraction: 0.75, "hem_points": points}) for points in (0.0, 20.0)
    )
    for panel in ("skirt_front", "skirt_back"):
        assert middle(pointed, panel) == pytest.approx(middle(level, panel), abs=3.0)
        assert len(pointed.panel(panel).edges) == len(level.panel(panel).edges) + 2
    assert Claim("hem_shape", "pointed").holds(measure_facts(pointed))
    assert not Claim("hem_shape", "pointed").holds(measure_facts(level))


def test_cloth_that_stretches_follows_the_waist_and_the_hips():
    loose, close = (
        draft("shift-dress", stretch=8, chest_ease=2, flare=0, length=70, waist_shaping=shaping)
        for shaping in (0.0, 4.0)
    )
    assert len(close.panel("left_ftorso").edges) == len(loose.panel("left_ftorso").edges) + 2


def test_jodhpurs_bow_at_the_thigh_and_are_as_close_below():
    straight, bowed = draft("jeans"), draft("jeans", bow=6)
    wide = [np.ptp(p.panel("pant_f_l").sample_edge(k, 65)[:, 0]) for p in (straight, bowed) for k in (1, 2)]
    assert max(wide[2:]) > max(wide[:2])
    hems = [np.ptp(p.panel("pant_f_l").chord(0)[:, 0]) for p in (straight, bowed)]
    assert hems[0] == pytest.approx(hems[1])


def test_barrel_legs_are_widest_at_the_knee():
    straight, barrel = draft("jeans"), draft("jeans", barrel=6)
    knees = [p.panel("pant_f_l").sample_edge(1, 3)[-1, 0] for p in (straight, barrel)]
    assert knees[1] - knees[0] == pytest.approx(6.0, abs=0.1)
    legs = barrel.panel("pant_f_l").sample_edge(1, 65)
    assert np.argmax(legs[:, 0]) == len(legs) - 1, "the seam is upright at the knee"
    hems = [np.ptp(p.panel("pant_f_l").chord(0)[:, 0]) for p in (straight, barrel)]
    assert hems[0] == pytest.approx(hems[1])
