"""Fronts that seem to cross, folded collars, skirts that are open beside the middle, fuller halters."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from test_cut import BODY, WAIST_Y, extent, seam_length

from swifttailor.describing import Claim
from swifttailor.describing.differences import Gain
from swifttailor.describing.measuring import measure_facts
from swifttailor.pattern import EdgeRef, Pattern
from swifttailor.pattern.drafts import draft
from swifttailor.recutting import alter
from swifttailor.recutting.holes import has_holes

WRAPS = ("wrap-dress", "wrap-top")
COLLARED = {"polo-shirt": {"collar": "folded"}, "shirt": {"collar": "flat"}, "blazer": {}}
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
    option = "bust_ease" if name == "wrap-dress" else "chest_ease"
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
    panel = draft("blazer", lapels=lapels, lapel_width=width).panel("left_collar_front")
    outline = panel.outline(0.01)
    top = outline[np.argmax(outline[:, 1])]
    foot = outline[np.argmin(outline[:, 1])]
    # The neckline is the way between these two that lies nearer to the middle.
    inner = np.array([foot, top])
    lowest = outline[outline[:, 1] < foot[1] + 0.7 * (top[1] - foot[1])]
    beside = lowest[:, 0] - np.interp(lowest[:, 1], inner[:, 1], inner[:, 0])
    assert beside.max() == pytest.approx(width, abs=1.5)


def opening(pattern: Pattern) -> list[int]:
    """The two edges of the front that are sewn to nothing and rise."""
    panel = pattern.panel("skirt_front")
    sewn = {side for s in pattern.stitches for side in s.sides}
    free = [k for k in range(len(panel.edges)) if EdgeRef("skirt_front", k) not in sewn]
    return [k for k in free if abs(np.diff(panel.to_world(panel.chord(k))[:, 1])[0]) > 5.0]


@pytest.mark.parametrize("name", WOUND)
@settings(max_examples=20, deadline=None)
@given(height=st.floats(12, 36), width=st.floats(2, 20), aside=st.floats(0, 14))
def test_wound_skirts_are_open_as_far_as_asked(name, height, width, aside):
    pattern = draft(name, opening_height=height, opening_width=width, opening_aside=aside)
    panel = pattern.panel("skirt_front")
    first, second = (panel.to_world(panel.chord(k)) for k in opening(pattern))
    top = max(first[:, 1].max(), second[:, 1].max())
    lower = [chord[np.argmin(chord[:, 1])] for chord in (first, second)]
    assert top - min(p[1] for p in lower) == pytest.approx(height, abs=1.0)
    assert abs(lower[0][0] - lower[1][0]) == pytest.approx(width, abs=0.3)
    assert not has_holes(pattern)
    if width > 0.7 * height:  # a hem that rises, rather than a slit
        return
    facts = measure_facts(pattern)
    assert [slit.place in ("front", "left") for slit in facts.skirt.slits] == [True]


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
