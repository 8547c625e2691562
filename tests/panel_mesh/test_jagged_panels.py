"""Outlines with very many, very short or very jagged edges."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
import shapely
from filled_polygons import areas, assert_fills, delaunay
from hypothesis import assume, example, given, settings
from hypothesis import strategies as st

from swifttailor.errors import GeometryError
from swifttailor.panel_mesh import mesh_pattern, triangulate
from swifttailor.panel_mesh.constrained_edges import _Flippable, recover_edges
from swifttailor.panel_mesh.triangulate import triangulate_polygon
from swifttailor.pattern import Edge, EdgeRef, Panel, Pattern, Placement, Stitch

SEEDS = st.integers(0, 2**32 - 1)


def saw(rng, count, *, width=60.0, height=90.0, depth=6.0):
    """A panel whose hems are teeth of uneven depth."""
    across = np.linspace(-width / 2, width / 2, count // 2)
    teeth = (np.arange(count // 2) % 2) * depth * rng.uniform(0.2, 1.0, (2, count // 2))
    lower = np.stack([across, teeth[0]], axis=1)
    return np.concatenate([lower, np.stack([across[::-1], height - teeth[1]], axis=1)])


def star(rng, count, size=60.0):
    """A panel whose corners jump in and out."""
    angles = np.linspace(0, 2 * np.pi, count, endpoint=False)
    radii = rng.uniform(size / 3, size, count)
    return radii[:, None] * np.stack([np.cos(angles), np.sin(angles)], axis=1)


@example(5, 240, 0.5, saw)  # far finer than its teeth; others are not, for it takes a second
@given(SEEDS, st.integers(8, 240), st.sampled_from([1.5, 3.0, 8.0]), st.sampled_from([saw, star]))
@settings(max_examples=40, deadline=None)
def test_jagged_outlines_are_filled_to_the_last_tooth(seed, count, edge_length, shape):
    boundary = shape(np.random.default_rng(seed), count)
    assert_fills(boundary, *triangulate_polygon(boundary, edge_length))


@example(3254296740, 245, 0.9254221026636861)  # three corners on a line
@given(SEEDS, st.integers(3, 400), st.floats(0.01, 1.0))
@settings(max_examples=40, deadline=None)
def test_tiny_outlines_of_many_edges_are_filled(seed, count, size):
    """Far smaller than the edge length: no point lies inside."""
    boundary = star(np.random.default_rng(seed), count, size)
    points, faces = triangulate_polygon(boundary, 2.0)
    assert_fills(boundary, points, faces)
    assert len(points) == count and len(faces) == count - 2


@pytest.mark.parametrize("edge_length", [2.0, 8.0])
@pytest.mark.parametrize("shape", [saw, star])
def test_the_most_jagged_panel_that_is_accepted_is_filled(shape, edge_length):
    boundary = shape(np.random.default_rng(1), 2000)
    assert_fills(boundary, *triangulate_polygon(boundary, edge_length))


@given(SEEDS, st.integers(8, 150), st.sampled_from([1.0, 3.0]), st.sampled_from([saw, star]))
@settings(max_examples=40, deadline=None)
def test_both_ways_to_keep_clear_of_the_outline_agree(seed, count, clearance, shape):
    """But for points at its border, since the set-back outline has arcs of a few straight pieces."""
    rng = np.random.default_rng(seed)
    boundary = shape(rng, count)
    points = rng.uniform(boundary.min(axis=0), boundary.max(axis=0), (500, 2))
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(triangulate, "_MANY_CORNERS", count)
        by_outline = triangulate._well_inside(points, boundary, clearance)
        patch.setattr(triangulate, "_MANY_CORNERS", -1)
        by_distance = triangulate._well_inside(points, boundary, clearance)
    distance = shapely.distance(shapely.LinearRing(boundary), shapely.points(points))
    inside = shapely.contains_xy(shapely.Polygon(boundary), *points.T)
    assert (by_distance == inside & (distance > clearance)).all()
    assert not (by_outline != by_distance)[abs(distance - clearance) > 0.05 * clearance].any()


def crossed(mesh, a, b):
    """Plain reference of `_Flippable._walk`: all edges that the segment from a to b passes through."""
    segment = shapely.LineString([mesh.xy[a], mesh.xy[b]])
    inner = [edge for edge in mesh.left if edge[0] < edge[1] and not {a, b} & set(edge)]
    return {edge for edge in inner if segment.crosses(shapely.LineString([mesh.xy[v] for v in edge]))}


@given(SEEDS, st.integers(5, 60))
@settings(max_examples=60, deadline=None)
def test_walking_finds_what_a_search_of_all_edges_finds(seed, count):
    rng = np.random.default_rng(seed)
    points = rng.uniform(0, 10, (count, 2))
    mesh = _Flippable(points, delaunay(points)[0], np.full(count, -1))
    for a, b in rng.integers(0, count, (10, 2)).tolist():
        if a == b or (a, b) in mesh.left or (b, a) in mesh.left:
            continue
        walked = mesh._walk(a, b)
        assert walked is not None and set(walked) == crossed(mesh, a, b) == set(mesh._search(a, b))
        assert mesh._nearest_first(walked, a) == mesh._search(a, b)


@given(SEEDS, st.integers(6, 40))
@settings(max_examples=60, deadline=None)
def test_any_edges_that_do_not_cross_are_recovered(seed, count):
    """A line through all points of a cloud, from left to right."""
    rng = np.random.default_rng(seed)
    points = rng.uniform(-10, 10, (count, 2))
    faces, neighbors = delaunay(points)
    order = np.argsort(points[:, 0])
    following = np.full(count, -1)
    following[order[:-1]] = order[1:]
    recovered, _ = recover_edges(points, faces, neighbors, following)
    halves = {frozenset((int(f[k]), int(f[(k + 1) % 3]))) for f in recovered for k in range(3)}
    assert all(frozenset((int(a), int(b))) in halves for a, b in pairwise(order))
    assert (areas(points, recovered) > 0).all() and len(recovered) == len(faces)
    assert np.isclose(areas(points, recovered).sum(), areas(points, faces).sum())


@given(SEEDS, st.integers(4, 120), st.booleans())
@settings(max_examples=25, deadline=None)
def test_jagged_panels_are_sewn_whole_or_refused(seed, count, alike):
    rng = np.random.default_rng(seed)
    front = saw(rng, 2 * count)
    back = front if alike else saw(rng, 2 * count)
    panels = [
        Panel(name, corners, (Edge(),) * len(corners), Placement((0.0, 20.0, z)))
        for name, corners, z in (("front", front, 25.0), ("back", back, -25.0))
    ]
    panels[1] = panels[1].reversed()
    last = 2 * count - 1
    stitches = tuple(Stitch(EdgeRef("front", k), EdgeRef("back", last - k)) for k in (count - 1, last))
    pattern = Pattern((panels[0], panels[1]), stitches)
    mesh = mesh_pattern(pattern, 4.0)
    for k, corners in enumerate((front, back)):
        own = mesh.flat_faces[mesh.flat_panel[mesh.flat_faces[:, 0]] == k]
        assert np.isclose(abs(areas(mesh.flat_vertices, own)).sum(), shapely.Polygon(corners).area)


@given(SEEDS, st.integers(5, 60))
@settings(max_examples=40, deadline=None)
def test_outlines_that_cross_themselves_are_refused(seed, count):
    boundary = np.random.default_rng(seed).uniform(-20, 20, (count, 2))
    assume(not shapely.LinearRing(boundary).is_simple)
    with pytest.raises(GeometryError, match="crosses or touches itself"):
        triangulate_polygon(boundary, 2.0)
