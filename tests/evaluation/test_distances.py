"""Point clouds and the distances between them and between sets of them."""

from __future__ import annotations

import itertools

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from swifttailor.errors import GeometryError
from swifttailor.evaluation.garments.cloud_distances import (
    chamfer,
    chamfer_below,
    earth_mover,
    surface_distance,
)
from swifttailor.evaluation.garments.point_cloud import PointCloud, sample_surface
from swifttailor.evaluation.garments.set_distances import set_distances

SQUARE = np.array([[0.0, 0, 0], [10, 0, 0], [10, 10, 0], [0, 10, 0]])
TWO_FACES = np.array([[0, 1, 2], [0, 2, 3]], np.int32)


def cloud(seed: int, count: int = 40, shift=(0.0, 0.0, 0.0), scale: float = 1.0) -> PointCloud:
    return PointCloud(np.random.default_rng(seed).normal(0, scale, (count, 3)) + shift)


def sphere(seed: int, count: int, radius: float, center=(0.0, 0.0, 0.0)) -> PointCloud:
    points = np.random.default_rng(seed).normal(size=(count, 3))
    return PointCloud(points / np.linalg.norm(points, axis=1, keepdims=True) * radius + center)


def plain_chamfer(a: PointCloud, b: PointCloud) -> float:
    squared = ((a.points[:, None] - b.points[None]) ** 2).sum(axis=2)
    return squared.min(axis=1).mean() + squared.min(axis=0).mean()


def plain_sets(generated, references) -> tuple[float, float]:
    """MMD and COV by the definition, over all pairs."""
    table = np.array([[np.inf if s is None else plain_chamfer(s, r) for r in references] for s in generated])
    nearest = {int(row.argmin()) for s, row in zip(generated, table, strict=True) if s is not None}
    return table.min(axis=0).mean(), len(nearest) / len(references)


def test_points_lie_on_the_surface_evenly_by_area():
    faces = np.array([[0, 1, 2], [0, 2, 3], [4, 5, 6]], np.int32)
    far = np.array([[100.0, 0, 0], [130, 0, 0], [100, 20, 0]])  # 300 cm^2 beside 100 cm^2
    points = sample_surface(np.concatenate([SQUARE, far]), faces, 40_000, 3).points
    assert points.shape == (40_000, 3) and (points[:, 2] == 0).all()
    on_square = points[:, 0] < 50
    assert on_square.mean() == pytest.approx(0.25, abs=0.01)
    square = points[on_square]
    assert square.min() >= 0 and square[:, :2].max() <= 10
    counts = np.histogram2d(square[:, 0], square[:, 1], bins=5, range=[[0, 10], [0, 10]])[0]
    assert counts.min() > 0.8 * counts.mean() and counts.max() < 1.2 * counts.mean()
    first = square[: len(square) // 4]
    assert np.abs(first.mean(axis=0) - [5, 5, 0]).max() < 0.3  # any first part is a sample


def test_points_are_repeatable_and_differ_by_seed():
    a, b, c = (sample_surface(SQUARE, TWO_FACES, 50, seed).points for seed in ([1, 2], [1, 2], [1, 3]))
    assert np.array_equal(a, b) and not np.array_equal(a, c)


@pytest.mark.parametrize("vertices", [np.zeros((4, 3)), np.full((4, 3), np.nan)])
def test_a_surface_without_area_has_no_points(vertices):
    with pytest.raises(GeometryError, match="area"):
        sample_surface(vertices, TWO_FACES, 10, 0)
    with pytest.raises(GeometryError, match="0 faces"):
        sample_surface(SQUARE, TWO_FACES[:0], 10, 0)


def test_unit_box():
    boxed = cloud(0, shift=(5, -20, 3), scale=7).in_unit_box().points
    low, high = boxed.min(axis=0), boxed.max(axis=0)
    assert np.allclose(low + high, 0) and (high - low).max() == pytest.approx(2)
    moved = PointCloud(cloud(0, shift=(5, -20, 3), scale=7).points * 3 + 100).in_unit_box()
    assert np.allclose(moved.points, boxed)
    assert np.array_equal(PointCloud(np.ones((3, 3))).in_unit_box().points, np.zeros((3, 3)))


def test_a_cloud_has_no_more_points_than_it_has():
    assert len(cloud(0).first(7).points) == 7
    with pytest.raises(GeometryError, match="no first 41"):
        cloud(0).first(41)


def test_a_cloud_is_at_no_distance_from_itself():
    a = cloud(0, 300)
    assert chamfer(a, a) == surface_distance(a, a) == 0
    shuffled = PointCloud(a.points[::-1])
    assert chamfer(a, shuffled) == earth_mover(a, shuffled) == 0


def test_the_chamfer_distance_is_squared_and_the_sum_of_both_ways():
    a, b = PointCloud(np.zeros((1, 3))), PointCloud(np.array([[3.0, 0, 4.0], [0, 0, 10]]))
    assert chamfer(a, b) == pytest.approx(25 + (25 + 100) / 2)
    assert surface_distance(a, b) == pytest.approx((5 + 7.5) / 2)


def test_spheres_one_within_the_other():
    """Every point is 2 cm from the other sphere."""
    inner, outer = sphere(0, 20_000, 10.0), sphere(1, 20_000, 12.0)
    assert chamfer(inner, outer) == pytest.approx(2 * 2**2, rel=0.02)
    assert surface_distance(inner, outer) == pytest.approx(2, rel=0.01)


def test_a_small_shift_of_a_sphere():
    """A point whose normal is turned by t from the shift d is d cos t away: mean squared d^2 / 3 each way."""
    moved = sphere(1, 60_000, 50.0, center=(0, 3.0, 0))
    assert chamfer(sphere(0, 60_000, 50.0), moved) == pytest.approx(2 * 9 / 3, rel=0.1)


def test_the_earth_movers_distance_of_a_shift_is_its_length():
    a = cloud(0, 200)
    assert earth_mover(a, PointCloud(a.points[::-1] + np.array([6.0, 0, 8.0]))) == pytest.approx(10)
    with pytest.raises(GeometryError, match="40 and 41"):
        earth_mover(cloud(0, 40), cloud(0, 41))


def test_the_earth_movers_distance_is_the_least_over_all_assignments():
    for seed in range(5):
        a, b = cloud(seed, 6), cloud(seed + 100, 6)
        least = min(
            np.linalg.norm(a.points - b.points[list(p)], axis=1).mean()
            for p in itertools.permutations(range(6))
        )
        assert earth_mover(a, b) == pytest.approx(least)
        # No matching is shorter than going to the nearest point.
        assert earth_mover(a, b) >= max(b.tree.query(a.points)[0].mean(), a.tree.query(b.points)[0].mean())


@settings(max_examples=40, deadline=None)
@given(seed=st.integers(0, 10**6), counts=st.tuples(st.integers(1, 900), st.integers(1, 900)))
def test_chamfer_against_the_definition(seed, counts):
    a, b = cloud(seed, counts[0]), cloud(seed + 1, counts[1], shift=(1.0, 0, 0))
    exact = plain_chamfer(a, b)
    assert chamfer(a, b) == pytest.approx(exact)
    for limit in (0.3 * exact, 0.99 * exact, 1.01 * exact, np.inf):
        found, is_exact = chamfer_below(a, b, limit)
        assert is_exact == (limit > exact)
        assert found == pytest.approx(exact) if is_exact else limit <= found <= exact * (1 + 1e-9)


@settings(max_examples=20, deadline=None)
@given(st.data())
def test_sets_against_the_definition(data):
    seed = data.draw(st.integers(0, 10**6))
    chance = np.random.default_rng(seed)
    count, others = data.draw(st.integers(1, 7)), data.draw(st.integers(1, 7))
    references = [cloud(seed + k, 300, chance.uniform(-4, 4, 3)) for k in range(count)]
    generated = [
        None
        if k and chance.random() < 0.2
        else cloud(seed + 50 + k, 280, chance.uniform(-4, 4, 3), chance.uniform(0.5, 2))
        for k in range(others)
    ]
    found = set_distances(generated, references)
    mmd, coverage = plain_sets(generated, references)
    assert found.mmd == pytest.approx(mmd)
    assert found.coverage == pytest.approx(coverage)
    assert (found.references, found.failed) == (count, sum(c is None for c in generated))


def test_a_set_matches_itself_and_one_garment_covers_one():
    clouds = [cloud(k, 50, shift=(3.0 * k, 0, 0)) for k in range(6)]
    calls: list[int] = []
    same = set_distances(clouds, clouds, calls.append)
    assert (same.mmd, same.coverage) == (0, 1) and sum(calls) == 12
    collapsed = set_distances([clouds[2]] * 6, clouds)
    assert collapsed.coverage == pytest.approx(1 / 6) and collapsed.mmd > 1


def test_the_mmd_is_at_most_the_mean_distance_of_the_pairs():
    references = [cloud(k, 80, shift=(2.0 * k, 0, 0)) for k in range(5)]
    generated = [PointCloud(c.points + 0.3) for c in references]
    pairs = np.mean([chamfer(a, b) for a, b in zip(generated, references, strict=True)])
    assert 0 < set_distances(generated, references).mmd <= pairs


def test_missing_garments_are_nobodys_nearest():
    clouds = [cloud(k, 50, shift=(3.0 * k, 0, 0)) for k in range(4)]
    found = set_distances([None, *clouds[1:]], clouds)
    assert found.failed == 1 and found.coverage == 3 / 4
    assert found.mmd == pytest.approx(chamfer(clouds[0], clouds[1]) / 4)
    with pytest.raises(GeometryError, match="0 generated and 4"):
        set_distances([None], clouds)
