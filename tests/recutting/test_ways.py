"""Recutting: seams still fit, measures change by what was asked, and what can be undone is undone."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from swifttailor.describing import measure_facts
from swifttailor.describing.measuring.anatomy import Border
from swifttailor.describing.measuring.parts import Part
from swifttailor.pattern import Edge, EdgeRef, Panel, Pattern, Placement, Quadratic, Severity, check_pattern
from swifttailor.pattern import curve as curves
from swifttailor.pattern.drafts import draft
from swifttailor.recutting.amounts.cuts import cuff_name
from swifttailor.recutting.table.cutter import Cutter
from swifttailor.recutting.table.workbench import Workbench
from swifttailor.recutting.ways.bands import BandPlan, add_band
from swifttailor.recutting.ways.ends import move_ends, swing_sides
from swifttailor.recutting.ways.fullness import widen_panels
from swifttailor.recutting.ways.necklines import recut_neckline
from swifttailor.recutting.ways.removal import remove_panels
from swifttailor.recutting.ways.slits import open_side

FEW = settings(max_examples=12, deadline=None)
WITH_HEM = [
    "t-shirt",
    "tank-top",
    "fitted-dress",
    "shirt-dress",
    "fitted-skirt",
    "circle-skirt",
    "gathered-skirt",
]


def ratios(pattern: Pattern) -> dict[frozenset[EdgeRef], float]:
    found = {}
    for s in pattern.stitches:
        a, b = (pattern.edge_length(r) for r in sorted(s.sides))
        found[frozenset(s.sides)] = a / b
    return found


def assert_sound(pattern: Pattern) -> None:
    faults = [f for f in check_pattern(pattern) if f.severity is not Severity.INFO]
    assert not faults, faults
    used = [r for s in pattern.stitches for r in s.sides]
    assert len(used) == len(set(used)) and len(pattern.components()) == 1


def same_panels(one: Pattern, other: Pattern, tolerance: float = 1e-6) -> None:
    a, b = one.canonical(), other.canonical()
    assert [p.name for p in a.panels] == [p.name for p in b.panels]
    assert a.stitches == b.stitches
    for p, q in zip(a.panels, b.panels, strict=True):
        np.testing.assert_allclose(p.to_world(p.outline(0.05)), q.to_world(q.outline(0.05)), atol=tolerance)


def test_the_bench_gives_back_what_was_laid_on_it(drafts, few_real_patterns):
    for pattern in (*drafts.values(), *few_real_patterns.values()):
        assert Workbench(pattern).pattern() == pattern.canonical()


@pytest.mark.parametrize("name", WITH_HEM)
@given(st.floats(2, 22), st.booleans())
@FEW
def test_hems_move_by_the_distance(name, size, longer):
    pattern = draft(name)
    distance = size if longer else -size
    edited = move_ends(pattern, Cutter(pattern).hem, distance)
    before, after = measure_facts(pattern), measure_facts(edited)
    # Slanted and rounded sides run a little obliquely.
    assert before.hem.level - after.hem.level == pytest.approx(distance, abs=0.6 + 0.05 * size)
    assert len(edited.panels) == len(pattern.panels) and len(edited.stitches) == len(pattern.stitches)
    assert_sound(edited)
    for seam, ratio in ratios(edited).items():
        assert ratio == pytest.approx(ratios(pattern)[seam], rel=1e-6)


@pytest.mark.parametrize("name", WITH_HEM)
def test_lengthening_undoes_shortening(name):
    """Exactly where side seams are straight; circle skirts grow as circles."""
    pattern = draft(name)
    longer = move_ends(pattern, Cutter(pattern).hem, 12.0)
    same_panels(move_ends(longer, Cutter(longer).hem, -12.0), pattern)


def trumpet(name: str, z: float) -> Panel:
    """A skirt panel, 60 cm long, whose sides turn outward at the hem."""
    corners = [[-35, 0], [35, 0], [22, 60], [-22, 60]]
    left, right = (Edge(Quadratic((at, 0.3))) for at in (0.7, 0.3))
    return Panel(name, corners, (Edge(), right, Edge(), left), Placement((0.0, 20.0, z)))


def test_sides_that_turn_outward_are_drawn_on_down_the_skirt():
    """Drawn on as they end, they would run to the side for as far as the skirt gets longer."""
    pattern = Pattern((trumpet("front", 25.0),))
    tangent = curves.derivative(pattern.panels[0].edges[1].curve, pattern.panels[0].chord(1), [0.0])[0]
    assert abs(tangent[0]) > abs(tangent[1])
    for distance in (4.0, 50.0):
        edited = move_ends(pattern, [EdgeRef("front", 0)], distance)
        (low, high) = np.sort(edited.panels[0].vertices[:, 1])[[0, -1]]
        wide = np.ptp(edited.panels[0].vertices[:, 0]) - 70.0
        assert high == 60.0
        if distance < 5:
            assert wide / 2 > -low  # a little: as it ends
        else:
            assert -low > 40.0 and wide / 2 < 30.0


@pytest.mark.parametrize("distance", [3.0, -2.0, -8.0])
def test_a_hem_with_a_step_is_left_alone_where_the_step_leads_to_both_its_parts(distance):
    """The step between the two levels is a side of both; a cut above it would need it twice."""
    corners = [[0, 0], [20, 0], [20, 5], [40, 5], [40, 30], [0, 30]]
    pattern = Pattern((Panel("flag", corners, (Edge(),) * 6),))
    hem = [EdgeRef("flag", 0), EdgeRef("flag", 2)]
    edited = move_ends(pattern, hem, distance)
    if distance < 0:
        assert edited is None
    else:
        assert {(e.severity, e.code) for e in check_pattern(edited)} == {
            (e.severity, e.code) for e in check_pattern(pattern)
        }


@given(st.floats(0.3, 1.5), st.floats(5, 25))
@FEW
def test_a_lengthened_circle_skirt_is_the_longer_circle_skirt(fraction, more):
    short, long = (draft("circle-skirt", fraction=fraction, length=x) for x in (50.0, 50.0 + more))
    edited = move_ends(short, Cutter(short).hem, more)
    for panel in edited.panels:
        assert panel.perimeter() == pytest.approx(long.panel(panel.name).perimeter(), rel=1e-6)
        assert abs(panel.signed_area()) == pytest.approx(abs(long.panel(panel.name).signed_area()), rel=1e-6)


@pytest.mark.parametrize("name", ["fitted-skirt", "fitted-dress", "trousers", "tank-top"])
@given(st.floats(-4, 8).filter(lambda w: abs(w) > 0.5))
@FEW
def test_swinging_sides_changes_the_hem_and_no_seam(name, width):
    pattern = draft(name)
    edited = swing_sides(pattern, Cutter(pattern).hem, width)
    before, after = measure_facts(pattern), measure_facts(edited)
    # Each end of each hem moves by the width, less what the turn takes off.
    assert np.sign(after.hem.length - before.hem.length) == np.sign(width)
    assert abs(after.hem.length - before.hem.length) > 2.5 * abs(width)
    for seam, ratio in ratios(edited).items():
        assert ratio == pytest.approx(ratios(pattern)[seam], rel=1e-9)
    assert_sound(edited)


def test_cuffs_move_with_the_sleeve():
    pattern = draft("hoodie")
    cutter = Cutter(pattern)
    ends = cutter.anatomy.seam(Part.SLEEVE, Part.CUFF).own
    left = [r for r in ends if r.panel.startswith("left")]
    cuffs = [p.name for p in cutter.anatomy.panels(Part.CUFF, "left")]
    edited = move_ends(pattern, left, -8.0, cuffs)
    before, after = measure_facts(pattern), measure_facts(edited)
    assert before.left_sleeve.length - after.left_sleeve.length == pytest.approx(8.0, abs=0.5)
    assert after.right_sleeve == before.right_sleeve
    assert after.left_sleeve.end_gather == pytest.approx(before.left_sleeve.end_gather, rel=1e-9)
    assert_sound(edited)


@pytest.mark.parametrize(
    ("share", "flare", "kind"), [(1.0, 1.0, "band"), (0.7, 1.0, "band"), (1.0, 1.7, "flounce")]
)
def test_cuffs_are_added_and_taken_off_again(share, flare, kind):
    pattern = draft("t-shirt", sleeve_length=50)
    ends = Cutter(pattern).ends_of(Part.SLEEVE, Border.ARM)
    names = {r.panel for r in ends}
    plans = [BandPlan(cuff_name(n), tuple(r for r in ends if r.panel == n)) for n in sorted(names)]
    edited = add_band(pattern, plans, 7.0, share=share, flare=flare)
    assert_sound(edited)
    sleeve = measure_facts(edited).left_sleeve
    assert sleeve.cuff.kind == kind
    assert sleeve.end_gather == pytest.approx(1 / share)
    assert sleeve.length == pytest.approx(measure_facts(pattern).left_sleeve.length + 7.0, abs=1.0)
    assert {p.name for p in edited.panels} - {p.name for p in pattern.panels} == {
        f"sl_{s}_cuff_{f}" for s in ("left", "right") for f in "fb"
    }
    same_panels(remove_panels(edited, [cuff_name(n) for n in names]), pattern)


def test_a_waistband_is_taken_off_and_sewn_on_again():
    pattern = draft("trousers", band_height=5)
    bare = remove_panels(pattern, ["wb_front", "wb_back"])
    assert_sound(bare)
    assert measure_facts(bare).waistband is None
    held = [e.label for p in bare.panels for e in p.edges if e.label]
    assert set(held) == {"lower_interface"}
    cutter = Cutter(bare)
    top = [r for loop in cutter.anatomy.loops(Border.TOP) for r in loop.edges]
    plans = [
        BandPlan(f"wb_{f}", tuple(r for r in top if cutter.anatomy.parts[r.panel].face == f))
        for f in ("front", "back")
    ]
    again = add_band(bare, plans, 5.0, label="lower_interface")
    assert_sound(again)
    facts = measure_facts(again)
    assert facts.waistband.height == pytest.approx(5.0, abs=0.2) and not facts.waistband.at_hem
    labels = {(p.name[:2]) for p in again.panels for e in p.edges if e.label == "lower_interface"}
    assert labels == {"wb"}


def test_bands_face_outward_and_stand_beyond_what_they_are_sewn_to():
    pattern = draft("tank-top")
    cutter = Cutter(pattern)
    parts = cutter.anatomy.parts
    plans = [
        BandPlan(f"wb_{f}", tuple(r for r in cutter.hem if parts[r.panel].face == f))
        for f in ("front", "back")
    ]
    edited = add_band(pattern, plans, 6.0, share=0.9)
    for face, sign in (("front", 1), ("back", -1)):
        panel = edited.panel(f"wb_{face}")
        assert panel.normal()[2] * sign > 0.99
        assert panel.to_world(panel.vertices)[:, 1].max() < measure_hem_height(pattern) + 0.5


def measure_hem_height(pattern: Pattern) -> float:
    panel = pattern.panel("left_ftorso")
    return float(panel.to_world(panel.vertices)[:, 1].min())


@given(st.floats(-3, 12).filter(lambda d: abs(d) > 0.3), st.sampled_from(["round", "v", "square"]))
@FEW
def test_necklines_are_deepened(distance, shape):
    pattern = draft("t-shirt", neckline=shape, neck_depth=12)
    edited = recut_neckline(pattern, Cutter(pattern).neckline("front"), distance, None)
    before, after = (measure_facts(p).front_neck for p in (pattern, edited))
    assert after.depth - before.depth == pytest.approx(distance, abs=0.05)
    assert after.width == pytest.approx(before.width, abs=1e-6)
    assert measure_facts(edited).back_neck == measure_facts(pattern).back_neck
    assert_sound(edited)


@pytest.mark.parametrize("old", ["round", "v", "square"])
@pytest.mark.parametrize("new", ["round", "v", "square"])
@pytest.mark.parametrize("face", ["front", "back"])
def test_necklines_are_reshaped(old, new, face):
    pattern = draft("tank-top", neckline=old, neck_depth=15, back_neck_depth=12)
    edited = recut_neckline(pattern, Cutter(pattern).neckline(face), 0.0, new)
    facts = measure_facts(edited)
    neck = facts.front_neck if face == "front" else facts.back_neck
    was = measure_facts(pattern)
    before = was.front_neck if face == "front" else was.back_neck
    assert neck.shape == new
    assert neck.depth == pytest.approx(before.depth, abs=0.3)
    assert_sound(edited)
    labels = [e.label for p in edited.panels for e in p.edges if "collar" in e.label]
    assert len(labels) >= 4


@pytest.mark.parametrize("side", ["left", "right"])
@given(st.floats(8, 30))
@FEW
def test_side_seams_are_opened(side, height):
    pattern = draft("fitted-skirt", length=70)
    edited = open_side(pattern, Cutter(pattern).hem, height, side)
    slits = measure_facts(edited).skirt.slits
    assert [s.place for s in slits] == [side]
    assert slits[0].height == pytest.approx(height, abs=0.7)
    assert len(edited.stitches) == len(pattern.stitches)
    assert_sound(edited)


@given(st.floats(0.7, 1.8))
@FEW
def test_fullness_is_gathered_into_the_same_band(factor):
    pattern = draft("gathered-skirt", fullness=1.5, flare=0.0)
    edited = widen_panels(pattern, ["skirt_front", "skirt_back"], factor)
    before, after = measure_facts(pattern), measure_facts(edited)
    assert after.skirt.gather == pytest.approx(factor * before.skirt.gather, rel=1e-6)
    assert after.waistband.upper == before.waistband.upper
    assert after.length == pytest.approx(before.length, abs=0.3)


def test_arcs_that_sweep_far_are_not_made_ellipses(drafts):
    assert widen_panels(drafts["circle-skirt"], ["skirt_front", "skirt_back"], 1.2) is None


def test_what_does_not_go_is_refused(drafts):
    skirt = drafts["fitted-skirt"]
    hem = Cutter(skirt).hem
    assert move_ends(skirt, hem, -200.0) is None
    assert swing_sides(skirt, hem, 30.0) is None
    assert open_side(skirt, hem, 300.0, "left") is None
    assert remove_panels(skirt, [p.name for p in skirt.panels]) is None
    assert (
        remove_panels(drafts["hoodie"], ["left_ftorso", "left_btorso", "right_ftorso", "right_btorso"])
        is None
    )
    one_side = [r for r in hem if r.panel == "skirt_front"]
    assert move_ends(skirt, one_side, 5.0) is None, "the back would keep its length"
    name_taken = BandPlan("skirt_back", tuple(one_side))
    assert add_band(skirt, [name_taken], 5.0) is None


def test_cuff_names_are_garmentcodes():
    assert cuff_name("left_sleeve_b") == "sl_left_cuff_b"
    assert cuff_name("pant_f_l") == "pant_l_cuff_f"
    assert cuff_name("lfsleeve") == "lfsleeve_cuff"


READS_SHORT = ("gc_1001973",)
"""One shoulder bare, darts open to the hem: the longer it is, the higher its panels are taken to lie."""


def test_real_hems_move_too(few_real_patterns):
    done = 0
    for name, pattern in few_real_patterns.items():
        cutter = Cutter(pattern)
        hem = cutter.hem_of(Part.SKIRT, Part.GODET) or cutter.hem_of(Part.TORSO)
        edited = move_ends(pattern, hem, 6.0) if hem else None
        if edited is None:
            continue
        before, after = measure_facts(pattern), measure_facts(edited)
        low = 1.0 if name in READS_SHORT else 4.0
        assert low < before.hem.level - after.hem.level < 8.0, name
        assert math.isclose(
            sum(len(p.edges) for p in edited.panels), sum(len(p.edges) for p in pattern.panels), rel_tol=0.3
        )
        done += 1
    assert done >= len(few_real_patterns) / 3
