from __future__ import annotations

import re
from collections import Counter, defaultdict
from itertools import combinations
from xml.etree import ElementTree

import numpy as np
import pytest
import shapely
from hypothesis import given, settings
from hypothesis import strategies as st
from svg_paths import pieces

from swifttailor.pattern import Arc, Cubic, Edge, EdgeRef, Line, Panel, Pattern, Quadratic, Stitch
from swifttailor.pattern.svg import pattern_to_svg, write_svg
from swifttailor.pattern.svg.paths import number

NS = "{http://www.w3.org/2000/svg}"


class Drawing:
    """A parsed drawing with its panels in sheet coordinates, mm with y down."""

    def __init__(self, text: str) -> None:
        self.root = ElementTree.fromstring(text)
        self.panels = {}
        for group in self.root.iter(f"{NS}g"):
            if group.get("class") == "panel":
                shift = re.fullmatch(r"translate\((\S+) (\S+)\)", group.get("transform"))
                self.panels[group.get("data-panel")] = group, np.array([float(v) for v in shift.groups()])

    @property
    def size(self) -> np.ndarray:
        return np.array([float(self.root.get(k).removesuffix("mm")) for k in ("width", "height")])

    def edges(self, panel: str) -> list:
        group, _ = self.panels[panel]
        return [p for p in group.iter(f"{NS}path") if p.get("data-edge") is not None]

    def outline(self, panel: str) -> np.ndarray:
        group, shift = self.panels[panel]
        cloth = next(p for p in group.iter(f"{NS}path") if p.get("class") == "cloth")
        t = np.linspace(0, 1, 33)[:-1]
        return np.concatenate([p.points(t) for p in pieces(cloth.get("d"))]) + shift

    def box(self, panel: str) -> shapely.Polygon:
        outline = self.outline(panel)
        return shapely.box(*outline.min(axis=0), *outline.max(axis=0))


def every_curve(name: str = "all", mirrored: bool = False) -> Panel:
    vertices = np.array([[3.0, 2], [33, 0], [40, 20], [30, 41.3], [10, 43], [0.1, 22]])
    edges = (
        Edge(),
        Edge(Quadratic((0.4, -0.21))),
        Edge(Cubic((0.2, -0.1), (0.7, 0.13))),
        Edge(Arc(14.0, False, True)),
        Edge(Arc(17.0, False, False)),
        Edge(Arc(10.5, True, True)),
    )
    panel = Panel(name, vertices, edges)
    return panel.mirrored() if mirrored else panel


@pytest.mark.parametrize("mirrored", [False, True])
def test_edges_are_exact_and_in_place(mirrored):
    panel = every_curve(mirrored=mirrored)
    drawing = Drawing(pattern_to_svg(Pattern((panel,))))
    shown = panel.mirrored() if panel.signed_area() < 0 else panel
    t = np.linspace(0, 1, 9)
    for k, path in enumerate(drawing.edges("all")):
        assert int(path.get("data-edge")) == k
        (piece,) = pieces(path.get("d"))
        assert abs(piece.length() / 10 - panel.edge_length(k)) < 1e-6
        expected = shown.sample_edge(k, 9) * (10, -10)
        if piece.kind in "LA":  # these run evenly along the length
            np.testing.assert_allclose(piece.points(t), expected, atol=1e-6)
        np.testing.assert_allclose(piece.points(t[[0, -1]]), expected[[0, -1]], atol=1e-9)
    kinds = [pieces(p.get("d"))[0].kind for p in drawing.edges("all")]
    assert kinds == ["L", "Q", "C", "A", "A", "A"]
    outline = shapely.Polygon(drawing.outline("all"))
    exact = shapely.Polygon(panel.outline(0.0005) * 10)
    assert abs(outline.area - exact.area) < 2e-3 * exact.area


@settings(max_examples=60, deadline=None)
@given(st.integers(0, 2**32 - 1))
def test_lengths_survive_whatever_the_shape(seed):
    rng = np.random.default_rng(seed)
    count = int(rng.integers(2, 7))
    scale = 10.0 ** rng.uniform(-1, 3)
    vertices = rng.normal(0, scale, (count, 2))
    edges = []
    for k in range(count):
        chord = float(np.hypot(*(vertices[(k + 1) % count] - vertices[k])))
        edges.append(
            Edge(
                [
                    Line(),
                    Quadratic(tuple(rng.uniform(-1, 1, 2))),
                    Cubic(tuple(rng.uniform(-1, 1, 2)), tuple(rng.uniform(-1, 1, 2))),
                    Arc(chord * rng.uniform(0.501, 3), bool(rng.integers(2)), bool(rng.integers(2))),
                ][rng.integers(4)]
            )
        )
    panel = Panel("p", vertices, tuple(edges))
    for k, path in enumerate(Drawing(pattern_to_svg(Pattern((panel,)))).edges("p")):
        (piece,) = pieces(path.get("d"))
        assert abs(piece.length() / 10 - panel.edge_length(k)) < 1e-6 * max(1.0, scale)


def test_semicircles_and_radii_too_small_keep_their_length():
    panel = Panel(
        "p", np.array([[0.3, 0.1], [40.7, 11.9]]), (Edge(Arc(21.04444, False, True)), Edge(Arc(5, 0, 1)))
    )
    for k, path in enumerate(Drawing(pattern_to_svg(Pattern((panel,)))).edges("p")):
        assert abs(pieces(path.get("d"))[0].length() / 10 - panel.edge_length(k)) < 1e-6


def test_right_side_of_the_cloth_faces_the_viewer():
    """On paper (y up) every loop runs anticlockwise, whichever way it was described."""
    pattern = Pattern((every_curve("a"), every_curve("b", mirrored=True)))
    drawing = Drawing(pattern_to_svg(pattern))
    outlines = []
    for name in ("a", "b"):
        x, y = (drawing.outline(name) * (1, -1)).T
        assert x @ np.roll(y, -1) - np.roll(x, -1) @ y > 0
        outlines.append(drawing.outline(name) - drawing.panels[name][1])
    np.testing.assert_allclose(outlines[0], outlines[1], atol=1e-9)
    assert [drawing.panels[n][0].get("data-mirrored") for n in ("a", "b")] == ["0", "1"]


def many_panels(count: int, seed: int = 3) -> Pattern:
    rng = np.random.default_rng(seed)
    panels = []
    for k in range(count):
        w, h = 10.0 ** rng.uniform(-0.5, 2.2, 2)
        x, y = rng.normal(0, 100, 2)
        loop = np.array([[x, y], [x + w, y], [x + w, y + h], [x, y + h]])
        panels.append(Panel(f"panel_with_a_long_name_{k}", loop, (Edge(),) * 4))
    stitches = tuple(
        Stitch(EdgeRef(panels[k].name, 1), EdgeRef(panels[k + 1].name, 3)) for k in range(count - 1)
    )
    return Pattern(tuple(panels), stitches, "many")


@pytest.mark.parametrize("count", [1, 2, 7, 36])
def test_panels_do_not_overlap_and_stay_on_the_sheet(count):
    drawing = Drawing(pattern_to_svg(many_panels(count)))
    boxes = [drawing.box(name) for name in drawing.panels]
    assert len(boxes) == count
    for one, two in combinations(boxes, 2):
        assert one.distance(two) > 1.0
    sheet = shapely.box(0, 0, *drawing.size)
    assert all(sheet.buffer(-1).contains(b) for b in boxes)
    view = [float(v) for v in drawing.root.get("viewBox").split()]
    np.testing.assert_allclose(view, [0, 0, *drawing.size])


def test_slivers_and_huge_panels():
    sliver = Panel("sliver", np.array([[0.0, 0], [12, 0], [12, 0.008], [0, 0.008]]), (Edge(),) * 4)
    point = Panel("point", np.array([[1.0, 1], [1, 1], [1, 1]]), (Edge(),) * 3)
    huge = Panel("huge", np.array([[0.0, 0], [1400, 0], [1400, 90], [0, 90]]), (Edge(),) * 4)
    pattern = Pattern((sliver, huge, point), (Stitch(EdgeRef("sliver", 0), EdgeRef("huge", 2)),))
    drawing = Drawing(pattern_to_svg(pattern))
    assert 14_000 < drawing.size[0] < 17_000
    widths = np.ptp(drawing.outline("huge"), axis=0)
    np.testing.assert_allclose(widths, [14_000, 900])
    gathered = drawing.edges("huge")[2]
    assert "gather" in gathered.get("class") and "gather" not in drawing.edges("sliver")[0].get("class")
    small = Drawing(pattern_to_svg(Pattern((sliver,))))
    assert small.size.max() < 400


def test_a_pattern_without_panels_is_still_a_sheet():
    assert Drawing(pattern_to_svg(Pattern(()))).size.min() > 0


def test_pairs_share_colour_and_number_and_nothing_else_does():
    pattern = many_panels(9)
    drawing = Drawing(pattern_to_svg(pattern))
    by_stitch = defaultdict(list)
    for name in drawing.panels:
        for path in drawing.edges(name):
            if path.get("data-stitch") is None:
                assert "free" in path.get("class") and path.get("stroke") is None
                continue
            by_stitch[int(path.get("data-stitch"))].append(
                (EdgeRef(name, int(path.get("data-edge"))), path.get("stroke"))
            )
    assert sorted(by_stitch) == list(range(len(pattern.stitches)))
    for k, ends in by_stitch.items():
        assert {ref for ref, _ in ends} == set(pattern.stitches[k].sides)
        assert len({color for _, color in ends}) == 1
    shown = Counter(t.text for t in drawing.root.iter(f"{NS}text") if t.get("class") == "number")
    assert set(shown.values()) <= {1, 2} and set(shown) <= {str(k) for k in by_stitch}
    assert sum(shown.values()) > len(pattern.stitches)


def test_darts_and_right_wrong_are_marked():
    notch = np.array([[0.0, 0], [20, 0], [22, 15], [24, 0], [50, 0], [50, 50], [0, 50]])
    panel = Panel("front", notch, (Edge(),) * 7)
    pattern = Pattern(
        (panel,),
        (
            Stitch(EdgeRef("front", 1), EdgeRef("front", 2)),
            Stitch(EdgeRef("front", 4), EdgeRef("front", 6), right_wrong=True),
        ),
    )
    drawing = Drawing(pattern_to_svg(pattern))
    classes = [p.get("class").removeprefix("edge ") for p in drawing.edges("front")]
    assert classes == ["free", "dart", "dart", "free", "seam", "free", "seam"]
    titles = [p.find(f"{NS}title").text for p in drawing.edges("front")]
    assert "right side to wrong side" in titles[4] and "right side to wrong side" not in titles[1]


def test_seam_numbers_lie_inside_their_panel():
    drawing = Drawing(
        pattern_to_svg(Pattern((every_curve("a"), every_curve("b", True)), _stitch_all("a", "b")))
    )
    for name, (group, shift) in drawing.panels.items():
        cloth = shapely.Polygon(drawing.outline(name)).buffer(0)
        numbers = [t for t in group.iter(f"{NS}text") if t.get("class") == "number"]
        assert len(numbers) == 6
        for text in numbers:
            assert cloth.contains(shapely.Point(np.array([float(text.get(k)) for k in "xy"]) + shift))


def _stitch_all(one: str, two: str) -> tuple[Stitch, ...]:
    return tuple(Stitch(EdgeRef(one, k), EdgeRef(two, k)) for k in range(6))


def test_names_with_markup_and_control_characters(tmp_path):
    names = ['<script>alert("x")</script>', "a & 'b'", "tab\tbell\x07", "\ud800lone", "衣服"]
    loop = np.array([[0.0, 0], [30, 0], [30, 30], [0, 30]])
    pattern = Pattern(tuple(Panel(n, loop, (Edge(),) * 4) for n in names), name="</svg>&")
    path = write_svg(pattern, tmp_path / "names.svg")
    drawing = Drawing(path.read_text(encoding="utf-8"))
    assert not list(drawing.root.iter(f"{NS}script"))
    shown = [t.text for t in drawing.root.iter(f"{NS}text") if t.get("class") == "name"]
    assert sorted(shown) == sorted([names[0], names[1], "tab bell ", " lone", "衣服"])
    assert drawing.root.find(f"{NS}title").text == "</svg>&"


def test_stitches_to_missing_edges_are_ignored():
    panel = every_curve()
    pattern = Pattern(
        (panel,),
        (Stitch(EdgeRef("all", 0), EdgeRef("gone", 2)), Stitch(EdgeRef("all", 1), EdgeRef("all", 9))),
    )
    assert all("free" in p.get("class") for p in Drawing(pattern_to_svg(pattern)).edges("all"))


def test_scale_bar_is_true():
    drawing = Drawing(pattern_to_svg(many_panels(5)))
    bar = next(p for p in drawing.root.iter(f"{NS}path") if p.get("class") == "bar")
    x = re.search(r"M([\d.]+),[\d.]+H([\d.]+)", bar.get("d"))
    length = float(x[2]) - float(x[1])
    assert length == pytest.approx(float(bar.get("data-length")), abs=2e-3)
    label = next(t.text for t in drawing.root.iter(f"{NS}text") if "print at 100" in (t.text or ""))
    assert label.startswith(f"{length / 10:.0f} cm")


def test_same_pattern_same_text():
    assert pattern_to_svg(many_panels(12)) == pattern_to_svg(many_panels(12))


def test_numbers_keep_all_digits():
    values = [0.1, -0.0, 1.0, 1e-7, 123456.789012345, 1 / 3]
    assert [float(number(v)) for v in values] == values
    assert number(-0.0) == "0" and number(3.0) == "3"
