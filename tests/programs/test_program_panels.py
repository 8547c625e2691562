from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from swifttailor.pattern import Placement
from swifttailor.programs.component import Component
from swifttailor.programs.design_error import DesignError
from swifttailor.programs.distributing import distribute_horizontally, distribute_y
from swifttailor.programs.edge_shapes import from_verts
from swifttailor.programs.edges import ArcEdge
from swifttailor.programs.interface import Interface
from swifttailor.programs.panel import Panel
from swifttailor.programs.rotation import Rotation

angles = st.floats(-89, 89)


def rectangle(name="panel", width=40.5, height=60.25) -> Panel:
    panel = Panel(name)
    panel.edges = from_verts([0.0, 0.0], [0.0, height], [width, height], [width, 0.0], loop=True)
    panel.interfaces = {"top": Interface(panel, panel.edges[1]), "bottom": Interface(panel, panel.edges[3])}
    return panel


@given(angles, angles, angles)
def test_rotations_are_read_as_patterns_read_them(x, y, z):
    rotation = Rotation.from_euler(x, y, z)
    assert np.allclose(rotation.rows, Placement(rotation=(x, y, z)).matrix())
    assert rotation.as_euler() == pytest.approx((x, y, z), abs=1e-6)
    assert rotation.apply([1.0, 2.0, 3.0]) == pytest.approx(list(np.array(rotation.rows) @ [1, 2, 3]))


@given(st.tuples(angles, angles, angles), st.tuples(angles, angles, angles))
def test_a_product_is_one_rotation_after_the_other(one, two):
    first, second = Rotation.from_euler(*one), Rotation.from_euler(*two)
    point = [3.0, -1.0, 2.0]
    assert (second * first).apply(point) == pytest.approx(second.apply(first.apply(point)))


@given(st.lists(st.floats(-5, 5), min_size=3, max_size=3), st.lists(st.floats(-5, 5), min_size=3, max_size=3))
def test_aligning_turns_one_direction_into_the_other(a, b):
    one, two = np.array(a), np.array(b)
    if np.linalg.norm(np.cross(one, two)) < 1e-3:
        return
    turned = np.array(Rotation.aligning(a, b).apply(a))
    assert np.allclose(turned / np.linalg.norm(turned), two / np.linalg.norm(two), atol=1e-6)


def test_the_right_side_looks_away_from_the_body():
    for z in (20.0, -20.0):
        panel = rectangle().translate_to([0.0, 100.0, z])
        assert panel.norm() == pytest.approx([0, 0, math.copysign(1, z)])
        assert panel.assembly().normal() @ [0, 0, z] > 0


def test_vertices_move_by_whole_centimetres_with_the_pivot():
    panel = rectangle().top_center_pivot()
    assert panel.edges[0].start == [-20.0, -60.0]
    panel.translation = [1.0, 2.0, 3.0]
    panel.set_pivot([2.75, -3.5], replicate_placement=True)
    assert panel.edges[0].start == [-22.0, -57.0] and panel.translation == [3.75, -1.5, 3.0]


def test_centred_panels_have_their_middle_before_the_body():
    panel = rectangle().center_x()
    low, high = panel.bbox_3d()
    assert low[0] == pytest.approx(-high[0])


def test_a_mirrored_panel_is_the_mirror_image():
    panel = rectangle().rotate_to(Rotation.from_euler(10.0, 20.0, 30.0)).translate_to([30.0, 100.0, 20.0])
    before = sorted(tuple(np.round(panel.point_to_3d(v), 9)) for v in panel.edges.verts())
    panel.mirror()
    after = sorted((-x, y, z) for x, y, z in (panel.point_to_3d(v) for v in panel.edges.verts()))
    assert np.allclose(before, after)


def test_a_bent_edge_reaches_beyond_its_ends():
    panel = rectangle()
    panel.edges.substitute(1, ArcEdge(panel.edges[1].start, panel.edges[1].end, 0.5))
    assert panel.length() > 80 and panel.length(longest_dim=True) == panel.length()


def test_components_move_as_one():
    group = Component("group")
    group.front = rectangle("front").translate_to([0.0, 100.0, 20.0])
    group.back = rectangle("back").translate_to([0.0, 100.0, -20.0])
    group.subs = [group.front]
    assert [p.name for p in group.panels()] == ["back", "front"]
    group.translate_to([5.0, 50.0, 0.0])
    assert group.pivot_3d() == pytest.approx([5, 50, 0])
    assert group.front.translation[2] - group.back.translation[2] == pytest.approx(40)
    group.rotate_by(Rotation.from_euler(0.0, 90.0, 0.0))
    assert group.bbox_3d()[1][0] - group.bbox_3d()[0][0] == pytest.approx(40)
    group.set_panel_label("leg")
    assert {p.label for p in group.panels()} == {"leg"}


def test_a_part_is_placed_below_and_by_interface():
    above, below = rectangle("above").translate_to([0.0, 100.0, 20.0]), rectangle("below")
    below.place_below(above, gap=2.0)
    assert below.bbox_3d()[1][1] == pytest.approx(98)
    below.place_by_interface(below.interfaces["top"], above.interfaces["bottom"], gap=5.0)
    assert below.bbox_3d()[1][1] == pytest.approx(95)
    assert below.bbox_3d()[0][2] == pytest.approx(20)
    below.place_by_interface(
        below.interfaces["top"],
        above.interfaces["bottom"],
        gap=1.0,
        alignment="left",
        gap_dir=[1.0, 0.0, 0.0],
    )
    assert below.bbox_3d()[1][0] == pytest.approx(above.bbox_3d()[1][0] - 1)


def test_copies_stand_around_the_body_or_in_a_row():
    first = rectangle("first").translate_to([-30.0, 100.0, 0.0])
    first.rotate_to(Rotation.from_euler(0.0, -90.0, 0.0))
    around = distribute_y(first, 4, "gore")
    assert [p.name for p in around] == ["gore_0", "gore_1", "gore_2", "gore_3"]
    assert around[2].translation == pytest.approx([30, 100, 0], abs=1e-9)
    assert around[0].interfaces["top"].panel[0] is around[0]
    assert around[3].interfaces["top"].edges[0] in around[3].edges
    row = distribute_horizontally(rectangle("first").translate_to([0.0, 0.0, 20.0]), 3, -15.0, "insert")
    assert [p.translation[0] for p in row] == pytest.approx([0, 15, 30])


def test_an_open_panel_is_refused():
    panel = rectangle()
    panel.edges.pop(2)
    with pytest.raises(DesignError, match="would be open by 60"):
        panel.assembly()
