"""What is kept of a garment for training, against the same computed afresh."""

from __future__ import annotations

import numpy as np
import pytest

from swifttailor.body import Body
from swifttailor.data.reader import SplitReader
from swifttailor.garment_sewer.pixels.body_distance import BodyDistance, panels_ignoring_arms
from swifttailor.garment_sewer.pixels.pixel_table import tabulate
from swifttailor.ggi import encode
from swifttailor.ggi.stitching import stitching_image
from swifttailor.training.sewer_samples import SIDE_POINTS, SewerSamples, choose_layout


@pytest.fixture(scope="module")
def reader(data):
    return SplitReader(data / "train")


@pytest.fixture(scope="module")
def samples(reader, tmp_path_factory):
    return SewerSamples(reader, tmp_path_factory.mktemp("cache"), 64, "sewn", layouts=2)


@pytest.mark.parametrize("k", [0, 3])
@pytest.mark.parametrize("number", [0, 1])
def test_is_what_is_computed_afresh(reader, samples, k, number):
    layout = choose_layout(reader[k], 64, number)
    sample, fresh = samples.get(k, number), tabulate(layout, "sewn", BodyDistance.of(Body.default()))
    table = sample.table
    for name in ("pixels", "panel", "contour", "partner", "panel_box"):
        assert np.array_equal(getattr(table, name), getattr(fresh, name)), name
    assert table.cm_per_pixel == layout.cm_per_pixel
    for name, tolerance in (
        ("point", 0.003),
        ("prior", 0.01),
        ("distance", 0.01),
        ("direction", 0.01),
        ("panel_color", 1e-6),
        ("mirror_color", 1e-6),
        ("panel_origin", 1e-4),
        ("panel_axes", 1e-6),
        ("panel_offset", 1e-4),
        ("panel_normal", 1e-6),
    ):
        assert np.abs(getattr(table, name) - getattr(fresh, name)).max() <= tolerance, name
    assert np.array_equal(sample.ignores_arms, panels_ignoring_arms(layout.pattern))


def test_target_is_the_geometry_image(reader, samples):
    images = encode(reader[0].garment, 64)
    sample = samples.get(0)
    assert images.geometry is not None
    assert np.abs(sample.target - images.geometry.reshape(-1, 3)[sample.table.pixels]).max() < 0.01


def test_distance_to_the_edge(samples):
    sample = samples.get(0)
    size = sample.table.resolution
    at = np.stack([sample.table.pixels // size, sample.table.pixels % size], axis=1)
    contour = at[sample.table.contour]
    chance = np.random.default_rng(0)
    for slot in chance.choice(len(at), 40):
        nearest = np.linalg.norm(contour - at[slot], axis=1).min()
        assert sample.edge_distance[slot] == np.ceil(nearest)


def test_sides_are_those_of_the_stitches(reader, samples):
    layout = choose_layout(reader[0], 64, 0)
    stitching = stitching_image(layout)
    sample = samples.get(0)
    assert len(sample.sides) == stitching.stitch_count
    for k in range(stitching.stitch_count):
        for b in (0, 1):
            pixels, _ = stitching.side(k, b)
            kept = sample.sides[k, b][sample.sides[k, b] >= 0]
            assert len(kept) == min(len(pixels), SIDE_POINTS)
            found = sample.table.pixels[kept]
            assert found[0] == pixels[0]
            assert found[-1] == pixels[-1]
            assert set(found.tolist()) <= set(pixels.tolist())


def test_long_sides_keep_evenly_spread_pixels():
    from swifttailor.training.sewer_samples import _spread_sides

    start = np.array([0, 200, 201])
    sides = _spread_sides(np.arange(201), start)[0]
    assert sides[0, 0] == 0
    assert sides[0, -1] == 199
    assert set(np.diff(sides[0]).tolist()) <= {3, 4}
    assert sides[1].tolist() == [200] + [-1] * (SIDE_POINTS - 1)


def test_further_layouts_are_coarser_and_always_the_same(reader):
    first = choose_layout(reader[0], 64, 0)
    others = [choose_layout(reader[0], 64, n) for n in (1, 2)]
    assert all(first.cm_per_pixel < o.cm_per_pixel <= 1.25 * first.cm_per_pixel for o in others)
    assert others[0].cm_per_pixel != others[1].cm_per_pixel
    assert choose_layout(reader[0], 64, 1).cm_per_pixel == others[0].cm_per_pixel
