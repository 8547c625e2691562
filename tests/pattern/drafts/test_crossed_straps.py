"""Straps that cross behind, yokes, backs that are cut in or open below, and pleats from the hips."""

from __future__ import annotations

import numpy as np
import pytest

from swifttailor.pattern.drafts import draft
from swifttailor.pattern.pattern import EdgeRef
from swifttailor.pattern.trims.front_view import FrontView
from swifttailor.recutting.holes import has_holes


def sewn_to(pattern, panel: str) -> set[str]:
    """Panels that share a seam with one."""
    pairs = [{side.panel for side in stitch.sides} for stitch in pattern.stitches]
    return {other for pair in pairs if panel in pair for other in pair - {panel}}


@pytest.mark.parametrize("name", ["camisole", "slip-dress", "strappy-dress", "strappy-jumpsuit"])
@pytest.mark.parametrize("width", [1.0, 4.0])
def test_each_strap_runs_from_its_shoulder_to_the_other_half_of_the_back(name, width):
    pattern = draft(name, crossed=True, strap_width=width)
    assert sewn_to(pattern, "left_btorso_strap") == {"left_ftorso", "right_btorso"}
    assert sewn_to(pattern, "right_btorso_strap") == {"right_ftorso", "left_btorso"}
    left, over = (pattern.panel(f"{side}_btorso_strap") for side in ("left", "right"))
    assert over.placement.translation[2] < left.placement.translation[2] - 1.0, "one lies over the other"
    low = left.to_world(left.outline(0.5))
    low = low[np.argsort(low[:, 1])]
    assert low[0, 0] < -1.0 and low[-1, 0] > 5.0
    assert not has_holes(pattern)
    assert {p.name for p in draft(name).panels} == {p.name for p in pattern.panels if "strap" not in p.name}


def test_a_yoke_ends_at_the_bust_and_has_no_darts():
    smock, plain = draft("empire-dress", yoke=True), draft("empire-dress")
    lows = [
        p.panel("left_btorso").to_world(p.panel("left_btorso").outline(0.5))[:, 1].min()
        for p in (smock, plain)
    ]
    assert lows[0] > lows[1] + 4.0
    darts = [sum(one.first.panel == one.second.panel for one in p.stitches) for p in (smock, plain)]
    assert darts[0] == 0 < darts[1]


def test_the_back_of_a_skater_dress_may_be_cut_in():
    def reach(pattern) -> float:
        panel = pattern.panel("left_btorso")
        outline = panel.to_world(panel.outline(0.5))
        between = outline[(outline[:, 1] > 132.0) & (outline[:, 1] < 138.0) & (outline[:, 0] > 1.0)]
        return float(between[:, 0].min())

    assert reach(draft("skater-dress", racer=True)) < 8.0 < reach(draft("skater-dress"))
    assert draft("skater-dress", racer=True, sleeves=True) == draft("skater-dress", sleeves=True)


def test_a_straight_dress_is_open_behind():
    pattern = draft("shift-dress", back_slit=20.0, length=70)
    sewn = {side for stitch in pattern.stitches for side in stitch.sides}
    free = [EdgeRef("left_btorso", k) for k in range(len(pattern.panel("left_btorso").edges))]
    lengths = [pattern.edge_length(ref) for ref in free if ref not in sewn]
    assert any(length == pytest.approx(20.0, abs=0.05) for length in lengths)


@pytest.mark.parametrize("seam", [10.0, 24.0])
def test_a_low_waist_has_a_pleated_skirt(seam):
    pattern = draft("drop-waist-dress", pleats=5, seam=seam)
    pleats = [panel.name for panel in pattern.panels if panel.name.startswith("skirt_pleat_")]
    assert len(pleats) == 10 and not has_holes(pattern)


@pytest.mark.parametrize("name", ["wrap-dress", "wrap-skirt"])
def test_the_hem_of_the_lower_front_is_level_where_it_is_seen(name):
    pattern = draft(name)
    view = FrontView(pattern.panel("skirt_under_0_front"))
    edge = 16.0 if name == "wrap-dress" else 12.0
    low = [column[0] for x in (edge + 0.5, edge + 6.0) if (column := view.column(x)) is not None]
    hidden = view.column(float(view.outline[:, 0].min()) + 0.3)
    assert low[0] == pytest.approx(low[1], abs=0.8) and hidden is not None and hidden[0] > low[0] + 3.0
