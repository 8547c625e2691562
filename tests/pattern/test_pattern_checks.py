from __future__ import annotations

import json
import re
import time
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from pattern_faults import FAULTS, bow_tie, box, dart, lone, narrow_ring, panel, sew, skirt, tube, wound_alike

from swifttailor.errors import PatternError
from swifttailor.pattern import Arc, Cubic, EdgeRef, Finding, Pattern, Placement, Quadratic, Severity, Stitch
from swifttailor.pattern.check import BodyProbe, check_pattern, judge_lengths

READER_CODES = {
    "open-loop", "edge-order", "unused-vertex", "dangling-stitch", "panel-order", "other-units",
    "unknown-key",
}  # fmt: skip

PLACE_CODES = {"misread-angles", "misplaced-panel", "high-sleeve", "spread-leg"}
"""Tested with garments that are worn, in test_worn_place.py."""


def codes(pattern, **kwargs):
    return [f.code for f in check_pattern(pattern, **kwargs)]


@pytest.mark.parametrize("code", FAULTS)
def test_each_code_is_found_in_the_faulty_pattern_and_not_in_the_nearest_sound_one(code):
    severity, faulty, sound = FAULTS[code]
    found = [f for f in check_pattern(faulty) if f.code == code]
    assert found and found[0].severity == severity
    assert code not in codes(sound)
    for finding in found:
        assert finding.message and finding.why and (finding.repair or severity == "info")
        assert json.dumps(finding.to_json(), allow_nan=False)
        if finding.panel and finding.edge is not None and code != "dangling-stitch":
            assert faulty.has_edge(EdgeRef(finding.panel, finding.edge))


@pytest.mark.parametrize("pattern", [tube(), skirt(), dart(), FAULTS["edge-stitched-twice"][2]])
def test_sound_patterns_have_no_findings(pattern):
    assert check_pattern(pattern) == ()


def test_every_code_is_documented_and_every_documented_code_exists():
    table = (Path(__file__).parents[2] / "docs" / "checks.md").read_text()
    documented = set(re.findall(r"^\| `([a-z-]+)` \|", table, re.MULTILINE))
    assert documented == set(FAULTS) | READER_CODES | PLACE_CODES | {"inside-body"}


def test_errors_come_first_and_reader_findings_are_kept():
    note = Finding("other-units", Severity.INFO, "lengths are in mm")
    found = check_pattern(FAULTS["no-area"][1], reader_findings=[note])
    assert note in found and found[0].severity is Severity.ERROR
    ranks = [["error", "warning", "info"].index(f.severity) for f in found]
    assert ranks == sorted(ranks)


@pytest.mark.parametrize(
    ("first", "second", "fit"),
    [
        (10, 10, "equal"), (10, 10.4, "equal"), (0.01, 0.1, "equal"), (10, 11.5, "ease"), (30, 10, "gather"),
        (0.5, 2.4, "gather"), (10, 41, "uneven"), (10, 190, "uneven"), (0, 9, "uneven"), (1, 21, "absurd"),
    ],
)  # fmt: skip
def test_seam_lengths_are_judged(first, second, fit):
    assert judge_lengths(first, second) == judge_lengths(second, first) == fit


def test_an_absurd_seam_is_an_error():
    pattern = tube(front=box("front", height=100), back=box("back", height=2, z=-25).reversed())
    assert {f.severity for f in check_pattern(pattern) if f.code == "uneven-seam"} == {Severity.ERROR}


def test_sizes_beyond_sense_are_errors():
    big, small = (lone([[0, 0], [s, 0], [s, s], [0, s]]) for s in (5001.0, 0.99))
    assert [f.severity for f in check_pattern(big) if f.code == "oversized-panel"] == [Severity.ERROR]
    assert [f.severity for f in check_pattern(small) if f.code == "tiny-pattern"] == [Severity.ERROR]


# Crossings


@pytest.mark.parametrize(
    ("curve", "height"),
    [(Arc(20.0, True, False), 40), (Quadratic((0.5, 2.0)), 10), (Cubic((1.5, 1), (-0.5, 1)), 40)],
)
def test_curves_that_cross_other_edges_or_themselves_are_found(curve, height):
    assert "self-crossing" in codes(lone([[0, 0], [30, 0], [30, height], [0, height]], {0: curve}))


def test_the_place_and_depth_of_a_crossing_are_told():
    finding = next(f for f in check_pattern(bow_tie()) if f.code == "self-crossing")
    assert "edges 1 and 3" in finding.message and "(15.00, 20.00)" in finding.message
    assert finding.edge == 1 and finding.value > 5


def test_overlap_is_a_crossing_even_where_the_winding_agrees():
    """A strip bent round until its ends overlap encloses a hole and covers the overlap twice."""
    ring = [[0, 0], [40, 0], [40, 40], [-5, 40], [-5, 30], [30, 30], [30, 10], [10, 10], [10, 35], [0, 35]]
    assert "self-crossing" in codes(lone(ring))


def test_a_strip_whose_ends_only_meet_is_no_crossing():
    """A full circle cut open along one radius, as circle skirts are: the cut's two edges coincide."""
    ring = [[10, 0], [10, 30], [-20, 30], [-20, -30], [10, -30], [10, 0], [0, 0], [0, -20], [-10, -20],
            [-10, 20], [0, 20], [0, 0]]  # fmt: skip
    assert codes(lone(ring)) == ["self-touching"]


def test_neighbouring_edges_that_meet_smoothly_do_not_cross():
    halves = {0: Arc(10.0, False, True), 1: Arc(10.0, False, True)}
    assert codes(lone([[-10, 0], [10, 0]], halves)) == []
    smooth = {0: Cubic((0.3, 0.2), (0.7, 0.2)), 1: Cubic((0.3, -0.2), (0.7, -0.2))}
    assert codes(lone([[0, 0], [20, 0], [40, 0], [20, 40]], smooth)) == []


# Directions


@pytest.mark.parametrize("flip", [[0], [1], [2], [3], [0, 2], [1, 2], [0, 1]])
def test_twisted_stitches_of_split_seams_are_named(flip):
    twisted = [f.stitch for f in check_pattern(skirt(flip)) if f.code == "twisted-seam"]
    assert sorted(twisted) == flip


@pytest.mark.parametrize("k", [0, 1])
def test_a_twisted_side_of_a_tube_is_seen_by_its_placement(k):
    stitches = [replace(s, right_wrong=(i == k)) for i, s in enumerate(tube().stitches)]
    found = [f for f in check_pattern(tube(stitches=stitches)) if f.code == "twisted-seam"]
    assert [f.stitch for f in found] == [k] and found[0].value < -0.9


def test_unplaced_panels_say_nothing_about_directions():
    pattern = tube(stitches=[replace(tube().stitches[0], right_wrong=True), tube().stitches[1]])
    flat = tuple(replace(p, placement=Placement()) for p in pattern.panels)
    assert codes(replace(pattern, panels=flat)) == []


def test_a_dart_sewn_start_to_start_is_twisted():
    assert codes(dart(right_wrong=True)) == ["twisted-seam"]


@pytest.mark.parametrize("flags", [(True, True), (False, False), (True, False)])
def test_right_wrong_is_right_where_the_edges_say_so(flags):
    """A collar folded down over the torso: its edges run along those of the torso, not against them."""
    torso = panel("torso", [[-20, 0], [20, 0], [10, 40], [0, 38], [-10, 40]])
    collar = panel("collar", [[10, 40], [0, 38], [-10, 40], [-12, 30], [0, 28], [12, 30]], z=26.0)
    stitches = (sew("torso", 2, "collar", 0, flags[0]), sew("torso", 3, "collar", 1, flags[1]))
    found = check_pattern(Pattern((torso, collar), stitches))
    assert [f.stitch for f in found] == [k for k in (0, 1) if not flags[k]]
    assert {f.code for f in found} <= {"twisted-seam"}


def test_panels_wound_alike_are_one_finding_not_twisted_seams():
    found = [code for code in codes(wound_alike()) if code not in PLACE_CODES]
    assert found == ["inside-out-panel"]


def test_a_ring_made_of_one_panel_is_no_fault():
    assert codes(Pattern((box("front"),), (sew("front", 1, "front", 3),))) == []
    assert codes(narrow_ring(30.0)) == []


# Body and placement


def ball(points):
    """Signed distance to a ball of 20 cm around (0, 110, 0)."""
    return np.linalg.norm(points - [0.0, 110.0, 0.0], axis=1) - 20.0


def test_panels_inside_the_body_are_found():
    inside = tube(front=box("front", z=2.0))
    assert codes(inside, body=ball) == ["inside-body"]
    found = check_pattern(inside, body=BodyProbe(ball))[0]
    assert found.panel == "front" and 0.25 < found.value < 1
    assert codes(tube(), body=ball) == [] and codes(inside) == []


def test_the_bodys_height_counts_for_distance():
    high = Pattern((replace(box("front"), placement=Placement((0.0, 400.0, 25.0))),))
    assert codes(high, body=BodyProbe(ball, 0.0, 180.0)) == []
    assert codes(high, body=BodyProbe(ball, 0.0, 90.0)) == ["far-placement"]


def test_a_body_that_answers_wrongly_is_refused():
    with pytest.raises(PatternError, match="one distance per point"):
        check_pattern(tube(), body=lambda points: np.zeros((len(points), 2)))


# Bounds


def _wavy(count, crossing=False):
    angle = np.linspace(0, 2 * np.pi, count, endpoint=False)
    radius = 100 + 5 * np.sin(9 * angle)
    points = np.stack([radius * np.cos(angle), radius * np.sin(angle)], axis=1)
    return np.random.default_rng(1).permutation(points) if crossing else points


@pytest.mark.parametrize("crossing", [False, True])
@pytest.mark.parametrize("curve", [None, Cubic((0.3, 0.1), (0.7, -0.1)), Arc(300.0, False, True)])
def test_a_panel_of_two_thousand_edges_is_checked_in_time(curve, crossing):
    curves = dict.fromkeys(range(2000), curve) if curve else None
    started = time.process_time()
    found = check_pattern(lone(_wavy(2000, crossing), curves))
    assert time.process_time() - started < 10
    assert ("self-crossing" in [f.code for f in found]) == crossing


def test_five_hundred_panels_are_checked_in_time():
    corners = [[-20, 0], [20, 0], [19, 30], [16, 60], [-16, 60], [-19, 30]]
    curves = {0: Cubic((0.3, 0.1), (0.7, 0.1)), 3: Quadratic((0.5, -0.1))}
    panels = [panel(f"p{k}", corners, curves, z=20.0 + k / 10) for k in range(500)]
    stitches = [sew(f"p{k}", 1, f"p{k + 1}", 5) for k in range(499)]
    stitches += [sew(f"p{k}", 2, f"p{k + 1}", 4, k % 7 == 0) for k in range(499)]
    started = time.process_time()
    check_pattern(Pattern(tuple(panels), tuple(stitches)))
    assert time.process_time() - started < 10


def test_twenty_thousand_stitches_of_the_same_edges_are_checked_in_time():
    rng = np.random.default_rng(0)
    refs = [EdgeRef("front", int(k)) for k in range(1500)]
    pairs = rng.integers(0, 1500, (20_000, 2))
    stitches = tuple(Stitch(refs[a], refs[b], bool(a % 2)) for a, b in pairs)
    started = time.process_time()
    found = check_pattern(Pattern((panel("front", _wavy(1500)),), stitches))
    assert time.process_time() - started < 10
    assert any(f.code == "edge-stitched-twice" for f in found)
