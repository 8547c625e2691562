"""Distances along the cloth, against plain geometry."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
import shapely
from hypothesis import given, settings
from hypothesis import strategies as st

from swifttailor.describing.measuring.cloth import Cloth, mutually_visible
from swifttailor.errors import GeometryError
from swifttailor.pattern import EdgeRef, Pattern, Placement, Stitch
from swifttailor.pattern.drafts import draft
from swifttailor.pattern.drafts.outline import annular_sector
from swifttailor.pattern.panel import Edge, Panel


def rectangle(name: str, width: float, height: float, placement: Placement | None = None) -> Panel:
    corners = [[0.0, 0.0], [width, 0.0], [width, height], [0.0, height]]
    return Panel(name, corners, (Edge(),) * 4, placement or Placement())


def between(cloth: Cloth, panel: str, start: int, end: int) -> float:
    """Distance along the cloth from one corner of a panel to another."""
    nodes = [cloth.node[cloth.samples[EdgeRef(panel, k)][0]] for k in (start, end)]
    return float(cloth.distances(np.array([nodes[0]]))[nodes[1]])


@given(st.floats(5, 80), st.floats(5, 80))
@settings(max_examples=25, deadline=None)
def test_across_a_rectangle_it_is_the_diagonal(width, height):
    cloth = Cloth.of(Pattern((rectangle("a", width, height),)))
    assert between(cloth, "a", 0, 2) == pytest.approx(math.hypot(width, height))


def test_the_way_leads_around_a_notch():
    """An L: the straight line between the tips lies outside of it."""
    corners = [[0, 0], [30, 0], [30, 10], [10, 10], [10, 40], [0, 40]]
    cloth = Cloth.of(Pattern((Panel("l", corners, (Edge(),) * 6),)))
    # From (30, 10) around the inner corner (10, 10) to (10, 40).
    assert between(cloth, "l", 2, 4) == pytest.approx(20 + 30)


def test_the_way_leads_across_seams_wherever_panels_are_placed():
    low = rectangle("low", 20, 30)
    high = rectangle("high", 20, 12, Placement((55.0, 300.0, -7.0), (0.0, 130.0, 20.0)))
    cloth = Cloth.of(Pattern((low, high), (Stitch(EdgeRef("low", 2), EdgeRef("high", 0)),)))
    start = cloth.node[cloth.samples[EdgeRef("low", 0)][0]]
    end = cloth.node[cloth.samples[EdgeRef("high", 2)][1]]
    # low's corner (0, 0) to high's corner (0, 12) sewn on top of it; edge 2 runs from right to left.
    far = cloth.node[cloth.samples[EdgeRef("high", 3)][0]]
    assert cloth.distances(np.array([start]))[far] == pytest.approx(42)
    assert cloth.distances(np.array([start]))[end] > 42


def test_a_gathered_seam_joins_equal_fractions():
    """40 cm sewn to 20 cm: the middle of one meets the middle of the other."""
    wide, narrow = rectangle("wide", 40, 10), rectangle("narrow", 20, 10)
    cloth = Cloth.of(Pattern((wide, narrow), (Stitch(EdgeRef("wide", 2), EdgeRef("narrow", 0)),)))
    a, b = cloth.samples[EdgeRef("wide", 2)], cloth.samples[EdgeRef("narrow", 0)]
    assert len(a) == len(b)
    np.testing.assert_array_equal(cloth.node[a], cloth.node[b[::-1]])


@given(st.floats(0.2, 1.6), st.floats(20, 90))
@settings(max_examples=20, deadline=None)
def test_down_a_circle_skirt_it_is_the_difference_of_radii(circles, length):
    top = 45.0
    sector = annular_sector("top", top, top + 2 * math.pi * circles / 2 * length, length, 0.0)
    panel = Panel(
        "skirt", [s.start for s in sector.sides], tuple(Edge(s.curve) for s in sector.sides), Placement()
    )
    cloth = Cloth.of(Pattern((panel,)))
    fall = cloth.distances(cloth.nodes([EdgeRef("skirt", 2)]))
    hem = cloth.nodes([EdgeRef("skirt", 0)])
    # Samples on large panels lie up to 10 cm apart, which lengthens the way by millimetres.
    np.testing.assert_allclose(fall[hem], length, atol=0.3, rtol=0.015)


@pytest.mark.parametrize("name", ["hoodie", "jumpsuit", "circle-skirt"])
def test_placement_does_not_change_distances(name):
    pattern = draft(name)
    rng = np.random.default_rng(5)
    moved = replace(
        pattern,
        panels=tuple(
            replace(
                p, placement=Placement(tuple(rng.uniform(-300, 300, 3)), tuple(rng.uniform(-180, 180, 3)))
            )
            for p in pattern.panels
        ),
    )
    one, other = Cloth.of(pattern), Cloth.of(moved)
    np.testing.assert_allclose(one.distances(np.array([0])), other.distances(np.array([0])), atol=1e-9)


@given(st.integers(0, 10_000))
@settings(max_examples=40, deadline=None)
def test_visibility_agrees_with_shapely(seed):
    """The fast test against shapely's covers on star-shaped polygons."""
    rng = np.random.default_rng(seed)
    angles = np.sort(rng.uniform(0, 2 * np.pi, 12))
    points = rng.uniform(5, 30, 12)[:, None] * np.stack([np.cos(angles), np.sin(angles)], axis=1)
    polygon = shapely.Polygon(points)
    if not polygon.is_valid:
        return
    seen = set(zip(*map(list, mutually_visible(points)), strict=True))
    for i in range(12):
        for j in range(i + 1, 12):
            along = points[i] + np.linspace(0, 1, 41)[:, None] * (points[j] - points[i])
            outside = shapely.distance(polygon, shapely.points(along))
            if polygon.covers(shapely.LineString(points[[i, j]])):
                assert (i, j) in seen
            if (outside > 0.2).mean() > 0.3:  # less may be the mouth of a notch on the border
                assert (i, j) not in seen


def test_unusable_stitches_are_left_out():
    panel = rectangle("a", 20, 20)
    stitches = (Stitch(EdgeRef("a", 0), EdgeRef("a", 9)), Stitch(EdgeRef("a", 1), EdgeRef("a", 1)))
    cloth = Cloth.of(Pattern((panel,), stitches))
    assert cloth.stitches == () and len(cloth.loops) == 1


@pytest.mark.parametrize(
    ("name", "count"), [("t-shirt", 4), ("circle-skirt", 2), ("trousers", 3), ("jumpsuit", 5), ("hoodie", 4)]
)
def test_borders_are_the_openings_of_the_garment(name, count):
    assert len(Cloth.of(draft(name)).loops) == count


def test_jagged_panels_are_refused_before_memory_runs_out():
    corners = [[40.0 * k / 1500, 0.05 * (k % 2)] for k in range(1500)] + [[40.0, 60.0], [0.0, 60.0]]
    jagged = Pattern((Panel("front", corners, tuple(Edge() for _ in corners)),))
    with pytest.raises(GeometryError, match="too jagged to be measured"):
        Cloth.of(jagged)
