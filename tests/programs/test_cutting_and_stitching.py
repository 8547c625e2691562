from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from swifttailor.programs.cutting import cut_corner, cut_into_edge
from swifttailor.programs.design_error import DesignError
from swifttailor.programs.edge_sequence import EdgeSequence
from swifttailor.programs.edge_shapes import dart_shape, from_verts
from swifttailor.programs.edges import ArcEdge, BezierEdge, Edge
from swifttailor.programs.interface import Interface
from swifttailor.programs.panel import Panel
from swifttailor.programs.stitching import Stitches


def rectangle(name="panel", width=40.0, height=60.0) -> Panel:
    panel = Panel(name)
    panel.edges = from_verts([0.0, 0.0], [0.0, height], [width, height], [width, 0.0], loop=True)
    return panel


def bases():
    ends = [0.0, 0.0], [40.0, 5.0]
    return st.one_of(
        st.builds(lambda: Edge(*(list(e) for e in ends))),
        st.builds(lambda y: ArcEdge(*(list(e) for e in ends), y), st.floats(0.02, 0.5)),
        st.builds(lambda y: BezierEdge(*(list(e) for e in ends), [[0.4, y]]), st.floats(-0.4, 0.4)),
    )


@given(bases(), st.floats(1, 6), st.floats(10, 30), st.booleans())
def test_a_dart_lies_where_it_is_asked_for(base, width, offset, right):
    length = base.length()
    new, dart, rest = cut_into_edge(dart_shape(width, depth=5.0), base, offset, right)
    assert new.is_chained() and new[0].start is base.start and new[-1].end is base.end
    assert [len(dart), len(rest)] == [2, 2]
    assert math.dist(dart[0].start, dart[1].end) == pytest.approx(width, abs=1e-3)
    assert dart[0].length() == pytest.approx(dart[1].length()) == math.hypot(width / 2, 5.0)
    # What is left on both sides is what lies beside the opening.
    assert rest[0].length() + (length - rest[1].length()) == pytest.approx(2 * offset, abs=0.2)
    way = [b - a for a, b in zip(dart[0].start, dart[1].end, strict=True)]
    tip = [b - a for a, b in zip(dart[0].start, dart[0].end, strict=True)]
    assert (way[0] * tip[1] - way[1] * tip[0] < 0) == right


def test_a_cut_at_the_start_leaves_one_piece():
    base = Edge([0.0, 0.0], [20.0, 0.0])
    new, cut, rest = cut_into_edge(dart_shape(4.0, depth=3.0), base, offset=2.0)
    assert [len(new), len(cut), len(rest)] == [3, 2, 1] and cut[0].start is base.start


def test_a_cut_that_does_not_fit_is_refused():
    with pytest.raises(DesignError, match=r"4 cm wide does not fit 1 cm along an edge of 20 cm"):
        cut_into_edge(dart_shape(4.0, depth=3.0), Edge([0.0, 0.0], [20.0, 0.0]), offset=1.0)


def test_several_cuts_keep_their_distances():
    shapes = [from_verts([0.0, y], [2.0, y + 1], [0.0, y + 2]) for y in (0.0, 6.0)]
    base = Edge([0.0, 0.0], [0.0, 40.0])
    new, cut, rest = cut_into_edge(shapes, base, offset=20.0)
    assert new.is_chained() and [len(cut), len(rest)] == [4, 3]
    assert rest.lengths() == pytest.approx([16, 4, 16])


def test_a_corner_is_cut_and_its_interfaces_follow():
    panel = rectangle()
    top, side = panel.edges[1], panel.edges[2]
    panel.interfaces = {"top": Interface(panel, top), "side": Interface(panel, side)}
    shape = EdgeSequence(BezierEdge([10.0, 0.0], [0.0, 20.0], [[0.5, -0.2]]))
    cut, made = cut_corner(shape, Interface(panel, EdgeSequence(top, side)))
    assert panel.edges.is_loop() and panel.edges.is_chained() and len(panel.edges) == 5
    assert sorted(abs(a - b) for a, b in zip(cut[0].start, cut[-1].end, strict=True)) == pytest.approx(
        [10, 20], abs=1e-3
    )
    assert panel.interfaces["top"].edges.length() == pytest.approx(30, abs=1e-3)
    assert panel.interfaces["side"].edges.length() == pytest.approx(40, abs=1e-3)
    assert made in panel.interfaces.values()


def test_sides_of_unlike_edges_are_split_to_match():
    one, two = rectangle("one"), rectangle("two")
    parts = two.edges[1].subdivide_len([0.25, 0.75])
    two.edges.substitute(two.edges[1], parts)
    rules = Stitches((Interface(one, one.edges[1]), Interface(two, EdgeSequence(parts))))
    assert len(one.edges) == 5 and one.edges.is_chained()
    assert one.edges[1].length() == pytest.approx(10)
    for panel in (one, two):
        panel.assembly()
    assert [(s.first.edge, s.second.edge) for s in rules.assembly()] == [(1, 1), (2, 2)]


def test_a_flipped_edge_is_split_from_its_other_end():
    one, two = rectangle("one"), rectangle("two")
    parts = two.edges[1].subdivide_len([0.25, 0.75])
    two.edges.substitute(two.edges[1], parts)
    Stitches((Interface(one, one.edges[1]).flip_edges(), Interface(two, EdgeSequence(parts))))
    assert one.edges[1].length() == pytest.approx(30)


def test_a_gathered_side_is_split_where_its_partner_needs_it():
    wide, narrow = rectangle("wide", width=80.0), rectangle("narrow")
    parts = narrow.edges[1].subdivide_len([0.25, 0.75])
    narrow.edges.substitute(narrow.edges[1], parts)
    interface = Interface(wide, wide.edges[1], ruffle=2.0)
    assert interface.projecting_lengths() == pytest.approx([40])
    Stitches((interface, Interface(narrow, EdgeSequence(parts))))
    assert interface.edges.lengths() == pytest.approx([20, 60])


@given(
    st.lists(st.floats(0.1, 1), min_size=1, max_size=5), st.lists(st.floats(0.1, 1), min_size=1, max_size=5)
)
def test_both_sides_match_afterwards(one, two):
    sides = []
    for name, weights in (("one", one), ("two", two)):
        panel = rectangle(name)
        parts = panel.edges[1].subdivide_len([w / sum(weights) for w in weights])
        panel.edges.substitute(panel.edges[1], parts)
        sides.append(Interface(panel, EdgeSequence(parts)))
    rule = Stitches((sides[0], sides[1])).rules[0]
    assert rule.is_matching()
    for side in sides:
        assert side.panel[0].edges.is_chained() and side.edges.length() == pytest.approx(40)


def test_interfaces_are_joined_turned_and_reordered():
    panel = rectangle()
    one, two = Interface(panel, panel.edges[1], 2.0), Interface(panel, panel.edges[2:])
    both = Interface.from_multiple(one, two)
    assert [(r.coeff, r.first, r.last) for r in both.ruffle] == [(2.0, 0, 1), (1.0, 1, 3)]
    both.reverse(with_edge_dir_reverse=True)
    assert [(r.coeff, r.first, r.last) for r in both.ruffle] == [(2.0, 2, 3), (1.0, 0, 2)]
    assert both.edges_flipping == [True] * 3 and both.edges[2] is panel.edges[1]
    first, second = both.edges[0], both.edges[1]
    both.reorder([0, 1], [1, 0])
    assert both.edges[0] is second and both.edges[1] is first


def test_projected_edges_are_shortened_by_the_gathers_alone():
    panel = rectangle()
    chain = panel.edges[1:3]
    interface = Interface(panel, chain, ruffle=[2.0, 1.0])
    projected = interface.projecting_edges()
    assert projected.lengths() == pytest.approx([20, 60]) and projected.is_chained()
    assert chain.lengths() == pytest.approx([40, 60])
