"""Each trap of GarmentCode's format and its older relatives, in its own small file."""

from __future__ import annotations

import copy
import itertools
import json

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from swifttailor.errors import InputError, PatternError
from swifttailor.pattern import (
    Arc,
    EdgeRef,
    Line,
    Quadratic,
    Severity,
    Stitch,
    load_pattern,
    read_pattern_file,
    read_specification,
)


def specification(**panels):
    """A GarmentCode file with the given panels, each a (vertices, edges) pair or a whole panel object."""
    made = {}
    for name, panel in panels.items():
        if not isinstance(panel, dict):
            vertices, edges = panel
            panel = {
                "translation": [0, 100, 20],
                "rotation": [0, 0, 0],
                "vertices": vertices,
                "edges": edges,
                "label": "body",
            }
        made[name] = panel
    return {
        "pattern": {"panels": made, "stitches": [], "panel_order": list(made)},
        "parameters": {},
        "parameter_order": [],
        "properties": {
            "curvature_coords": "relative",
            "normalize_panel_translation": False,
            "normalized_edge_loops": True,
            "units_in_meter": 100,
        },
    }


CORNERS = [[0, 0], [10, 0], [10, 10], [0, 10]]


def loop(count=4, **curvature):
    """Edges of a closed loop; ``e1={...}`` gives edge 1 that curvature."""
    edges = [{"endpoints": [k, (k + 1) % count]} for k in range(count)]
    for key, value in curvature.items():
        edges[int(key[1:])]["curvature"] = value
    return edges


def codes(reading):
    return [f.code for f in reading.findings]


def test_a_plain_file_is_read_as_it_stands_without_findings():
    reading = read_specification(specification(front=(CORNERS, loop())), name="square")
    panel = reading.pattern.panel("front")
    assert reading.findings == () and reading.pattern.name == "square"
    assert panel.vertices.tolist() == CORNERS and panel.label == "body"
    assert panel.placement.translation == (0, 100, 20)
    assert panel.signed_area() == pytest.approx(100)


def test_other_units_scale_radii_and_translations_too():
    arc = {"type": "circle", "params": [60.0, 0, 1]}
    written = specification(front=(np.multiply(CORNERS, 10).tolist(), loop(e1=arc)))
    written["properties"]["units_in_meter"] = 1000
    reading = read_specification(written)
    panel = reading.pattern.panel("front")
    assert panel.vertices.tolist() == CORNERS
    assert panel.edges[1].curve == Arc(6.0, False, True)
    assert panel.placement.translation == pytest.approx((0, 10, 2))
    assert codes(reading) == ["other-units"] and reading.findings[0].severity is Severity.INFO


@pytest.mark.parametrize("units", [0, -100, 1e9, "cm", None, True])
def test_units_that_are_none_are_refused(units):
    written = specification(front=(CORNERS, loop()))
    written["properties"]["units_in_meter"] = units
    with pytest.raises(PatternError, match="units_in_meter"):
        read_specification(written)


def test_lengths_beyond_any_garment_after_conversion_are_refused():
    written = specification(front=([[0, 0], [9e6, 0], [0, 9e6]], loop(3)))
    written["properties"]["units_in_meter"] = 0.01
    with pytest.raises(PatternError, match="larger than any garment"):
        read_specification(written)


def test_absolute_control_points_become_relative():
    curve = {"type": "quadratic", "params": [[13.0, 5.0]]}
    written = specification(front=(CORNERS, loop(e1=curve)))
    written["properties"]["curvature_coords"] = "absolute"
    panel = read_specification(written).pattern.panel("front")
    assert panel.edges[1].curve == Quadratic((0.5, -0.3))  # to the right of travel
    assert panel.sample_edge(1, 3)[1] == pytest.approx([11.5, 5.0])
    written["properties"]["units_in_meter"] = 1000
    scaled = read_specification(written).pattern.panel("front")
    assert scaled.sample_edge(1, 3)[1] == pytest.approx([1.15, 0.5])


def test_an_absolute_control_point_far_from_a_vanishing_edge_is_refused():
    curve = {"type": "quadratic", "params": [[13.0, 5.0]]}
    written = specification(front=([[0, 0], [1e-9, 0], [10, 10]], loop(3, e0=curve)))
    written["properties"]["curvature_coords"] = "absolute"
    with pytest.raises(PatternError, match="all but coincide"):
        read_specification(written)


def test_a_bare_list_is_a_quadratic_curve():
    written = specification(front=(CORNERS, loop(e0=[0.5, -0.2])))
    assert read_specification(written).pattern.panel("front").edges[0].curve == Quadratic((0.5, -0.2))


def test_left_of_travel_is_positive():
    written = specification(front=(CORNERS, loop(e0={"type": "quadratic", "params": [[0.5, 0.2]]})))
    panel = read_specification(written).pattern.panel("front")
    assert panel.sample_edge(0, 3)[1] == pytest.approx([5.0, 1.0])  # into a counter-clockwise panel


def test_circle_flags_mean_large_and_right():
    written = specification(front=(CORNERS, loop(e0={"type": "circle", "params": [5.0, 0, 1]})))
    panel = read_specification(written).pattern.panel("front")
    assert panel.sample_edge(0, 3)[1] == pytest.approx([5.0, -5.0])
    for flag in (2, -1, 0.5, "1", None, []):
        curvature = {"type": "circle", "params": [5.0, 0, flag]}
        with pytest.raises(PatternError, match="0 or 1"):
            read_specification(specification(front=(CORNERS, loop(e0=curvature))))


def test_missing_labels_properties_placements_and_order_have_defaults():
    bare = {"pattern": {"panels": {"front": {"vertices": CORNERS, "edges": loop()}}}}
    reading = read_specification(bare)
    panel = reading.pattern.panel("front")
    assert panel.label == "" and panel.placement.translation == (0, 0, 0)
    assert reading.pattern.stitches == () and reading.findings == ()
    inner = read_specification(bare["pattern"])
    assert inner.pattern == reading.pattern


def test_null_labels_are_no_labels():
    written = specification(front=(CORNERS, [{**e, "label": None} for e in loop()]))
    written["pattern"]["panels"]["front"]["label"] = None
    assert read_specification(written).pattern.panel("front").label == ""


def _out_of_order(order, backwards):
    flipped = [backwards[k] for k in order]
    turns = {(b - a) % 5 for a, b in itertools.pairwise(order)}
    return (any(flipped), turns) != (False, {1}) and (all(flipped), turns) != (True, {4})


@settings(max_examples=40, deadline=None)
@given(st.permutations(range(5)), st.lists(st.booleans(), min_size=5, max_size=5))
def test_edges_out_of_order_or_backwards_give_the_same_outline_and_seams(order, backwards):
    corners = [[0, 0], [10, 0], [14, 6], [7, 12], [0, 10]]
    arc = Arc(9.0, False, True)
    straight = specification(a=(corners, loop(5, e2={"type": "circle", "params": [9.0, 0, 1]})),
                             b=(CORNERS, loop()))  # fmt: skip
    straight["pattern"]["stitches"] = [[{"panel": "a", "edge": 2}, {"panel": "b", "edge": 1}]]
    shuffled = copy.deepcopy(straight)
    edges = shuffled["pattern"]["panels"]["a"]["edges"]
    for edge, flip in zip(edges, backwards, strict=True):
        if flip:
            edge["endpoints"].reverse()
            if "curvature" in edge:
                edge["curvature"]["params"][2] = 0
    shuffled["pattern"]["panels"]["a"]["edges"] = [edges[k] for k in order]
    shuffled["pattern"]["stitches"][0][0]["edge"] = order.index(2)
    one, two = (read_specification(s).pattern for s in (straight, shuffled))
    area = one.panel("a").signed_area()
    # The direction that most edges have decides the right side of the cloth.
    assert two.panel("a").signed_area() == pytest.approx(area if sum(backwards) <= 2 else -area)
    ends = [
        {tuple(map(tuple, p.panel(r.panel).chord(r.edge))) for r in s.sides} for p in (one, two)
        for s in p.stitches
    ]  # fmt: skip
    seen = [{frozenset(e) for e in side} for side in ends]
    assert seen[0] == seen[1]
    curved = two.panel("a").edges[two.stitches[0].first.edge].curve
    assert curved in (arc, Arc(9.0, False, False))
    middle = one.panel("a").sample_edge(2, 3)[1]
    assert two.panel("a").sample_edge(two.stitches[0].first.edge, 3)[1] == pytest.approx(middle)
    found = codes(read_specification(shuffled))
    assert found == (["edge-order"] if _out_of_order(order, backwards) else [])


def test_a_gap_is_closed_by_a_straight_edge_and_reported():
    edges = loop()[:3]
    reading = read_specification(specification(front=(CORNERS, edges)))
    panel = reading.pattern.panel("front")
    assert codes(reading) == ["open-loop"] and reading.findings[0].severity is Severity.ERROR
    assert reading.findings[0].value == pytest.approx(10.0)
    assert panel.signed_area() == pytest.approx(100) and isinstance(panel.edges[3].curve, Line)


def test_ends_that_coincide_are_joined():
    corners = [*CORNERS, [0.0001, 0.0]]
    edges = [{"endpoints": [k, k + 1]} for k in range(4)]
    reading = read_specification(specification(front=(corners, edges)))
    assert len(reading.pattern.panel("front").edges) == 4
    assert reading.findings[0].repair == "--repair joins the two ends"


@pytest.mark.parametrize(
    ("vertices", "edges", "message"),
    [
        (CORNERS, [[0, 1], [1, 2], [2, 0], [0, 3]], "meet at vertex 0"),
        (CORNERS, [[0, 1], [2, 3]], "2 gaps"),
        (CORNERS, [[0, 0], [0, 1], [1, 2]], "to itself"),
        ([*CORNERS, [2, 2], [4, 2], [3, 4]],
         [[0, 1], [1, 2], [2, 3], [3, 0], [4, 5], [5, 6], [6, 4]], "more than one loop"),
        (CORNERS, [[0, 1], [1, 2], [2, 9]], "vertex 9 does not exist"),
        (CORNERS, [[0, 1], [1, 2], [2, -1]], "vertex -1 does not exist"),
    ],
)  # fmt: skip
def test_edges_that_form_no_loop_are_refused(vertices, edges, message):
    listed = [{"endpoints": e} for e in edges]
    with pytest.raises(PatternError, match=message):
        read_specification(specification(front=(vertices, listed)))


def test_unused_vertices_are_dropped_and_reported():
    corners = [[50, 50], *CORNERS]
    edges = [{"endpoints": [1 + k, 1 + (k + 1) % 4]} for k in range(4)]
    reading = read_specification(specification(front=(corners, edges)))
    assert codes(reading) == ["unused-vertex"] and reading.findings[0].severity is Severity.WARNING
    assert reading.pattern.panel("front").vertices.tolist() == CORNERS


def test_both_readings_of_the_rotations_are_offered():
    written = specification(front=(CORNERS, loop()))
    written["pattern"]["panels"]["front"]["rotation"] = [90, 45, 0]
    inner = read_specification(written).pattern.panel("front").placement.matrix()
    outer = read_specification(written, rotation="extrinsic").pattern.panel("front").placement.matrix()
    assert np.abs(inner - outer).max() > 0.2
    with pytest.raises(PatternError, match="'intrinsic' or 'extrinsic'"):
        read_specification(written, rotation="euler")


def test_vertex_zero_need_not_be_the_origin():
    corners = np.add(CORNERS, [0.37, -0.81]).tolist()
    panel = read_specification(specification(front=(corners, loop()))).pattern.panel("front")
    assert panel.vertices[0].tolist() == [0.37, -0.81]
    assert panel.to_world(panel.vertices)[0] == pytest.approx([0.37, 99.19, 20])


def test_the_order_of_panels_and_stitches_does_not_matter():
    written = specification(a=(CORNERS, loop()), b=(CORNERS, loop()), c=(CORNERS, loop()))
    sides = [[{"panel": "a", "edge": 1}, {"panel": "b", "edge": 3}],
             [{"panel": "c", "edge": 0}, {"panel": "b", "edge": 0}, "right_wrong"]]  # fmt: skip
    written["pattern"]["stitches"] = sides
    other = copy.deepcopy(written)
    other["pattern"]["panels"] = dict(reversed(other["pattern"]["panels"].items()))
    other["pattern"]["panel_order"].reverse()
    other["pattern"]["stitches"] = [[*s[1::-1], *s[2:]] for s in sides[::-1]]
    one, two = (read_specification(s).pattern for s in (written, other))
    assert one != two and one.canonical() == two.canonical()
    assert [p.name for p in two.panels] == ["c", "b", "a"]


def test_right_wrong_is_kept_and_nothing_else_accepted_there():
    written = specification(a=(CORNERS, loop()), b=(CORNERS, loop()))
    stitch = [{"panel": "a", "edge": 1}, {"panel": "b", "edge": 3}, "right_wrong"]
    written["pattern"]["stitches"] = [stitch]
    assert read_specification(written).pattern.stitches == (
        Stitch(EdgeRef("a", 1), EdgeRef("b", 3), right_wrong=True),
    )
    for flag in ("wrong_right", True, None, {}):
        written["pattern"]["stitches"] = [[*stitch[:2], flag]]
        with pytest.raises(PatternError, match="may only be 'right_wrong'"):
            read_specification(written)


def test_collinear_split_vertices_are_kept():
    corners = [[0, 0], [5, 0], [10, 0], [10, 10], [0, 10]]
    panel = read_specification(specification(front=(corners, loop(5)))).pattern.panel("front")
    assert len(panel.edges) == 5 and panel.edge_length(0) == 5.0


@pytest.mark.parametrize(("panel", "edge"), [("b", 0), ("a", 4), ("a", -1)])
def test_stitches_to_nowhere_are_left_out_and_reported(panel, edge):
    written = specification(a=(CORNERS, loop()))
    written["pattern"]["stitches"] = [[{"panel": "a", "edge": 1}, {"panel": panel, "edge": edge}]]
    reading = read_specification(written)
    assert reading.pattern.stitches == () and codes(reading) == ["dangling-stitch"]
    assert reading.findings[0].stitch == 0


def test_panel_order_that_misses_panels_is_replaced():
    written = specification(a=(CORNERS, loop()), b=(CORNERS, loop()))
    for order in (["a"], ["a", "a"], ["a", "b", "c"]):
        written["pattern"]["panel_order"] = order
        reading = read_specification(written)
        assert codes(reading) == ["panel-order"]
        assert [p.name for p in reading.pattern.panels] == ["a", "b"]


def test_unknown_keys_are_named_but_not_in_thousands():
    written = specification(a=(CORNERS, loop()))
    written["extra"] = 1
    written["pattern"]["panels"]["a"]["colour\x1b[31m"] = "red"
    reading = read_specification(written)
    assert codes(reading) == ["unknown-key"] * 2
    assert all(f.message.isprintable() and str(f.value).isprintable() for f in reading.findings)
    written["pattern"]["panels"]["a"] |= {f"key{k}": k for k in range(1000)}
    assert len(read_specification(written).findings) == 50


def test_too_many_panels_edges_and_vertices_are_refused():
    with pytest.raises(PatternError, match="at most 500"):
        read_specification(specification(**{f"p{k}": (CORNERS, loop()) for k in range(501)}))
    with pytest.raises(PatternError, match="at most 2000"):
        read_specification(specification(a=([[0, 0]] * 1_000_000, loop())))
    circle = np.stack([np.cos(np.arange(2000) / 318), np.sin(np.arange(2000) / 318)], axis=1) * 50
    big = (circle.tolist(), loop(2000))
    assert len(read_specification(specification(a=big)).pattern.panels[0].edges) == 2000
    with pytest.raises(PatternError, match="more than 20000 edges in all"):
        read_specification(specification(**{f"p{k}": big for k in range(11)}))


def test_loading_refuses_faulty_patterns_and_names_the_way_out(tmp_path):
    path = tmp_path / "dress_specification.json"
    path.write_text(json.dumps(specification(front=(CORNERS, loop()[:3]))))
    with pytest.raises(PatternError, match=r"open by 10 cm .*swifttailor check .*--repair"):
        load_pattern(path)
    reading = read_pattern_file(path)
    assert reading.pattern.name == "dress" and codes(reading) == ["open-loop"]
    path.write_text(json.dumps(specification(front=(CORNERS, loop()))))
    assert load_pattern(path).name == "dress"


def test_a_wrong_structure_names_its_place(tmp_path):
    path = tmp_path / "p.json"
    written = specification(front=(CORNERS, loop()))
    written["pattern"]["panels"]["front"]["vertices"][2] = [1, "x"]
    path.write_text(json.dumps(written))
    with pytest.raises(PatternError, match=r"p\.json'.*panel 'front'\.vertices\[2\]\[1\].*text"):
        load_pattern(path)
    with pytest.raises(InputError, match="No such file"):
        load_pattern(tmp_path / "missing.json")
