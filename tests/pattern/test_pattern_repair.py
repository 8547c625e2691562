from __future__ import annotations

import json
from dataclasses import replace
from functools import partial

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from pattern_faults import FAULTS, box, cross_at_corner, dart, lone, panel, sew, skirt, tube, wound_alike
from pattern_faults import with_zero_edge as zero
from pattern_strategies import patterns

from swifttailor.pattern import (
    Arc,
    Edge,
    EdgeRef,
    Panel,
    Pattern,
    Quadratic,
    Severity,
    check_pattern,
    curve,
    read_specification,
    repair_pattern,
    to_specification,
)
from swifttailor.pattern.check import crossing_repair
from swifttailor.pattern.check import repair as repairing
from swifttailor.pattern.check.crossings import find_crossing
from swifttailor.pattern.check.outline import trace_outline

REPAIRED = [
    "zero-length-edge", "short-radius", "near-crossing", "dangling-stitch", "self-stitched-edge",
    "duplicate-stitch", "twisted-seam", "inside-out-panel",
]  # fmt: skip


def written(pattern):
    return json.dumps(to_specification(pattern))


def stitch_set(pattern):
    return {(frozenset(s.sides), s.right_wrong) for s in pattern.stitches}


@pytest.mark.parametrize("code", REPAIRED)
def test_a_repaired_pattern_passes_the_check_it_failed(code):
    faulty = FAULTS[code][1]
    repair = repair_pattern(faulty)
    assert code in [c.code for c in repair.changes]
    assert code not in [f.code for f in check_pattern(repair.pattern)]
    assert repair.remaining == check_pattern(repair.pattern)
    assert all(c.message and json.dumps(c.to_json()) for c in repair.changes)
    again = repair_pattern(repair.pattern)
    assert again.changes == () and written(again.pattern) == written(repair.pattern)


@pytest.mark.parametrize("code", sorted(set(FAULTS) - set(REPAIRED)))
def test_what_would_need_a_guess_is_left_alone_and_still_listed(code):
    faulty = FAULTS[code][1]
    repair = repair_pattern(faulty)
    assert code in [f.code for f in repair.remaining]
    assert repair.pattern is faulty and repair.changes == ()


@pytest.mark.parametrize("pattern", [f[2] for f in FAULTS.values()] + [tube(), skirt(), dart()])
def test_a_sound_pattern_is_not_touched(pattern):
    if not check_pattern(pattern):
        repair = repair_pattern(pattern)
        assert repair.pattern is pattern and repair.changes == () and repair.remaining == ()


@settings(max_examples=40, deadline=None)
@given(patterns())
def test_repairing_any_pattern_only_ever_helps(pattern):
    before = check_pattern(pattern)
    repair = repair_pattern(pattern)
    if not before:
        assert written(repair.pattern) == written(pattern)
    if not repair.changes:
        assert repair.pattern is pattern
    errors = [sum(f.severity == "error" for f in found) for found in (before, repair.remaining)]
    assert errors[1] <= errors[0]
    assert {p.name for p in repair.pattern.panels} == {p.name for p in pattern.panels}


def test_zero_length_edges_go_from_both_sides_of_a_seam():
    repair = repair_pattern(zero(1e-7))
    assert [len(p.edges) for p in repair.pattern.panels] == [5, 5]
    expected = {
        (frozenset({EdgeRef("front", i), EdgeRef("back", j)}), False) for i, j in [(1, 3), (2, 2), (4, 0)]
    }
    assert stitch_set(repair.pattern) == expected
    assert check_pattern(repair.pattern) == ()
    assert [c.code for c in repair.changes].count("zero-length-edge") == 1


def test_a_zero_length_edge_with_a_long_partner_stays():
    faulty = zero(1e-7, both=False)
    repair = repair_pattern(faulty)
    assert repair.pattern is faulty and "zero-length-edge" in [f.code for f in repair.remaining]


@pytest.mark.parametrize("at", range(5))
def test_dropping_any_edge_keeps_the_outline(at):
    corners = [[0, 0], [40, 0], [40, 60], [0, 60]]
    corners.insert(at, corners[at % 4])
    repair = repair_pattern(lone(corners))
    assert len(repair.pattern.panels[0].edges) == 4
    assert repair.pattern.panels[0].signed_area() == pytest.approx(2400)
    assert repair.remaining == ()


def test_two_partners_for_one_edge_are_not_chosen_between():
    repair = repair_pattern(FAULTS["edge-stitched-twice"][1])
    assert len(repair.pattern.stitches) == 3
    assert [f.code for f in repair.remaining].count("edge-stitched-twice") == 1


def test_radii_are_raised_to_half_the_chord():
    repair = repair_pattern(FAULTS["short-radius"][1])
    assert repair.pattern.panels[0].edges[1].curve == Arc(30.0, False, True)
    assert "from 29.9 to 30 cm" in repair.changes[0].message


@pytest.mark.parametrize("flip", [[0], [2], [1, 3], [0, 1, 2, 3]])
def test_twisted_seams_are_turned_back(flip):
    assert repair_pattern(skirt(flip)).pattern == skirt()


def test_panels_wound_the_wrong_way_are_reversed_with_their_seams():
    repair = repair_pattern(wound_alike())
    assert [c.panel for c in repair.changes] == ["back"]
    assert repair.pattern == tube() and repair.remaining == ()


def test_a_garment_wound_inside_out_altogether_is_reversed():
    corners = box("front")
    inside_out = Pattern(
        (corners.reversed(), box("back", z=-25.0)), (sew("front", 2, "back", 1), sew("front", 0, "back", 3))
    )
    repair = repair_pattern(inside_out)
    assert repair.pattern == tube() and len(repair.changes) == 2


def test_a_panel_placed_inside_out_is_not_reversed_against_its_seams():
    """Here the placement is wrong, not the winding: reversing the loop would twist the seams."""
    front = panel("front", [[-20, 0], [20, 0], [20, 60], [-20, 60]], rotation=(0.0, 180.0, 0.0))
    repair = repair_pattern(tube(front=front))
    assert repair.pattern.panels[0] == front


@pytest.mark.parametrize("reach", [0.01, 0.02, 0.045])
def test_noise_crossings_are_moved_out_by_little(reach):
    faulty = cross_at_corner(reach)
    repair = repair_pattern(faulty)
    moved = np.abs(repair.pattern.panels[0].vertices - faulty.panels[0].vertices).max()
    assert 0 < moved < 0.1 and repair.remaining == ()


def test_what_crosses_itself_everywhere_is_left_without_trying(monkeypatch):
    """A saw of 60 teeth that all poke through the opposite edge by a millimetre."""
    teeth = [(x, -0.1 if k % 2 else 1.0) for k, x in enumerate(np.linspace(99, 1, 121))]
    saw = panel("saw", [(0, 0), (100, 0), *teeth])
    looked = []

    def look(outline):
        looked.append(outline)
        return find_crossing(outline)

    monkeypatch.setattr(crossing_repair, "find_crossing", look)
    assert find_crossing(trace_outline(saw)).places > crossing_repair.MOST_PLACES
    assert crossing_repair.mend_crossings(saw, 4.0) is None
    assert len(looked) == 1


@given(st.integers(0, 2**32 - 1), st.integers(1, 8), st.integers(0, 3000))
@settings(max_examples=20, deadline=None)
def test_only_so_much_is_tried_for_one_pattern(seed, count, edges):
    """Small panels of wavy edges that tangle at many places, and an end to what may be tried."""
    rng = np.random.default_rng(seed)
    around = np.linspace(0, 2 * np.pi, 16, endpoint=False)
    circle = 8.0 * np.stack([np.cos(around), np.sin(around)], axis=1)
    panels = []
    for k in range(count):
        waves = {i: Quadratic((0.5, float(rng.normal(0, 0.4)))) for i in range(16) if rng.random() < 0.6}
        panels.append(replace(panel("p", circle + rng.normal(0, 0.8, (16, 2)), waves), name=f"p{k}"))
    faulty, looked = Pattern(tuple(panels)), []

    def look(outline):
        looked.append(len(outline.panel.edges))
        return find_crossing(outline)

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(crossing_repair, "find_crossing", look)
        patch.setattr(repairing, "Effort", partial(crossing_repair.Effort, edges))
        repair = repair_pattern(faulty)
    # Each panel is looked at as it is, and once with its curves evened out.
    assert sum(looked) <= edges + 2 * 16 * count
    codes = [f.code for f in repair.remaining]
    if "unfinished-repair" in codes:
        assert {"self-crossing", "near-crossing"} & set(codes)


def test_what_was_not_tried_is_said(monkeypatch):
    """The same panel five times, and time for one."""
    slips = [replace(cross_at_corner(0.02).panels[0], name=f"p{k}") for k in range(5)]
    tried = crossing_repair.Effort()
    crossing_repair.mend_crossings(slips[0], effort=tried)
    enough = crossing_repair.MOST_EDGES_TRIED - tried.edges
    monkeypatch.setattr(repairing, "Effort", partial(crossing_repair.Effort, enough))
    repair = repair_pattern(Pattern(tuple(slips)))
    assert [c.panel for c in repair.changes if c.code == "near-crossing"] == ["p0"]
    codes = [f.code for f in repair.remaining]
    assert codes.count("near-crossing") == 4 and codes.count("unfinished-repair") == 1


def test_deep_crossings_are_left():
    repair = repair_pattern(cross_at_corner(3.0))
    assert repair.changes == () and [f.code for f in repair.remaining] == ["self-crossing"]


def test_curves_that_bulge_over_their_neighbour_are_flattened():
    """A neckline that swings past the shoulder line by less than a millimetre, as GarmentCode makes them."""
    corners = [[0.0, 0.0], [0.0, 15.876], [-6.093, 53.159], [-18.193, 48.349], [-28.085, 0.0]]
    arc = Arc(19.21, False, False)
    found = [f.code for f in check_pattern(lone(corners, {1: arc}))]
    assert found == ["near-crossing"]
    repair = repair_pattern(lone(corners, {1: arc}))
    assert repair.remaining == () and repair.pattern.panels[0].edges[1].curve.radius > 19.21


def test_what_the_reader_mended_is_listed(square_pattern):
    specification = to_specification(square_pattern)
    specification["pattern"]["panels"]["front"]["edges"].pop()
    specification["pattern"]["panels"]["back"]["vertices"].append([99, 99])
    specification["pattern"]["stitches"].append(
        [{"panel": "front", "edge": 0}, {"panel": "sleeve", "edge": 0}]
    )
    reading = read_specification(specification)
    repair = repair_pattern(reading.pattern, reading.findings)
    assert {c.code for c in repair.changes} >= {"open-loop", "unused-vertex", "dangling-stitch"}
    assert "closed the outline" in next(c.message for c in repair.changes if c.code == "open-loop")
    # The seam that named the missing edge is gone; the rest is sound.
    assert [f.code for f in repair.remaining] == []
    mended = read_specification(to_specification(repair.pattern))
    assert mended.findings == () and mended.pattern == repair.pattern


@settings(max_examples=40, deadline=None)
@given(st.sets(st.integers(0, 3)), st.booleans())
def test_several_faults_at_once(flips, wind_back_wrong):
    pattern = skirt(flips)
    stitches = (*pattern.stitches, pattern.stitches[0], sew("front", 0, "front", 0), sew("x", 0, "front", 3))
    faulty = replace(pattern, stitches=stitches)
    assert repair_pattern(faulty).pattern == skirt()


def test_larger_moves_are_made_where_they_are_allowed():
    """A hem that bulges 2 cm through the opposite edge: too far for a pattern that somebody drew."""
    corners = [[0, 0], [20, 0], [20, 6], [0, 6]]
    strip = Panel("strip", corners, (Edge(Quadratic((0.5, 0.8))), Edge(), Edge(), Edge()))
    kept = repair_pattern(Pattern((strip,)))
    assert not kept.changes and "self-crossing" in {f.code for f in kept.remaining}
    mended = repair_pattern(Pattern((strip,)), largest_move=4.0)
    assert [c.code for c in mended.changes] == ["self-crossing"]
    assert not [f for f in mended.remaining if f.severity is Severity.ERROR]
    assert find_crossing(trace_outline(mended.pattern.panels[0])) is None
    before, after = (p.flatten_edge(0, 0.01)[:, 1].max() for p in (strip, mended.pattern.panels[0]))
    assert 2.0 <= before - after <= 4.0


@pytest.mark.parametrize("inner", [0.5, 1.4, 2.6])
def test_flounces_that_cross_themselves_get_even(inner):
    """Part of a ring, 3 cm wide, of up to four fifths of a turn; the inner arc is 5 cm too high."""
    around = np.array([np.pi / 2 - inner, np.pi / 2 + inner])
    rim, neck = (r * np.stack([np.cos(around), np.sin(around)], axis=1) for r in (60.0, 57.0))
    corners = np.concatenate([rim, neck[::-1]])
    edges = [Edge(Arc(60.0, inner > np.pi / 2, True)), Edge(), Edge(), Edge()]
    half = float(np.hypot(*(neck[1] - neck[0]))) / 2
    sagitta = 57 - 57 * np.cos(inner) + 5
    radius = (half**2 + sagitta**2) / (2 * sagitta)
    edges[2] = Edge(Arc(radius, bool(sagitta > half), False))
    flounce = Panel("flounce", corners, tuple(edges))
    assert find_crossing(trace_outline(flounce)).kind == "crossing"
    assert not repair_pattern(Pattern((flounce,))).changes
    (mended,) = repair_pattern(Pattern((flounce,)), largest_share=0.05).pattern.panels
    assert find_crossing(trace_outline(mended)) is None
    assert np.array_equal(mended.vertices, flounce.vertices)
    tops = [curve.evaluate(mended.edges[k].curve, mended.chord(k), np.array([0.5]))[0] for k in (0, 2)]
    assert tops[0] - tops[1] == pytest.approx([0.0, 3.0], abs=1e-6)
    assert tops[0][1] == pytest.approx(62.5, abs=1e-6)  # the arcs' middles were at 60 and 62
