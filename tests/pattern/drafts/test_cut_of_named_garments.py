"""What a tailor would measure on the garments that only drafts show."""

from __future__ import annotations

import numpy as np
import pytest
from test_cut import BODY, WAIST_Y, extent, labelled_length, seam_length

from swifttailor.describing import Claim
from swifttailor.describing.measuring import measure_facts
from swifttailor.pattern.curve import Line
from swifttailor.pattern.drafts import draft, list_drafts
from swifttailor.pattern.drafts.draft_kinds import DRAFT_KINDS, DRAFT_NAMES


def test_every_draft_has_its_kind():
    assert tuple(sorted(DRAFT_NAMES)) == tuple(sorted(info.name for info in list_drafts()))
    assert {name: measure_facts(draft(name)).kind for name in DRAFT_NAMES} == dict(DRAFT_KINDS)


@pytest.mark.parametrize("strips", [2, 5, 8])
@pytest.mark.parametrize("flare", [20.0, 52.0, 120.0])
def test_strips_of_pleats_are_as_long_as_the_waistband(strips, flare):
    pattern = draft("pleated-skirt", strips=strips, depth=3.0, flare=flare)
    for part in ("front", "back"):
        sewn = [s for s in pattern.stitches if f"wb_{part}" in {side.panel for side in s.sides}]
        above = [s for s in sewn if any("pleat" in side.panel for side in s.sides)]
        assert len(above) == strips
        lengths = {round(pattern.edge_length(side), 3) for s in above for side in s.sides}
        assert max(lengths) - min(lengths) < 0.02
    assert sum("under" in p.name for p in pattern.panels) == 2 * (strips - 1)
    assert labelled_length(pattern, "lower_interface") == pytest.approx(BODY.waist)


@pytest.mark.parametrize("depth", [2.0, 4.0])
def test_pleats_fold_their_depth_away_twice(depth):
    pattern, deeper = (draft("pleated-skirt", strips=4, depth=d) for d in (depth, depth + 1.5))
    hems = [measure_facts(p).hem for p in (pattern, deeper)]
    assert hems[0] and hems[1]
    assert hems[1].length - hems[0].length == pytest.approx(2 * 3 * 2 * 1.5, rel=0.05)


def test_cloth_that_is_folded_away_stands_inside_the_strip_that_covers_it():
    pattern = draft("pleated-skirt")
    for part in ("front", "back"):
        for k in range(1, 6):
            over, under = f"skirt_pleat_{k - 1}_{part}", f"skirt_under_{k}_{part}"
            (fold,) = [s for s in pattern.stitches if {side.panel for side in s.sides} == {over, under}]
            seen, hidden = (next(x for x in fold.sides if x.panel == name) for name in (over, under))
            outward = pattern.panel(over).normal()
            depth = (place(pattern, seen) - place(pattern, hidden)) @ outward
            assert 0.1 < depth < 0.4 and fold.right_wrong


def test_legs_of_jumpsuits_may_be_gathered_into_cuffs():
    for name in ("jumpsuit", "strappy-jumpsuit"):
        plain, cuffed = draft(name), draft(name, leg_cuff=4, leg_ease=40, length=94)
        assert len(cuffed.panels) == len(plain.panels) + 4
        assert np.ptp(cuffed.panel("pant_l_cuff_f").vertices[:, 1]) == pytest.approx(4.0)


def test_flares_of_cloth_that_stretches_have_no_darts():
    facts = [measure_facts(draft("flares", stretch=s, flare=26, leg_ease=1.5)).trousers for s in (0, 8)]
    assert [f.darts > 0 for f in facts] == [True, False]


def test_briefs_have_no_legs_and_bare_more_of_them_where_asked():
    facts, high = measure_facts(draft("briefs")), measure_facts(draft("briefs", leg_height=10))
    assert facts.trousers.inseam < 5.0 and high.hem.left > facts.hem.left + 3.0


def test_inseams_of_roomy_shorts_are_straight():
    close, roomy = (draft("trousers", length=50, leg_ease=ease).panel("pant_f_l") for ease in (5, 18))
    curved = [sum(not isinstance(edge.curve, Line) for edge in panel.edges) for panel in (close, roomy)]
    assert curved[1] == curved[0] - 1


def place(pattern, side) -> np.ndarray:
    """Upper end of an edge before draping, cm."""
    panel = pattern.panel(side.panel)
    ends = panel.to_world(np.roll(panel.vertices, -side.edge, axis=0)[:2])
    return ends[ends[:, 1].argmax()]


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
    pattern = draft("turtleneck", collar_height=height, rolled=False)
    for face in ("front", "back"):
        neck, collar = seam_length(pattern, f"left_{face[0]}torso", f"left_collar_{face}")
        assert collar == pytest.approx(neck, rel=1e-3)
    facts = measure_facts(pattern)
    assert facts.collar is not None and facts.collar.height == pytest.approx(height, abs=0.1)
    # What would reach over the chin stands away from the neck.
    assert Claim("collar", "turtleneck").holds(facts) == (4.0 < height <= 10.0)


@pytest.mark.parametrize("name", ["turtleneck", "sweatshirt"])
@pytest.mark.parametrize("height", [3.0, 4.5])
def test_a_roll_neck_is_turned_down_over_its_stand(name, height):
    options = {"rolled": True} if name == "turtleneck" else {"collar": "rolled"}
    pattern = draft(name, collar_height=height, **options)
    for face in ("front", "back"):
        fold = seam_length(pattern, f"left_collar_{face}", f"left_collar_fall_{face}")
        assert fold[0] == pytest.approx(fold[1], rel=1e-9)
    facts = measure_facts(pattern)
    assert facts.collar is not None and facts.collar.kind == "stand"
    assert 2 * height - 1.5 < facts.collar.height < 2 * height
    joined = {frozenset(side.panel for side in s.sides) for s in pattern.stitches}
    assert {"left_collar_fall_front", "right_collar_fall_front"} in joined


@pytest.mark.parametrize("name", ["shirt", "polo-shirt", "denim-jacket", "shirt-dress"])
def test_a_shirt_collar_is_turned_down_over_a_stand_and_ends_in_points(name):
    pattern = draft(name, collar="shirt", collar_width=5.0)
    assert Claim("collar", "lapel").holds(measure_facts(pattern))
    joined = {frozenset(side.panel for side in s.sides) for s in pattern.stitches}
    assert frozenset({"left_collar_fall_front", "right_collar_fall_front"}) not in joined
    front, back = (extent(pattern, f"left_collar_fall_{face}") for face in ("front", "back"))
    assert front[0, 1] == pytest.approx(back[0, 1] - 3.0), "points hang lower"
    folded = [s for s in pattern.stitches if s.right_wrong]
    assert len(folded) == 4 and all("fall" in s.first.panel + s.second.panel for s in folded)


@pytest.mark.parametrize("name", ["dungarees", "pinafore", "apron"])
@pytest.mark.parametrize("strap", [2.0, 3.5, 6.0])
def test_a_bib_and_its_straps_are_sewn_to_the_waistband(name, strap):
    pattern = draft(name, strap_width=strap)
    for side in ("left", "right"):
        assert seam_length(pattern, f"{side}_btorso", "wb_back") == pytest.approx((strap, strap), rel=1e-3)
        bib, band = seam_length(pattern, f"{side}_ftorso", "wb_front")
        assert bib == pytest.approx(band, rel=1e-3) and bib > strap
    facts = measure_facts(pattern)
    assert Claim("sleeves", "none").holds(facts) and Claim("neckline", "square").holds(facts)


@pytest.mark.parametrize("name", ["dungarees", "pinafore"])
def test_without_a_bib_straps_alone_hold_the_waistband(name):
    pattern = draft(name, bib=False, strap_width=3.0)
    for side in ("left", "right"):
        for face, band in (("f", "wb_front"), ("b", "wb_back")):
            sewn = seam_length(pattern, f"{side}_{face}torso", band)
            assert sewn == pytest.approx((3.0, 3.0), rel=1e-3)
    joined = {frozenset(side.panel for side in s.sides) for s in pattern.stitches}
    assert frozenset({"left_ftorso", "right_ftorso"}) not in joined


def test_an_apron_without_a_bib_has_cloth_in_front_alone():
    assert {panel.name for panel in draft("apron", bib=False).panels} == {
        "wb_front",
        "wb_back",
        "skirt_front",
    }


@pytest.mark.parametrize("name", ["bodysuit", "swimsuit"])
def test_one_pieces_are_cut_out_over_the_legs(name):
    heights = [2.0, 8.0]
    low, high = (draft(name, leg_height=h) for h in heights)
    sides = [seam_length(p, "left_ftorso", "left_btorso")[0] for p in (low, high)]
    assert sides[0] - sides[1] == pytest.approx(heights[1] - heights[0], abs=1.0)
    assert Claim("leg_hem", "very short").holds(measure_facts(low))


@pytest.mark.parametrize("name", ["bodysuit", "swimsuit"])
def test_one_pieces_of_knitted_cloth_have_no_seam_at_the_waist(name):
    knit, woven = draft(name), draft(name, stretch=0.0)
    assert extent(knit, "left_ftorso")[0, 1] < 85.0 < extent(woven, "left_ftorso")[0, 1]
    facts = measure_facts(knit)
    assert Claim("kind", "playsuit").holds(facts) and Claim("bodice", "undarted").holds(facts)
    assert facts.hem is not None and facts.hem.level < facts.body.waist
    assert Claim("bodice", "darted").holds(measure_facts(woven))


@pytest.mark.parametrize("length", [0.0, 55.0, 90.0])
@pytest.mark.parametrize("hood", [False, True])
def test_a_cape_covers_the_arms_and_opens_in_front(length, hood):
    pattern = draft("cape", length=length, hood=hood, closed=6.0)
    front = extent(pattern, "left_ftorso")
    assert front[0, 1] == pytest.approx(WAIST_Y - length, abs=1.0)
    assert front[1, 0] > 30.0, "wider than the shoulders"
    assert seam_length(pattern, "left_ftorso", "right_ftorso")[0] == pytest.approx(6.0, abs=0.5)
    assert Claim("hood", "hood").holds(measure_facts(pattern)) == hood


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
    assert sewn() < 0.8 * whole
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
    darts = [
        sum(s.first.panel == s.second.panel == "left_ftorso" for s in p.stitches) for p in (pattern, straight)
    ]
    assert darts[0] > darts[1] == 0, "darts take it in at the waist"
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


@pytest.mark.parametrize("height", [2.0, 4.0])
def test_stands_lean_to_the_neck(height):
    panel = draft("turtleneck", collar_height=height, rolled=False).panel("left_collar_back")
    upper, lower = sorted(panel.edge_length(k) for k in range(len(panel.edges)))[-2:]
    assert 0.5 < lower - upper < 1.4, "necks narrow by a few centimetres, and no more"


def test_short_tops_are_longer_in_front_where_the_bust_lifts_them():
    def longer_in_front(length: float) -> float:
        front, back = (
            float(pattern.panel(name).to_world(pattern.panel(name).vertices)[:, 1].min())
            for pattern in [draft("t-shirt", length=length)]
            for name in ("left_ftorso", "left_btorso")
        )
        return back - front

    assert longer_in_front(2.0) > longer_in_front(20.0) + 1.0


def test_backs_of_jumpers_are_cut_lower_at_the_neck_without_a_collar():
    middles = []
    for collar in ("none", "standing"):
        corners = draft("sweatshirt", collar=collar).panel("left_btorso").vertices
        middles.append(max(y for x, y in corners if abs(x) < 1e-6))
    assert middles[0] == pytest.approx(middles[1] - 1.8, abs=0.2)


@pytest.mark.parametrize("collar", ["shirt", "standing", "rolled"])
def test_necklines_of_collars_that_stand_are_closer_than_the_neck_is_wide(collar):
    panel = draft("shirt", collar=collar).panel("left_ftorso")
    corners = panel.to_world(panel.vertices)
    highest = corners[corners[:, 1].argmax()]
    assert BODY.neck_w / 2 - 0.3 < highest[0] < BODY.neck_w / 2 + 0.3


def test_a_kilt_is_flat_in_front_and_pleated_behind():
    names = {panel.name for panel in draft("pleated-skirt", strips=8, apron=True).panels}
    assert "skirt_pleat_0_front" in names and not any("under" in n and "front" in n for n in names)
    assert sum(n.startswith("skirt_pleat") and n.endswith("back") for n in names) == 8
