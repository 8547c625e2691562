from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from pattern_strategies import panels

from swifttailor.errors import PatternError
from swifttailor.pattern import Arc, EdgeRef, Line, Panel, Pattern, Placement, Stitch, body_region
from swifttailor.pattern.names import PANEL_NAMES, canonical_key
from swifttailor.pattern.panel import Edge

CHECKED = settings(max_examples=60, deadline=None)
SQUARE = Panel("square", [[0, 0], [10, 0], [10, 10], [0, 10]], (Edge(),) * 4)


@CHECKED
@given(panels())
def test_reversing_flips_the_winding_and_renumbers_edges(panel):
    back = panel.reversed()
    last = len(panel.edges) - 1
    assert back.signed_area() == pytest.approx(-panel.signed_area(), rel=1e-9, abs=1e-9)
    assert back.perimeter() == pytest.approx(panel.perimeter(), rel=1e-9)
    assert np.allclose(back.normal(), -panel.normal())
    for k in range(last + 1):
        assert np.array_equal(back.chord(last - k), panel.chord(k)[::-1])
        assert back.edges[last - k].label == panel.edges[k].label
        assert back.sample_edge(last - k, 7)[::-1] == pytest.approx(panel.sample_edge(k, 7), abs=1e-6)
    again = back.reversed()
    assert np.array_equal(again.vertices, panel.vertices)


@CHECKED
@given(panels())
def test_mirroring_keeps_size_and_edge_numbers(panel):
    mirrored = panel.mirrored()
    assert mirrored.signed_area() == pytest.approx(-panel.signed_area(), rel=1e-9, abs=1e-9)
    for k in range(len(panel.edges)):
        flipped = panel.sample_edge(k, 5) * [-1.0, 1.0]
        assert mirrored.sample_edge(k, 5) == pytest.approx(flipped, abs=1e-6)
    assert mirrored.mirrored() == panel


@CHECKED
@given(panels())
def test_outline_box_and_area_agree(panel):
    low, high = panel.bounding_box()
    outline = panel.outline(0.001)
    assert np.all(outline >= low - 1e-6) and np.all(outline <= high + 1e-6)
    assert np.abs(outline.min(axis=0) - low).max() < 0.05
    assert abs(panel.signed_area()) <= np.prod(high - low)


@CHECKED
@given(panels())
def test_normal_is_the_right_hand_normal_of_the_loop_in_the_world(panel):
    world = panel.to_world(panel.outline(0.01))
    center = world.mean(axis=0)
    doubled = np.cross(world - center, np.roll(world, -1, axis=0) - center).sum(axis=0)
    assert np.linalg.norm(doubled) / 2 == pytest.approx(abs(panel.signed_area()), rel=1e-2)
    assert panel.normal() == pytest.approx(doubled / np.linalg.norm(doubled), abs=1e-3)


def test_the_two_rotation_readings_differ_where_more_than_one_axis_turns():
    inner = Placement((0, 0, 0), (90, 45, 0), "intrinsic").matrix()
    outer = Placement((0, 0, 0), (90, 45, 0), "extrinsic").matrix()
    angle = np.degrees(np.arccos((np.trace(inner.T @ outer) - 1) / 2))
    assert angle == pytest.approx(62.8, abs=0.05)
    for rotation in ((0, 30, 0), (0, 0, -45.48), (-180, 20, 180)):
        same = [Placement((0, 0, 0), rotation, r).matrix() for r in ("intrinsic", "extrinsic")]
        assert same[0] == pytest.approx(same[1], abs=1e-12)
    assert Placement((0, 0, 0), (90, 0, 0)).apply([[0.0, 1.0]])[0] == pytest.approx([0, 0, 1])


def test_rotation_matrices_are_those_of_scipy():
    from scipy.spatial.transform import Rotation

    angles = (13.0, -72.0, 151.0)
    for reading, order in (("intrinsic", "XYZ"), ("extrinsic", "xyz")):
        expected = Rotation.from_euler(order, angles, degrees=True).as_matrix()
        assert Placement((0, 0, 0), angles, reading).matrix() == pytest.approx(expected)


@pytest.mark.parametrize(
    ("vertices", "edges", "message"),
    [
        ([[0, 0], [1, 0], [0, np.nan]], 3, "finite"),
        ([[0, 0]], 1, "n >= 2"),
        ([0, 1, 2], 3, r"\(n, 2\)"),
        ([[0, 0], [1, 0], [0, 1]], 2, "as many edges as vertices"),
    ],
)
def test_panels_that_are_no_loop_are_refused(vertices, edges, message):
    with pytest.raises(PatternError, match=message):
        Panel("bad", vertices, (Edge(),) * edges)


def test_panels_are_values():
    other = Panel("square", [[-0.0, 0], [10, 0], [10, 10], [0, 10]], [Edge()] * 4)
    assert other == SQUARE and hash(other) == hash(SQUARE)
    assert replace(SQUARE, edges=(Edge(Arc(9.0, False, True)), *SQUARE.edges[1:])) != SQUARE
    with pytest.raises(ValueError, match="read-only"):
        SQUARE.vertices[0] = 1.0


def test_panel_names_must_be_unique_and_known_ones_found():
    with pytest.raises(PatternError, match="'square' more than once"):
        Pattern((SQUARE, SQUARE))
    pattern = Pattern((SQUARE,))
    with pytest.raises(PatternError, match="The panels are: square"):
        pattern.panel("sleeve")
    assert pattern.has_edge(EdgeRef("square", 3))
    assert not pattern.has_edge(EdgeRef("square", 4)) and not pattern.has_edge(EdgeRef("square", -1))
    assert not pattern.has_edge(EdgeRef("sleeve", 0))


def test_components_follow_the_stitches():
    a, b, c = (replace(SQUARE, name=n) for n in "abc")
    pattern = Pattern((a, b, c), (Stitch(EdgeRef("a", 0), EdgeRef("c", 0)),))
    assert pattern.components() == [("a", "c"), ("b",)]


def test_canonical_order_does_not_depend_on_the_files_order():
    names = ["p10", "p2", "skirt_back", "left_btorso"]
    panels = [replace(SQUARE, name=n) for n in names]
    stitches = [
        Stitch(EdgeRef("p2", 0), EdgeRef("p10", 1), True),
        Stitch(EdgeRef("skirt_back", 0), EdgeRef("left_btorso", 1)),
    ]
    first = Pattern(tuple(panels), tuple(stitches)).canonical()
    turned = [Stitch(s.second, s.first, s.right_wrong) for s in stitches[::-1]]
    second = Pattern(tuple(panels[::-1]), tuple(turned)).canonical()
    assert first == second and hash(first) == hash(second)
    assert [p.name for p in first.panels] == ["left_btorso", "skirt_back", "p2", "p10"]
    assert first.stitches[0].first == EdgeRef("left_btorso", 1)


def test_names_fix_the_order_and_the_region():
    assert len(PANEL_NAMES) == len(set(PANEL_NAMES)) == 75
    assert sorted(PANEL_NAMES, key=canonical_key) == list(PANEL_NAMES)
    assert body_region("sl_left_cuff_skirt_f") == "arm"
    assert body_region("left_sleeve_b") == "arm"
    assert body_region("pant_f_l") == body_region("ins_skirt_back_0") == "leg"
    assert body_region("left_ftorso") == body_region("wb_front") == "body"
    assert body_region("anything", "leg") == "leg" and body_region("my_sleeve", "nonsense") == "arm"


def test_rotation_reading_changes_for_the_whole_pattern():
    pattern = Pattern((replace(SQUARE, placement=Placement((0, 0, 0), (90, 45, 0))),))
    other = pattern.with_rotation_reading("extrinsic")
    assert other.panels[0].placement.reading == "extrinsic"
    assert other.panels[0].placement.rotation == (90, 45, 0)
    assert isinstance(other.panels[0].edges[0].curve, Line)
