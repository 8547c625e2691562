"""Predicted patterns against true ones: cases that can be worked out by hand, and the drafts."""

from __future__ import annotations

import json
from dataclasses import asdict, replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from swifttailor.errors import InputError
from swifttailor.evaluation.paper_rows import EDITED_PATTERNS, PATTERNS_FROM_IMAGE_AND_TEXT
from swifttailor.evaluation.patterns import (
    aipparel_score,
    name_score,
    pattern_tables,
    summarize_patterns,
)
from swifttailor.evaluation.patterns.aipparel import AipparelScore
from swifttailor.evaluation.patterns.panel_geometry import (
    edge_vectors,
    loop_points,
    rotation_distance,
    translation_distance,
    universal_translation,
    vertex_distance,
    vertex_extent,
)
from swifttailor.pattern import (
    Arc,
    Cubic,
    Edge,
    EdgeRef,
    Panel,
    Pattern,
    Placement,
    Quadratic,
    Stitch,
)
from swifttailor.pattern.curve import evaluate
from swifttailor.pattern.drafts import draft, list_drafts

CORNERS = np.array([[0.0, 0.0], [10.0, 0.0], [10.0, 20.0], [0.0, 20.0]])


def rectangle(name: str, corners=CORNERS, at=(0.0, 0.0, 0.0), turned=(0.0, 0.0, 0.0)) -> Panel:
    return Panel(name, corners, (Edge(),) * len(corners), Placement(at, turned))


def stitch(a: str, i: int, b: str, j: int, right_wrong: bool = False) -> Stitch:
    return Stitch(EdgeRef(a, i), EdgeRef(b, j), right_wrong)


@pytest.fixture
def truth() -> Pattern:
    panels = rectangle("left_ftorso"), rectangle("left_btorso"), rectangle("skirt_front")
    stitches = (stitch("left_ftorso", 1, "left_btorso", 3), stitch("left_ftorso", 3, "left_btorso", 1))
    return Pattern(panels, (*stitches, stitch("left_ftorso", 0, "skirt_front", 2)))


def with_panel(pattern: Pattern, panel: Panel) -> Pattern:
    return replace(pattern, panels=tuple(panel if p.name == panel.name else p for p in pattern.panels))


def without(pattern: Pattern, name: str) -> Pattern:
    stitches = tuple(s for s in pattern.stitches if name not in (s.first.panel, s.second.panel))
    return Pattern(tuple(p for p in pattern.panels if p.name != name), stitches)


PERFECT = AipparelScore(True, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0)


@pytest.mark.parametrize("name", [d.name for d in list_drafts()])
def test_a_pattern_equals_itself(name):
    pattern = draft(name).canonical()
    assert aipparel_score(pattern, pattern) == PERFECT
    score = name_score(pattern, pattern)
    assert score.panels.f1 == score.edges == score.kinds == score.stitches.f1 == score.sides == 1
    assert score.vertex_cm == score.translation_cm == score.rotation == 0
    assert score.structure_right


@settings(max_examples=20, deadline=None)
@given(st.sampled_from(["t-shirt", "hoodie", "jumpsuit"]), st.randoms(use_true_random=False))
def test_the_order_of_panels_and_stitches_means_nothing_by_name(name, random):
    truth = draft(name)
    other = draft(name, **({"sleeve_length": 40.0} if name == "t-shirt" else {}))
    panels, stitches = list(other.panels), list(other.stitches)
    random.shuffle(panels)
    random.shuffle(stitches)
    turned = [Stitch(s.second, s.first, s.right_wrong) if random.random() < 0.5 else s for s in stitches]
    shuffled = Pattern(tuple(panels), tuple(turned))
    assert name_score(shuffled, truth) == name_score(other, truth)
    # AIpparel pairs by place: only the order of stitches, and that of the true pattern, mean nothing there.
    again = Pattern(other.panels, tuple(turned))
    backwards = Pattern(truth.panels[::-1], truth.stitches[::-1])
    assert aipparel_score(again, backwards) == aipparel_score(other, truth)
    assert aipparel_score(shuffled.canonical(), truth) == aipparel_score(other.canonical(), truth)


def test_aipparel_pairs_panels_by_place(truth):
    wide = with_panel(truth, rectangle("skirt_front", CORNERS * 2)).canonical()
    score = aipparel_score(Pattern(wide.panels[::-1], wide.stitches), wide)
    # The middle one of three stays; the other two change places.
    assert score.vertex_cm == pytest.approx(2 * vertex_distance(wide.panels[0], wide.panels[2]) / 3)
    assert score.panels_right and score.stitches == 1.0


def test_where_the_first_panel_lies_in_its_plane_means_nothing(truth):
    """As if AIpparel's shift of the first corner to the origin had been made."""
    panel = truth.panel("left_ftorso")
    moved = replace(
        panel,
        vertices=panel.vertices + np.array([3.0, -7.0]),
        placement=Placement((-3.0, 7.0, 0.0)),
    )
    assert aipparel_score(with_panel(truth, moved), truth.canonical()) == aipparel_score(truth, truth)


def test_a_corner_moved_by_one_centimetre(truth):
    """Of the nine points of a rectangle's loop two are at corner 2; the mean moves by 2 / 9.

    So these two are 7 / 9 off and the other seven 2 / 9: (2 * 7 + 7 * 2) / 81 in the mean.
    """
    corners = CORNERS.copy()
    corners[2] += [1.0, 0.0]
    predicted = with_panel(truth, rectangle("left_ftorso", corners))
    expected = 28 / 81
    assert vertex_distance(predicted.panel("left_ftorso"), truth.panel("left_ftorso")) == pytest.approx(
        expected
    )
    score = aipparel_score(predicted.canonical(), truth)
    assert score.vertex_cm == pytest.approx(expected / 3)
    # The upper side of the box is now 11 cm wide: its middle moves by half a centimetre.
    assert score.translation_cm == pytest.approx(0.5 / 3)
    assert (score.rotation, score.stitches, score.edges_in_order, score.edges_by_name) == (0, 1, 1, 1)
    assert name_score(predicted, truth).vertex_cm == pytest.approx(expected / 3)


def test_the_first_corner_counts_three_times(truth):
    """It is the start, the first control point and the end of the loop: 3 points of 9."""
    corners = CORNERS.copy()
    corners[0] += [0.0, 1.0]
    predicted = rectangle("left_ftorso", corners)
    assert vertex_distance(predicted, truth.panel("left_ftorso")) == pytest.approx((3 * 6 + 6 * 3) / 81)


def test_a_panel_moved_and_turned(truth):
    moved = with_panel(truth, rectangle("skirt_front", at=(3.0, 4.0, 0.0))).canonical()
    score = aipparel_score(moved, truth)
    assert score.translation_cm == pytest.approx(5 / 3)
    assert (score.vertex_cm, score.rotation) == (0, 0)
    turned = with_panel(truth, rectangle("skirt_front", turned=(0.0, 90.0, 0.0))).canonical()
    # Quaternions of a turn by a: 2 sin(a / 4) apart.
    assert aipparel_score(turned, truth).rotation == pytest.approx(2 * np.sin(np.pi / 8) / 3)


@pytest.mark.parametrize("angle", [170.0, 190.0, 350.0])
def test_a_rotation_and_the_one_of_the_other_sign_are_one(angle):
    a, b = (rectangle("p", turned=(0.0, turn, 0.0)) for turn in (angle, angle - 360))
    assert rotation_distance(a, b) == pytest.approx(0, abs=1e-7)
    half = rotation_distance(rectangle("p"), rectangle("p", turned=(0.0, 180.0, 0.0)))
    assert half == pytest.approx(2**0.5)


@pytest.mark.parametrize(
    ("turned", "expected"),
    [
        ((0.0, 0.0, 0.0), (5.0, 20.0, 0.0)),
        ((0.0, 0.0, 90.0), (0.0, 10.0, 0.0)),  # the right side is now the highest: (10, 10) goes to (-10, 10)
        ((0.0, 0.0, 180.0), (-5.0, 0.0, 0.0)),  # the lower side
    ],
)
def test_the_highest_side_of_the_box(turned, expected):
    found = universal_translation(rectangle("p", turned=turned))
    assert found[1] == pytest.approx(expected[1])
    if turned[2] != 90.0:
        assert np.allclose(found, expected)
    else:
        assert found[0] == pytest.approx(-10)
    moved = universal_translation(rectangle("p", at=(1.0, 2.0, 3.0), turned=turned))
    assert np.allclose(moved - found, [1, 2, 3])
    assert translation_distance(rectangle("p", at=(1.0, 2.0, 2.0)), rectangle("p")) == pytest.approx(3)


def test_control_points_of_every_kind_of_edge():
    corners = [[0.0, 0.0], [10.0, 0.0], [10.0, 10.0], [0.0, 10.0]]
    quadratic, cubic, arc = Quadratic((0.5, 0.3)), Cubic((0.2, 0.1), (0.7, -0.2)), Arc(8.0, False, True)
    panel = Panel("p", corners, (Edge(), Edge(quadratic), Edge(cubic), Edge(arc)))
    rows = edge_vectors(panel)
    assert np.allclose(rows[:, :2], [[10, 0], [0, 10], [-10, 0], [0, -10]])
    assert np.allclose(rows[0, 2:], 0)
    # The cubic of the same shape as a quadratic has its first control point two thirds of the way.
    assert np.allclose(rows[1, 2:], [1 / 3, 0.2])
    assert np.allclose(rows[2, 2:], [0.2, 0.1])
    points = loop_points(rows, 4)
    middle = evaluate(arc, panel.chord(3), 0.5)[0]
    assert np.allclose(points[7] - points[0], middle - panel.vertices[0])
    assert np.allclose(points[-1], points[0])
    assert np.allclose(points.mean(axis=0), 0)
    assert len(points) == 9


def test_loops_of_different_lengths_are_padded_at_their_end():
    triangle = rectangle("p", [[0.0, 0.0], [9.0, 0.0], [9.0, 9.0]])
    points = loop_points(edge_vectors(triangle), 4)
    assert len(points) == 9 and np.allclose(points[-3:], points[0])
    square = rectangle("p", [[0.0, 0.0], [9.0, 0.0], [9.0, 9.0], [0.0, 9.0]])
    expected = np.linalg.norm(points - loop_points(edge_vectors(square), 4), axis=1).mean()
    assert vertex_distance(triangle, square) == vertex_distance(square, triangle) == pytest.approx(expected)


def test_a_missing_panel(truth):
    predicted = without(truth, "skirt_front").canonical()
    assert aipparel_score(predicted, truth) == AipparelScore(False, 1.0)
    score = name_score(predicted, truth)
    assert (score.panels.precision, score.panels.recall) == (1, 2 / 3)
    assert score.panels.f1 == pytest.approx(0.8)
    assert score.edges == score.kinds == pytest.approx(2 / 3)
    assert score.vertex_cm == pytest.approx(vertex_extent(truth.panel("skirt_front")) / 3)
    assert score.translation_cm == score.rotation == 0
    assert (score.stitches.hits, score.stitches.predicted, score.stitches.true) == (2, 2, 3)
    assert not score.structure_right


def test_a_panel_too_many(truth):
    predicted = replace(truth, panels=(*truth.panels, rectangle("hood")))
    assert aipparel_score(predicted, truth) == AipparelScore(False, 3 / 4)
    score = name_score(predicted, truth)
    assert (score.panels.precision, score.panels.recall) == (3 / 4, 1)
    assert score.edges == 3 / 4 and score.vertex_cm == pytest.approx(vertex_extent(rectangle("hood")) / 4)
    assert score.stitches.f1 == 1 and not score.structure_right


def test_a_panel_of_another_name(truth):
    """AIpparel counts panels, whatever they are called, and finds no stitch of it."""
    renamed = replace(
        truth.canonical(),
        panels=tuple(
            replace(p, name="hood") if p.name == "skirt_front" else p for p in truth.canonical().panels
        ),
        stitches=(*truth.stitches[:2], stitch("left_ftorso", 0, "hood", 2)),
    )
    score = aipparel_score(renamed, truth)
    assert score.panels_right and score.edges_by_name == pytest.approx(2 / 3) and score.edges_in_order == 1
    assert score.vertex_cm == 0 and score.stitches == pytest.approx(2 / 3)
    named = name_score(renamed, truth)
    assert named.panels.hits == 2 and named.edges == pytest.approx(2 / 4)
    assert named.vertex_cm == pytest.approx(vertex_extent(rectangle("x")) / 2)  # two of four panels


def test_an_edge_too_many(truth):
    corners = np.insert(CORNERS, 1, [5.0, 0.0], axis=0)
    predicted = with_panel(truth, rectangle("skirt_front", corners)).canonical()
    score = aipparel_score(predicted, truth)
    assert score.panels_right and score.edges_by_name == score.edges_in_order == pytest.approx(2 / 3)
    assert name_score(predicted, truth).edges == pytest.approx(2 / 3)


def test_another_kind_of_edge(truth):
    panel = truth.panel("skirt_front")
    curved = replace(panel, edges=(Edge(Quadratic((0.5, 0.0))), *panel.edges[1:]))
    score = name_score(with_panel(truth, curved), truth)
    assert score.edges == 1 and score.kinds == pytest.approx(2 / 3) and not score.structure_right


def test_a_missing_a_wrong_and_an_extra_stitch(truth):
    missing = replace(truth, stitches=truth.stitches[:2]).canonical()
    assert aipparel_score(missing, truth).stitches == pytest.approx(2 / 3)
    assert (name_score(missing, truth).stitches.precision, name_score(missing, truth).stitches.recall) == (
        1,
        2 / 3,
    )
    wrong = replace(
        truth, stitches=(*truth.stitches[:2], stitch("left_ftorso", 0, "skirt_front", 0))
    ).canonical()
    assert aipparel_score(wrong, truth).stitches == pytest.approx(2 / 3)
    assert name_score(wrong, truth).stitches.f1 == pytest.approx(2 / 3)
    extra = replace(truth, stitches=(*truth.stitches, stitch("left_btorso", 0, "skirt_front", 0))).canonical()
    assert aipparel_score(extra, truth).stitches == 1  # AIpparel does not punish it
    assert name_score(extra, truth).stitches.precision == 3 / 4
    none = replace(truth, stitches=()).canonical()
    assert aipparel_score(none, truth).stitches == 0
    assert name_score(none, truth).stitches.f1 == 0 and name_score(none, truth).sides is None


def test_the_sides_of_stitches(truth):
    turned = replace(truth, stitches=(*truth.stitches[:2], replace(truth.stitches[2], right_wrong=True)))
    score = name_score(turned, truth)
    assert score.stitches.f1 == 1 and score.sides == pytest.approx(2 / 3) and not score.structure_right
    assert aipparel_score(turned.canonical(), truth).stitches == 1  # its format does not know them


def test_nothing_decoded(truth):
    for nothing in (None, Pattern(())):
        assert aipparel_score(nothing, truth) == AipparelScore(False)
        score = name_score(nothing, truth)
        assert score.panels.f1 == score.edges == score.stitches.f1 == 0
        assert score.vertex_cm == pytest.approx(vertex_extent(rectangle("x")))
        assert score.translation_cm is None and score.sides is None and not score.structure_right


def test_patterns_without_stitches_agree_about_them():
    pattern = Pattern((rectangle("skirt_front"),))
    assert name_score(pattern, pattern).stitches.f1 == 1 and name_score(pattern, pattern).structure_right
    assert aipparel_score(pattern, pattern).stitches == 0  # as AIpparel's code has it: none found of none


def test_summary_over_patterns_counts_who_is_in_each_mean(truth):
    corners = CORNERS.copy()
    corners[2] += [1.0, 0.0]
    moved = with_panel(truth, rectangle("left_ftorso", corners)).canonical()
    fewer = without(truth, "skirt_front").canonical()
    found = summarize_patterns([truth.canonical(), moved, fewer, None], [truth] * 4)
    assert (found.patterns, found.missing) == (4, 1)
    means = {name: (round(m.mean, 6), m.count) for name, m in found.aipparel.items()}
    assert means["panels_right"] == (0.5, 4) and means["edges_by_name"] == (1, 3)
    assert means["vertex_cm"] == (round(28 / 81 / 6, 6), 2) and means["stitches"] == (1, 2)
    assert found.by_name["structure_right"].mean == 0.5 and found.by_name["sides"].count == 3
    assert found.by_name["stitch_recall"].mean == pytest.approx((1 + 1 + 2 / 3 + 0) / 4)
    assert json.loads(json.dumps(asdict(found)))["aipparel"]["panels_right"]["count"] == 4
    for wrong in (([], []), ([truth], [])):
        with pytest.raises(InputError, match="equally many"):
            summarize_patterns(*wrong)


def test_tables_beside_the_paper(truth):
    """An edit that is copied instead of made: the baseline that every table of edits needs."""
    longer = with_panel(truth, rectangle("skirt_front", CORNERS * [1.0, 2.0]))
    made = summarize_patterns([longer.canonical()], [longer])
    copied = summarize_patterns([truth.canonical()], [longer])
    text = pattern_tables([("edited", made), ("input as it is", copied)], EDITED_PATTERNS)
    lines = text.splitlines()
    first = next(line for line in lines if line.startswith("edited"))
    assert first.split()[1:] == ["0.00", "100.0", "100.0", "100.0", "0.0000", "0.00", "100.0", "-", "1", "1"]
    copy = next(line for line in lines if line.startswith("input as it is")).split()
    assert float(copy[4]) > 1 and copy[5] == "100.0"
    paper = next(line for line in lines if line.startswith("paper: PatternMaker"))
    assert paper.split()[2:] == ["1.50", "85.0", "-", "-", "0.0020", "1.30", "97.8", "98.0", "-", "-"]
    nothing = pattern_tables([("none", summarize_patterns([None], [truth]))], PATTERNS_FROM_IMAGE_AND_TEXT)
    assert "paper: SewingLDM" in nothing and "none" in nothing
