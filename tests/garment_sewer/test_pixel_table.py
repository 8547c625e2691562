"""What is known of each pixel, and the same of the mirrored and repacked garment."""

from __future__ import annotations

from dataclasses import fields, replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from swifttailor.garment_sewer.augmentation import mirror, mirror_points, move_panels, random_steps
from swifttailor.garment_sewer.pixels.pixel_table import mirror_partners, tabulate
from swifttailor.ggi import lay_out
from swifttailor.ggi.layout import BORDER
from swifttailor.ggi.stitching import stitching_image
from swifttailor.pattern import Panel, Pattern, Placement
from swifttailor.pattern.drafts import draft


def mirrored_panel(panel: Panel) -> Panel:
    """The panel of the garment mirrored left to right: a clean reference in the pattern's own terms."""
    x, y, z = panel.placement.translation
    a, b, c = panel.placement.rotation
    placement = Placement((-x, y, z), (a, -b, -c), panel.placement.reading)
    return replace(panel.mirrored().reversed(), placement=placement)


def test_pixels_stand_where_the_pattern_places_them(layout, table):
    local = layout.local_points()
    assert np.allclose(table.local(), local, atol=1e-3)
    for k, panel in enumerate(layout.pattern.panels):
        own = table.panel == k
        assert np.allclose(table.placed()[own], panel.to_world(local[own]), atol=2e-3)
        assert np.allclose(table.panel_normal[k], panel.normal(), atol=1e-6)


def test_placed_prior_is_the_placed_position(layout, body_distance):
    placed = tabulate(layout, "placed", body_distance)
    assert np.allclose(placed.prior, placed.placed(), atol=1e-4)
    distance, direction = body_distance.sample(
        placed.prior.astype(float),
        np.array(["skirt" in p.name or "pant" in p.name or "leg" in p.name for p in layout.pattern.panels])[
            placed.panel
        ],
    )
    assert np.allclose(placed.distance, distance, atol=1e-4)
    assert np.allclose(placed.direction, direction, atol=1e-4)


@pytest.mark.parametrize("prior", ["sewn", "hung"])
def test_prior_closes_the_seams(layout, body_distance, prior):
    table = tabulate(layout, prior, body_distance)
    sewn = np.flatnonzero(table.partner >= 0)
    gap = np.linalg.norm(table.prior[sewn] - table.prior[table.partner[sewn]], axis=1)
    assert np.median(gap) < 0.6 * table.cm_per_pixel
    placed = table.placed()
    apart = np.linalg.norm(placed[sewn] - placed[table.partner[sewn]], axis=1)
    assert gap.mean() < 0.1 * apart.mean()


def test_hung_prior_is_outside_the_body_and_does_not_slip(layout, table, body_distance):
    hung = tabulate(layout, "hung", body_distance)
    assert (hung.distance > -1.5).mean() > 0.97
    assert hung.prior[:, 1].mean() == pytest.approx(table.prior[:, 1].mean(), abs=5)
    assert hung.prior[:, 1].max() == pytest.approx(table.prior[:, 1].max(), abs=3)
    assert np.ptp(hung.prior[:, 1]) == pytest.approx(np.ptp(table.prior[:, 1]), abs=5)


def test_what_stands_out_falls_in_the_hung_prior(body_distance):
    skirt = lay_out(draft("circle-skirt"), 64)
    sewn, hung = (tabulate(skirt, kind, body_distance) for kind in ("sewn", "hung"))
    assert hung.prior[:, 1].mean() < sewn.prior[:, 1].mean() - 4


def test_partners_are_pixels_of_the_other_side(layout, table):
    stitching = stitching_image(layout)
    allowed: dict[int, set[int]] = {}
    for k in range(stitching.stitch_count):
        sides = [stitching.side(k, b)[0].tolist() for b in (0, 1)]
        for own, other in (sides, sides[::-1]):
            for pixel in own:
                allowed.setdefault(pixel, set()).update(other)
    for pixel, partner in zip(table.pixels.tolist(), table.partner.tolist(), strict=True):
        if partner < 0:
            assert pixel not in allowed
        else:
            assert int(table.pixels[partner]) in allowed[pixel]


def test_without_a_prior_nothing_is_known_in_space(layout):
    bare = tabulate(layout, "none", None)
    assert not bare.prior.any() and not bare.distance.any() and not bare.direction.any()


def test_mirroring_twice_gives_the_same(table):
    again = mirror(mirror(table))
    for field in fields(table):
        assert np.allclose(getattr(again, field.name), getattr(table, field.name), atol=1e-4), field.name


def test_mirrored_table_is_of_the_mirrored_panels(layout, table):
    other = mirror(table)
    assert np.allclose(other.placed(), mirror_points(table.placed()), atol=2e-3)
    assert np.array_equal(other.prior[:, 0], -table.prior[:, 0])
    assert np.array_equal(other.prior[:, 1:], table.prior[:, 1:])
    for k, panel in enumerate(layout.pattern.panels):
        reference = mirrored_panel(panel)
        own = other.panel == k
        assert np.allclose(reference.to_world(other.local()[own]), other.placed()[own], atol=2e-3)
        assert np.allclose(reference.normal(), other.panel_normal[k], atol=1e-6)


def test_mirrored_pixels_fill_the_same_boxes(table):
    other = mirror(table)
    size = table.resolution
    assert len(np.unique(other.pixels)) == len(table.pixels)
    left, low, right, top = other.panel_box[other.panel].T
    column, row = other.pixels % size, other.pixels // size
    assert ((column >= left) & (column <= right) & (row >= low) & (row <= top)).all()
    inner = ~other.contour
    cell = np.stack([column, row], axis=1)[inner]
    assert np.allclose(other.point[inner], cell + 0.5)


def test_mirrored_panels_take_the_colours_of_their_partners(layout, table):
    partner = mirror_partners(layout.pattern)
    assert np.array_equal(mirror(table).panel_color, table.panel_color[partner])


@pytest.mark.parametrize("name", ["t-shirt", "trousers", "hoodie", "jumpsuit"])
def test_left_and_right_are_each_others_partners(name):
    pattern = draft(name)
    partner = mirror_partners(pattern)
    assert np.array_equal(partner[partner], np.arange(len(partner)))
    for k, panel in enumerate(pattern.panels):
        other = pattern.panels[partner[k]].name
        swapped = panel.name.replace("left", "LEFT").replace("right", "left").replace("LEFT", "right")
        if swapped != panel.name:
            assert other == swapped


@given(st.integers(0, 2**32 - 1), st.sampled_from(["t-shirt", "shirt-dress", "gathered-skirt"]))
def test_repacked_panels_stay_apart_and_inside(seed, name):
    layout = lay_out(draft(name), 96)
    steps = random_steps(layout.boxes, 96, np.random.default_rng(seed))
    left, low = (layout.boxes[:, :2] + steps).T
    right, top = (layout.boxes[:, 2:] + steps).T
    assert min(left.min(), low.min()) >= BORDER
    assert max(right.max(), top.max()) < 96 - BORDER
    for a in range(len(left)):
        for b in range(a):
            across = max(left[a] - right[b], left[b] - right[a])
            along = max(low[a] - top[b], low[b] - top[a])
            assert max(across, along) > 2, "a gutter of two free pixels"


def test_moved_panels_keep_everything_but_their_place(table):
    steps = np.zeros((len(table.panel_origin), 2), np.int64)
    steps[0] = [1, 2]
    moved = move_panels(table, steps)
    own = table.panel == 0
    assert np.array_equal(moved.pixels[own], table.pixels[own] + 2 * table.resolution + 1)
    assert np.array_equal(moved.pixels[~own], table.pixels[~own])
    assert np.allclose(moved.placed(), table.placed(), atol=1e-3)


def test_some_order_of_a_loosely_packed_garment_moves_panels_past_each_other():
    pattern = draft("t-shirt")
    finest = lay_out(pattern, 96).cm_per_pixel
    layout = lay_out(pattern, 96, cm_per_pixel=finest * 1.25)
    steps = [random_steps(layout.boxes, 96, np.random.default_rng(k)) for k in range(8)]
    assert any(len(np.unique(s, axis=0)) > 1 for s in steps)


def test_pattern_of_one_panel():
    panel = draft("t-shirt").panels[0]
    layout = lay_out(Pattern((panel,), ()), 64)
    bare = tabulate(layout, "none", None)
    assert (bare.partner == -1).all()
