"""Fronts that seem to cross or do overlap, folded collars, fuller halters."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.spatial import KDTree
from test_cut import BODY, WAIST_Y, extent, seam_length

from swifttailor.body import Body
from swifttailor.describing import Claim
from swifttailor.describing.differences import Gain
from swifttailor.describing.measuring import measure_facts
from swifttailor.draping.drape import drape
from swifttailor.garment_sewer import GarmentSewer
from swifttailor.garment_sewer.layers import overlapping_vertices
from swifttailor.garment_sewer.relaxing import _crossings, relaxed
from swifttailor.pattern import EdgeRef, Pattern
from swifttailor.pattern.drafts import draft
from swifttailor.recutting import alter
from swifttailor.recutting.holes import has_holes


@pytest.fixture(scope="module")
def sewer():
    return GarmentSewer.load()


WRAPS = ("wrap-dress", "wrap-top", "wrap-jumpsuit")
COLLARED = {"polo-shirt": {"collar": "folded"}, "shirt": {"collar": "flat"}}
WOUND = ("wrap-skirt", "sarong")


def crossing(pattern: Pattern) -> np.ndarray:
    """(n, 3) points of the seam between the fronts, from the neckline down, cm."""
    (stitch,) = [s for s in pattern.stitches if {r.panel for r in s.sides} == {"left_ftorso", "right_ftorso"}]
    panel = pattern.panel(stitch.first.panel)
    points = panel.to_world(panel.sample_edge(stitch.first.edge, 50))
    return points if points[0, 1] > points[-1, 1] else points[::-1]


@pytest.mark.parametrize("name", WRAPS)
@pytest.mark.parametrize("depth", [16.0, 22.0, 28.0])
def test_fronts_cross_in_the_middle_and_the_right_edge_runs_on_to_the_left_side(name, depth):
    pattern = draft(name, neck_depth=depth)
    points = crossing(pattern)
    assert abs(points[0, 0]) < 1e-6 and points[-1, 0] == pytest.approx(
        extent(pattern, "left_ftorso")[1, 0], abs=3.0
    )
    assert points[-1, 1] == pytest.approx(WAIST_Y, abs=1.0)
    assert (np.diff(points[:, 0]) > 0).all() and (np.diff(points[:, 1]) < 0).all()
    facts = measure_facts(pattern)
    assert Claim("neckline", "v").holds(facts)
    assert facts.front_neck.left.depth == pytest.approx(facts.front_neck.right.depth)


@pytest.mark.parametrize("name", WRAPS)
def test_the_crossing_carries_the_line_of_the_neckline_on(name):
    pattern = draft(name)
    seam = crossing(pattern)
    panel = pattern.panel("right_ftorso")
    (edge,) = [k for k, e in enumerate(panel.edges) if e.label == "right_collar"]
    neck = panel.to_world(panel.sample_edge(edge, 50))
    neck = neck if neck[0, 1] < neck[-1, 1] else neck[::-1]
    arriving, leaving = neck[0] - neck[1], seam[1] - seam[0]
    angle = np.degrees(np.arccos(arriving @ leaving / np.linalg.norm(arriving) / np.linalg.norm(leaving)))
    assert angle < 25.0


@pytest.mark.parametrize("name", WRAPS)
@pytest.mark.parametrize("ease", [1.0, 5.0, 12.0])
def test_crossed_fronts_are_measured_like_others(name, ease):
    option = "chest_ease" if name == "wrap-top" else "bust_ease"
    facts = measure_facts(draft(name, **{option: ease}))
    assert facts.torso.chest_ease == pytest.approx(ease, abs=1.5)


@pytest.mark.parametrize("hem", ["cropped", "waist", "hip", "long"])
def test_a_wrap_top_is_cut_to_any_length(hem):
    cut = alter(draft("wrap-top"), [Gain(Claim("top_hem", hem))])
    assert cut.open == () and not has_holes(cut.pattern)


@pytest.mark.parametrize("name", WRAPS)
def test_wraps_lose_their_sleeves_by_option_and_by_the_knife(name):
    assert Claim("sleeves", "none").holds(measure_facts(draft(name, sleeves=False)))
    cut = alter(draft(name), [Gain(Claim("sleeves", "none"))])
    assert cut.open == () and not has_holes(cut.pattern)


@pytest.mark.parametrize("name", COLLARED)
def test_a_folded_collar_is_as_long_as_the_neckline_and_lies_on_the_torso(name):
    pattern = draft(name, **COLLARED[name])
    for face, torso in (("front", "left_ftorso"), ("back", "left_btorso")):
        collar, neck = seam_length(pattern, f"left_collar_{face}", torso)
        assert collar == pytest.approx(neck, rel=1e-9)
        box, below = extent(pattern, f"left_collar_{face}"), extent(pattern, torso)
        assert box[1, 1] <= below[1, 1] + 1e-6, "it hangs down from the neckline"
        assert abs(box[0, 2]) > abs(below[0, 2]), "outside"
    folded = [s for s in pattern.stitches if s.right_wrong]
    assert len(folded) == 4 and all({"collar", "torso"} <= parts(s) for s in folded)
    assert Claim("collar", "lapel").holds(measure_facts(pattern)) and not has_holes(pattern)


def parts(stitch) -> set[str]:
    return {word for side in stitch.sides for word in ("collar", "torso") if word in side.panel}


@pytest.mark.parametrize("width", [4.0, 7.5, 11.0])
@pytest.mark.parametrize("lapels", ["notched", "shawl"])
def test_lapels_are_as_wide_as_asked(width, lapels):
    panel = draft("blazer", lapels=lapels, lapel_width=width).panel("left_collar_fall_front")
    outline = panel.outline(0.01)
    foot = outline[np.argmin(outline[:, 1])]
    ends = panel.chord(max(range(len(panel.edges)), key=panel.edge_length))  # the fold, which is straight
    along = (ends[1] - ends[0]) / np.linalg.norm(ends[1] - ends[0]) * np.sign(ends[1, 1] - ends[0, 1])
    away = outline - foot
    lower = away[away @ along < 0.7 * panel.edge_length(max(range(len(panel.edges)), key=panel.edge_length))]
    assert abs(lower @ [along[1], -along[0]]).max() == pytest.approx(width, abs=0.5)


@pytest.mark.parametrize("name", ["blazer", "coat"])
@pytest.mark.parametrize("lapels", ["notched", "shawl"])
def test_collars_with_lapels_stand_behind_and_are_turned_down_over_it(name, lapels):
    pattern = draft(name, lapels=lapels)
    for face, torso in (("front", "left_ftorso"), ("back", "left_btorso")):
        stand, neck = seam_length(pattern, f"left_collar_{face}", torso)
        assert stand == pytest.approx(neck, rel=1e-9)
        fold, fall = seam_length(pattern, f"left_collar_{face}", f"left_collar_fall_{face}")
        assert fold == pytest.approx(fall, rel=1e-9)
    assert all("fall" in str(s.sides) for s in pattern.stitches if s.right_wrong)
    stand, fall = (np.ptp(extent(pattern, f"left_collar{part}_back")[:, 1]) for part in ("", "_fall"))
    assert fall > stand + 2.0, "the seam at the neck is covered"
    assert Claim("collar", "lapel").holds(measure_facts(pattern)) and not has_holes(pattern)


@pytest.mark.parametrize("name", ["shirt", "shirt-dress"])
def test_small_lapels_and_hoods_are_sewn_to_shirts(name):
    lapels, hood = (measure_facts(draft(name, collar=collar)) for collar in ("revers", "hood"))
    assert lapels.collar.kind == "lapel" and lapels.hood is None
    assert hood.collar is None and hood.hood is not None


def test_ponchos_may_have_a_hood():
    assert measure_facts(draft("poncho", hood=True)).hood is not None
    assert measure_facts(draft("poncho")).hood is None


def free_edge(pattern: Pattern, name: str) -> np.ndarray:
    """(2, 2) upper and lower end, world x and y, of the lowest edge that rises and is sewn to nothing."""
    panel = pattern.panel(name)
    sewn = {side for s in pattern.stitches for side in s.sides}
    chords = [panel.to_world(panel.chord(k)) for k in range(len(panel.edges)) if EdgeRef(name, k) not in sewn]
    edge = min((c for c in chords if abs(np.diff(c[:, 1])[0]) > 5.0), key=lambda c: c[:, 1].min())
    return edge[np.argsort(-edge[:, 1])][:, :2]


@pytest.mark.parametrize("name", WOUND)
@settings(max_examples=20, deadline=None)
@given(aside=st.floats(4, 16), edge=st.floats(-20, 20), under=st.floats(6, 24))
def test_wound_skirts_overlap_as_far_as_asked(name, aside, edge, under):
    options = {"overlap_aside": aside, "overlap_edge": edge, "overlap_under": under}
    pattern = draft(name, **options, length=62)
    upper, lower = (free_edge(pattern, n) for n in ("skirt_front", "skirt_under_0_front"))
    assert np.allclose(upper[0], lower[0]), "they meet at the waist"
    assert upper[0][0] == pytest.approx(aside, abs=0.01)
    assert upper[1][0] == pytest.approx(edge, abs=0.3)
    reach = upper[1][0] - lower[1][0]
    assert reach == pytest.approx(under, abs=0.5) or lower[1][0] < -15.0  # where the front ends
    assert 3.0 < lower[1][1] - upper[1][1] < 7.0, "the free corner, which sinks, is not seen"
    assert not has_holes(pattern)
    assert {slit.place for slit in measure_facts(pattern).skirt.slits} <= {"front", "left"}


@pytest.mark.parametrize("name", ["coat", "robe", "hooded-coat"])
def test_fronts_of_coats_overlap_or_part(name):
    for opening, parts in ((-14.0, False), (8.0, True)):
        pattern = draft(name, opening=opening)
        right, left = (free_edge(pattern, f"{side}_ftorso") for side in ("right", "left"))
        assert np.allclose(right[0], left[0]) and right[0][0] == pytest.approx(0.0, abs=1e-6)
        apart = left[1][0] - right[1][0]
        assert apart == pytest.approx(2 * opening if parts else opening, abs=1e-6)
        assert (right[1][0] > 0.0) != parts, "the right one lies over the left one"


@pytest.mark.parametrize("name", ["blazer", "hooded-coat", "cardigan"])
def test_fronts_meet_below_the_last_button(name):
    pattern = draft(name)
    right, left = (free_edge(pattern, f"{side}_ftorso") for side in ("right", "left"))
    assert 0.0 < left[1][0] - right[1][0] < 3.0


@pytest.mark.parametrize("name", ["wrap-skirt", "wrap-dress", "coat"])
def test_the_upper_front_lies_on_the_lower_one(sewer, name):
    prepared = sewer.prepare(draft(name, **({"opening": -16.0, "closed_to": 4.0} if name == "coat" else {})))
    (values,) = sewer.predict([prepared])
    garment = relaxed(sewer.decode(prepared, values))
    assert "not_relaxed" not in garment.report
    mesh, body = garment.mesh, Body.default()
    ((upper, lower),) = overlapping_vertices(mesh)
    distance, _ = body.signed_distance(garment.vertices)
    beneath = KDTree(garment.vertices[lower, :2])
    near, index = beneath.query(garment.vertices[upper, :2])
    over = near < 1.5
    assert over.sum() > 20
    above = distance[upper][over] - distance[lower][index[over]]
    assert np.quantile(above, 0.05) > -0.5  # cm
    assert _crossings(mesh, garment.vertices) < 0.01 * len(mesh.faces)


@pytest.mark.parametrize("fraction", [0.3, 0.5, 1.0])
def test_a_halter_dress_has_a_waist_and_a_skirt_from_a_circle(fraction):
    facts = measure_facts(draft("halter-dress", skirt_fraction=fraction))
    assert facts.skirt.circle == pytest.approx(fraction, rel=0.02)
    assert facts.torso.lower_edge == pytest.approx(BODY.waist + 2.0)
    assert facts.torso.darts == 6
    assert measure_facts(draft("halter-dress", waist_seam=False)).skirt is None


def test_the_back_of_a_halter_hangs_as_level_as_its_front():
    for name in ("halter-top", "halter-dress"):
        hem = measure_facts(draft(name)).hem
        assert hem.back == pytest.approx(hem.front, abs=3.0)


@pytest.mark.parametrize("skirt", ["circle", "a-line", "straight", "pencil"])
def test_a_halter_dress_is_given_other_skirts(skirt):
    cut = alter(draft("halter-dress"), [Gain(Claim("skirt", skirt))])
    assert cut.open == () and not has_holes(cut.pattern)


@pytest.mark.parametrize("name", ["wrap-skirt", "robe"])
def test_the_upper_front_comes_to_lie_above_in_a_drape(name):
    garment = drape(draft(name), edge_length=3.0)
    ((upper, lower),) = overlapping_vertices(garment.mesh)
    over, under = garment.vertices[upper], garment.vertices[lower]
    near, index = KDTree(under[:, :2]).query(over[:, :2])
    lies = near < 2.0
    assert lies.sum() > 20
    assert (over[lies, 2] > under[index[lies], 2]).mean() > 0.9
