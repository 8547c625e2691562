"""Raglan sleeves, sleeves cut in one with the body, and dropped shoulders, as a cutter would check them."""

from __future__ import annotations

import numpy as np
import pytest
from test_cut import seam_length

from swifttailor.describing.measuring import measure_facts
from swifttailor.pattern import EdgeRef
from swifttailor.pattern.check import check_pattern
from swifttailor.pattern.drafts import DraftMeasurements, draft
from swifttailor.pattern.drafts.figure import Figure

FIGURE = Figure.of(DraftMeasurements())
RAGLAN = (
    "t-shirt",
    "shirt",
    "turtleneck",
    "cardigan",
    "sweatshirt",
    "hoodie",
    "bomber-jacket",
    "coat",
    "hooded-coat",
    "shift-dress",
)
IN_ONE = ("t-shirt", "turtleneck", "cardigan", "sweatshirt", "coat", "shift-dress")
SLEEVED = {"shift-dress": {"sleeves": True, "sleeve_length": 45.0}}


def drafted(name, **options):
    return draft(name, **SLEEVED.get(name, {}), **options)


def neckline(pattern):
    """Length of all that borders the opening at the neck, or is sewn to a collar or hood there."""
    at_neck = {"left_collar", "right_collar"}
    return sum(
        pattern.edge_length(EdgeRef(panel.name, k))
        for panel in pattern.panels
        for k, edge in enumerate(panel.edges)
        if edge.label in at_neck
    )


@pytest.mark.parametrize("name", RAGLAN)
def test_raglan_seams_run_from_the_underarm_to_the_neckline(name):
    set_in, raglan = drafted(name), drafted(name, armhole="raglan")
    assert [p.name for p in raglan.panels] == [p.name for p in set_in.panels]
    for face in "fb":
        torso, sleeve = seam_length(raglan, f"left_{face}torso", f"left_sleeve_{face}")
        assert torso == pytest.approx(sleeve, rel=1e-3)
        panel = raglan.panel(f"left_{face}torso")
        seams = [
            s for s in raglan.stitches if {r.panel for r in s.sides} == {panel.name, f"left_sleeve_{face}"}
        ]
        ends = {
            tuple(np.round(point, 3))
            for stitch in seams
            for ref in stitch.sides
            if ref.panel == panel.name
            for point in panel.to_world(panel.chord(ref.edge))
        }
        low, high = min(ends, key=lambda p: p[1]), max(ends, key=lambda p: p[1])
        assert high[1] - low[1] > 15.0 and abs(high[0]) < FIGURE.shoulder_x - 4.0, "it ends beside the neck"
    assert not any(
        abs(np.ptp(panel.to_world(panel.chord(ref.edge))[:, 0])) > 3.0
        for stitch in raglan.stitches
        if {r.panel for r in stitch.sides} == {"left_ftorso", "left_btorso"}
        for ref in stitch.sides[:1]
        for panel in [raglan.panel(ref.panel)]
        if panel.to_world(panel.chord(ref.edge))[:, 1].min() > FIGURE.armpit_y
    ), "no shoulder is left on the torso"


@pytest.mark.parametrize("name", RAGLAN)
def test_the_neckline_stays_as_long_and_what_is_sewn_to_it_goes_around_all_of_it(name):
    set_in, raglan = drafted(name), drafted(name, armhole="raglan")
    assert neckline(raglan) == pytest.approx(neckline(set_in), rel=1e-4)
    worn = [p.name for p in set_in.panels if "collar" in p.name or "hood" in p.name]
    if worn:
        sewn = [
            sum(
                pattern.edge_length(ref)
                for stitch in pattern.stitches
                for ref, other in (stitch.sides, stitch.sides[::-1])
                if ref.panel in worn and ("torso" in other.panel or "sleeve" in other.panel)
            )
            for pattern in (set_in, raglan)
        ]
        assert sewn[0] > 30.0 and sewn[1] == pytest.approx(sewn[0], rel=1e-4)


@pytest.mark.parametrize("ease", [6.0, 8.0, 10.0])
def test_raglan_sleeves_are_as_wide_and_long_as_asked(ease):
    sleeve = measure_facts(draft("t-shirt", armhole="raglan", sleeve_length=58.0, arm_ease=ease)).left_sleeve
    assert sleeve.upper_width == pytest.approx(FIGURE.upper_arm + ease, abs=2.0)
    assert sleeve.length == pytest.approx(58.0, abs=1.0)
    assert sleeve.head_gather == pytest.approx(1.0, abs=1e-3)


@pytest.mark.parametrize("name", IN_ONE)
def test_sleeves_cut_in_one_are_part_of_front_and_back(name):
    pattern = drafted(name, armhole="cut-in-one")
    assert not any("sleeve" in p.name for p in pattern.panels)
    front, back = seam_length(pattern, "left_ftorso", "left_btorso")
    set_in, _ = seam_length(drafted(name), "left_ftorso", "left_btorso")
    assert front == pytest.approx(back, rel=1e-3) and front > set_in + 8.0
    reach = max(float(np.abs(p.to_world(p.vertices)[:, 0]).max()) for p in pattern.panels)
    assert reach > FIGURE.shoulder_x + 10.0
    assert not [f for f in check_pattern(pattern) if f.severity.value == "error"]


@pytest.mark.parametrize(("length", "end"), [(20.0, 36.0), (34.0, 32.0), (46.0, 28.0), (60.0, 24.0)])
def test_sleeves_cut_in_one_are_as_long_and_wide_at_the_end_as_asked(length, end):
    facts = measure_facts(draft("t-shirt", armhole="cut-in-one", sleeve_length=length, sleeve_end=end))
    for sleeve in (facts.left_sleeve, facts.right_sleeve):
        assert sleeve.length == pytest.approx(length, abs=1.5)
        assert sleeve.end_width == pytest.approx(end, abs=2.0)


def test_cuffs_end_sleeves_that_are_cut_in_one():
    pattern = draft("sweatshirt", armhole="cut-in-one", wing=20.0)
    sleeve = measure_facts(pattern).left_sleeve
    assert sleeve.cuff is not None and sleeve.cuff.kind == "band"
    assert sleeve.length == pytest.approx(58.0, abs=1.5) and sleeve.end_gather > 1.1


@pytest.mark.parametrize("wing", [16.0, 20.0, 24.0])
def test_deeper_wings_leave_less_of_the_side(wing):
    sides = [
        max(
            pattern.edge_length(ref)
            for stitch in pattern.stitches
            if {r.panel for r in stitch.sides} == {"left_ftorso", "left_btorso"}
            for ref in stitch.sides[:1]
            for panel in [pattern.panel(ref.panel)]
            if np.ptp(panel.to_world(panel.chord(ref.edge))[:, 0]) < 4.0
        )
        for pattern in (
            draft("t-shirt", armhole="cut-in-one", sleeve_length=56.0, sleeve_end=24.0, wing=each)
            for each in (wing, wing + 4.0)
        )
    ]
    assert sides[0] - sides[1] == pytest.approx(4.0, abs=0.1)


@pytest.mark.parametrize("name", ["t-shirt", "sweatshirt", "coat", "hooded-coat", "shift-dress", "robe"])
def test_dropped_shoulders_lie_on_the_upper_arm_and_sleeves_end_where_they_did(name):
    room = {} if name == "robe" else {"chest_ease": 26.0}
    usual, dropped = (drafted(name, shoulder_extension=e, **room) for e in (0.0, 8.0))
    tips = []
    for pattern in (usual, dropped):
        panel = pattern.panel("left_ftorso")
        labelled = [k for k, edge in enumerate(panel.edges) if edge.label == "left_armhole"]
        points = np.concatenate([panel.to_world(panel.chord(k)) for k in labelled])
        tips.append(points[points[:, 1].argmax()])
    assert tips[1][0] - tips[0][0] == pytest.approx(8.0, abs=1.0) and tips[1][1] < tips[0][1] - 2.0
    lengths = [measure_facts(pattern).left_sleeve.length for pattern in (usual, dropped)]
    assert lengths[0] == pytest.approx(lengths[1], abs=1.0)


def test_a_shoulder_never_reaches_beyond_the_side():
    for ease in (2.0, 8.0, 20.0):
        pattern = draft("t-shirt", chest_ease=ease, shoulder_extension=10.0)
        panel = pattern.panel("left_ftorso")
        armhole = [k for k, edge in enumerate(panel.edges) if edge.label == "left_armhole"]
        low, high = sorted((tuple(p) for k in armhole for p in panel.chord(k)), key=lambda p: p[1])[
            :: len(armhole) * 2 - 1
        ]
        assert high[0] <= low[0] + 1e-6
