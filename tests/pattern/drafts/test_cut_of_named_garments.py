"""What a tailor would measure on the garments that only drafts show."""

from __future__ import annotations

import numpy as np
import pytest
from test_cut import BODY, WAIST_Y, extent, labelled_length, seam_length

from swifttailor.describing import Claim
from swifttailor.describing.measuring import measure_facts
from swifttailor.pattern.drafts import draft, list_drafts
from swifttailor.pattern.drafts.draft_names import DRAFT_KINDS, DRAFT_NAMES


def test_every_draft_has_its_kind():
    assert tuple(sorted(DRAFT_NAMES)) == tuple(sorted(info.name for info in list_drafts()))
    assert {name: measure_facts(draft(name)).kind for name in DRAFT_NAMES} == dict(DRAFT_KINDS)


@pytest.mark.parametrize("pleats", [2, 5, 8])
@pytest.mark.parametrize("fraction", [0.0, 0.6, 1.0])
def test_laid_pleats_are_as_long_as_the_waistband(pleats, fraction):
    pattern = draft("pleated-skirt", pleats=pleats, depth=3.0, fraction=fraction)
    for part in ("front", "back"):
        band, skirt = seam_length(pattern, f"wb_{part}", f"skirt_{part}")
        assert skirt == pytest.approx(band, rel=1e-3)
        folds = [s for s in pattern.stitches if {side.panel for side in s.sides} == {f"skirt_{part}"}]
        assert len(folds) == pleats
    assert labelled_length(pattern, "lower_interface") == pytest.approx(BODY.waist)


@pytest.mark.parametrize("depth", [1.0, 4.0])
def test_pleats_fold_their_depth_away(depth):
    straight = draft("pleated-skirt", pleats=4, depth=depth, fraction=0.0)
    plain = draft("pleated-skirt", pleats=4, depth=depth + 2, fraction=0.0)
    hems = [measure_facts(p).hem for p in (straight, plain)]
    assert hems[0] and hems[1]
    assert hems[1].length - hems[0].length == pytest.approx(2 * 4 * 2.0, rel=0.05)


@pytest.mark.parametrize("width", [1.0, 1.5, 4.0])
@pytest.mark.parametrize("name", ["camisole", "slip-dress"])
def test_straps_are_as_wide_as_asked(name, width):
    assert seam_length(draft(name, strap_width=width), "left_ftorso", "left_btorso")[0] > 20
    pattern = draft(name, strap_width=width)
    panel = pattern.panel("left_ftorso")
    top = sorted(panel.to_world(panel.vertices).tolist(), key=lambda p: -p[1])[:2]
    assert abs(top[0][0] - top[1][0]) == pytest.approx(width)


@pytest.mark.parametrize("height", [2.0, 10.0, 14.0])
def test_a_turtleneck_s_collar_is_as_long_as_its_neckline_and_as_high_as_asked(height):
    pattern = draft("turtleneck", collar_height=height)
    for face in ("front", "back"):
        neck, collar = seam_length(pattern, f"left_{face[0]}torso", f"left_collar_{face}")
        assert collar == pytest.approx(neck, rel=1e-3)
    facts = measure_facts(pattern)
    assert facts.collar is not None and facts.collar.height == pytest.approx(height, abs=0.1)
    assert Claim("collar", "turtleneck").holds(facts) == (height > 4.0)


@pytest.mark.parametrize("name", ["jeans", "leggings"])
def test_slim_legs_are_slim_down_to_the_ankle(name):
    facts = measure_facts(draft(name))
    assert Claim("legs", "slim").holds(facts)
    assert Claim("leg_cuffs", "none").holds(facts)
    assert facts.trousers is not None
    assert facts.trousers.opening < 0.65 * facts.body.thigh_girth


def test_taper_narrows_the_hem_alone():
    wide, slim = (draft("jeans", taper=t) for t in (0.0, 6.0))
    openings = [t.opening for p in (wide, slim) if (t := measure_facts(p).trousers)]
    assert openings[0] - openings[1] == pytest.approx(6.0)


def test_robe_is_open_below_its_closed_front():
    pattern = draft("robe", front_slit=40.0)
    middle = [s for s in pattern.stitches if {x.panel for x in s.sides} == {"left_ftorso", "right_ftorso"}]
    low, high = extent(pattern, "left_ftorso")[:, 1]
    closed = sum(pattern.edge_length(s.first) for s in middle)
    assert 0 < closed < high - low - 40.0
    whole = draft("robe", front_slit=0.0)
    joined = [s for s in whole.stitches if {x.panel for x in s.sides} == {"left_ftorso", "right_ftorso"}]
    assert sum(whole.edge_length(s.first) for s in joined) == pytest.approx(closed + 40.0)


def test_hooded_coat_is_closed_as_far_as_is_asked_and_has_a_hood():
    def sewn(**options: float) -> float:
        pattern = draft("hooded-coat", **options)
        halves = {"left_ftorso", "right_ftorso"}
        return sum(
            pattern.edge_length(s.first) for s in pattern.stitches if {x.panel for x in s.sides} == halves
        )

    whole = sewn(opening=0.0)
    assert sewn(closed_to=-30.0) == pytest.approx(0.2 * whole, rel=0.05), "as much as a toggle would hold"
    assert sewn(closed_to=6.0) - sewn(closed_to=0.0) == pytest.approx(6.0, abs=0.2)
    assert sewn() < 0.5 * whole
    facts = measure_facts(draft("hooded-coat", hood_height=9.0)), measure_facts(draft("hooded-coat"))
    assert facts[0].hood and facts[1].hood
    assert facts[0].hood.height - facts[1].hood.height == pytest.approx(3.0, abs=0.5)


def test_swing_dress_widens_by_its_flare():
    narrow, wide = (measure_facts(draft("swing-dress", flare=f)).hem for f in (30.0, 90.0))
    assert narrow and wide
    assert wide.length - narrow.length == pytest.approx(60.0, rel=0.1)


def test_waistcoat_is_shaped_at_the_waist_and_pointed_in_front():
    pattern = draft("waistcoat", point=6.0)
    panel = pattern.panel("left_ftorso")
    outline = panel.to_world(panel.outline(0.01))
    assert outline[:, 1].min() < WAIST_Y - 10.0 - 5.0
    straight = draft("waistcoat", waist_shaping=0.0)
    sides = [max(seam_length(p, "left_ftorso", "left_btorso")) for p in (pattern, straight)]
    assert sides[0] > sides[1]
    np.testing.assert_allclose(*seam_length(pattern, "left_ftorso", "left_btorso"), rtol=1e-3)


def test_shirt_opens_below_its_last_button_and_can_be_closed():
    def slits(**options: float) -> float:
        pattern = draft("shirt", **options)
        stitched = {ref for stitch in pattern.stitches for ref in stitch.sides}
        panel = pattern.panel("left_ftorso")
        ends = [
            (k, panel.vertices[k], panel.vertices[(k + 1) % len(panel.vertices)])
            for k in range(len(panel.edges))
        ]
        free = [
            abs(b[1] - a[1])
            for k, a, b in ends
            if ("left_ftorso", k) not in stitched and abs(b[0] - a[0]) < 4.0
        ]
        return float(max(free, default=0.0))

    assert slits(hem_opening=0.0) < 5.0
    assert slits(hem_opening=14.0) == pytest.approx(14.0, abs=0.5)


def test_low_rises_begin_below_the_waist():
    tops = [measure_facts(draft("jeans", below_waist=b)).top_level for b in (0.0, 8.0)]
    assert tops[0] - tops[1] == pytest.approx(8.0, abs=4.0)
    assert not measure_facts(draft("leggings")).trousers.darts
