"""The solver's neighbour lists against every vertex and every face."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import swifttailor
from swifttailor.draping import FABRICS
from swifttailor.draping.cloth import build_cloth
from swifttailor.draping.neighbor_lists import (
    AHEAD,
    FOLDED,
    MARGIN,
    MAX_REACH,
    MAX_SKIN,
    SKIN,
    has_moved,
    list_neighbors,
    no_neighbors,
)
from swifttailor.draping.spatial_grid import sort_into_cells
from swifttailor.panel_mesh import mesh_pattern


def crumpled(cloth, seed, speed):
    """Positions and velocities (v, 3) of cloth balled up so that far parts of it lie on each other."""
    rng = np.random.default_rng(seed)
    count = len(cloth.inverse_mass)
    x = np.cumsum(rng.normal(0.0, 0.2, (count, 3)), axis=0) % 14.0 + rng.normal(0.0, 0.3, (count, 3))
    fast = rng.uniform(size=(count, 1)) < 0.1
    return x, np.where(fast, speed, 0.05 * speed) * rng.normal(0.0, 1.0, (count, 3))


def is_stretched(x, cloth):
    """(f,) which faces are still stretched between two panels, and in no list."""
    return np.ptp(x[cloth.faces], axis=1).max(axis=1) > 8.0


def close_pairs(x, cloth, stretched):
    """Reference: (vertex, face) pairs near enough for a contact, but for surface neighbours."""
    rings = [
        set(cloth.neighbors[cloth.neighbor_start[p] : cloth.neighbor_start[p + 1]].tolist())
        for p in range(len(x))
    ]
    found = set()
    for f, (a, b, c) in enumerate(cloth.faces):
        u, w = x[b] - x[a], x[c] - x[a]
        if stretched[f]:
            continue
        basis = np.stack([u, w, np.cross(u, w) / max(np.linalg.norm(np.cross(u, w)), 1e-12)], axis=1)
        if abs(np.linalg.det(basis)) < 1e-3:
            continue
        s, t, height = np.linalg.solve(basis, (x - x[a]).T)
        limit = np.minimum(cloth.radius, cloth.radius[[a, b, c]].max()) + MARGIN * cloth.spacing
        near = (np.abs(height) < limit) & (s >= 0) & (t >= 0) & (s + t <= 1)
        found |= {
            (int(p), f)
            for p in np.flatnonzero(near)
            if p not in (a, b, c) and not rings[p] & {int(a), int(b), int(c)}
        }
    return found


def listed_pairs(x, v, cloth):
    """Reference: what is to be listed, every vertex against every face."""
    speed = np.linalg.norm(v, axis=1)
    skin = np.maximum(SKIN * cloth.spacing, np.minimum(2 * AHEAD * speed, MAX_SKIN * cloth.spacing))
    reach = cloth.radius + MARGIN * cloth.spacing
    half = np.linalg.norm(x[cloth.edges[:, 1]] - x[cloth.edges[:, 0]], axis=1) / 2
    half = np.repeat(np.minimum(half, min(0.65 * cloth.rest.mean(), MAX_REACH)), 2)
    np.maximum.at(reach, cloth.edges.ravel(), half)
    reach += skin / 2
    found = set()
    for f, corners in enumerate(cloth.faces):
        a, b, c = x[corners]
        if np.ptp(x[corners], axis=0).max() > 4 * MAX_REACH:
            continue
        u, w, away = b - a, c - a, x - a
        normal = np.cross(u, w) / np.linalg.norm(np.cross(u, w))
        limit = reach + skin[corners].max() / 2
        low, high = x[corners].min(axis=0), x[corners].max(axis=0)
        near = (np.abs(away @ normal) <= limit) & (np.maximum(low - x, x - high).max(axis=1) <= limit)
        s, t = np.linalg.pinv(np.stack([u, w], axis=1)) @ away.T
        folded = (s >= FOLDED) & (t >= FOLDED) & (s + t <= 1 - FOLDED)
        ring = np.isin(cloth.edges, corners)
        beside = np.zeros(len(x), bool)
        beside[cloth.edges[ring.any(axis=1)]] = True
        near &= ~beside | folded
        near[corners] = False
        found |= {(int(p), f) for p in np.flatnonzero(near)}
    return found


@pytest.fixture(scope="module")
def cloth():
    mesh = mesh_pattern(swifttailor.draft("tank-top").canonical(), 5.0)
    return build_cloth(mesh, FABRICS["cotton"]).arrays


@given(st.integers(0, 1000), st.sampled_from([0.0, 30.0, 200.0]))
@settings(max_examples=10, deadline=None)
def test_no_close_pair_is_missing_while_the_lists_are_valid(cloth, seed, speed):
    x, v = crumpled(cloth, seed, speed)
    lists = list_neighbors(x, v, cloth, no_neighbors())
    pairs = list(zip(lists.vertex[: lists.count].tolist(), lists.face[: lists.count].tolist(), strict=True))
    assert len(set(pairs)) == len(pairs)
    assert np.all(np.diff(lists.face[: lists.count]) >= 0)
    stretched = is_stretched(x, cloth)
    near = close_pairs(x, cloth, stretched)
    assert near and near <= set(pairs)
    # Moved as far as the lists allow, each vertex in a direction of its own.
    step = np.random.default_rng(seed + 1).normal(size=x.shape)
    step *= (0.499 * lists.skin / np.linalg.norm(step, axis=1))[:, None]
    assert not has_moved(x + step, lists)
    assert close_pairs(x + step, cloth, stretched | is_stretched(x + step, cloth)) <= set(pairs)
    step[0] *= 1.01
    assert has_moved(x + step, lists)


@pytest.mark.parametrize("speed", [0.0, 200.0])
def test_the_search_by_blocks_lists_what_looking_everywhere_does(cloth, speed):
    x, v = crumpled(cloth, 5, speed)
    lists = list_neighbors(x, v, cloth, no_neighbors())
    pairs = set(zip(lists.vertex[: lists.count].tolist(), lists.face[: lists.count].tolist(), strict=True))
    expected = listed_pairs(x, v, cloth)
    assert len(expected) > 1000 and len(pairs ^ expected) <= 1e-4 * len(expected)


def test_fast_vertices_get_a_longer_skin(cloth):
    x, v = crumpled(cloth, 3, 200.0)
    lists = list_neighbors(x, v, cloth, no_neighbors())
    speed = np.linalg.norm(v, axis=1)
    order = np.argsort(speed)
    assert np.all(np.diff(lists.skin[order]) >= 0)
    assert lists.skin.max() > 1.3 * lists.skin.min()


@given(st.integers(0, 1000), st.floats(0.3, 5.0))
@settings(max_examples=25, deadline=None)
def test_every_point_is_in_its_cell(seed, cell):
    rng = np.random.default_rng(seed)
    points = rng.normal(0.0, 10.0, (40, 3))
    chosen = rng.uniform(size=40) < 0.7
    grid = sort_into_cells(points, chosen, cell)
    assert sorted(grid.ids.tolist()) == np.flatnonzero(chosen).tolist()
    assert len(grid.start) == grid.size.prod() + 1
    for q in range(len(grid.start) - 1):
        for i in grid.ids[grid.start[q] : grid.start[q + 1]]:
            at = np.floor((points[i] - grid.low) / grid.cell).astype(int)
            assert q == (at[0] * grid.size[1] + at[1]) * grid.size[2] + at[2]


def test_points_that_are_nowhere_are_left_out():
    points = np.array([[0.0, 0.0, 0.0], [np.nan, 1.0, 1.0], [1.0, np.inf, 1.0], [1e5, 0.0, 0.0]])
    grid = sort_into_cells(points, np.ones(4, bool), 0.5)
    assert sorted(grid.ids.tolist()) == [0, 3]
    assert grid.size.prod() < 10_000  # cells grew instead of filling memory
    nothing = sort_into_cells(points[1:3], np.ones(2, bool), 0.5)
    assert len(nothing.ids) == 0
