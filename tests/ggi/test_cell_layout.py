"""Each panel stretched to a cell of its own."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from ggi_patterns import HARD_CASES, any_garment, dart_pattern, patterns, rectangle
from hypothesis import given, settings
from hypothesis import strategies as st

from swifttailor.errors import InputError
from swifttailor.ggi import encode, lay_out
from swifttailor.ggi.file import write_ggi
from swifttailor.ggi.geometry import geometry_raster
from swifttailor.ggi.outline_decode import outline_sampler
from swifttailor.ggi.panel_cells import (
    LAYOUT_KINDS,
    MIN_CELL,
    cell_grid,
    lay_out_as,
    lay_out_in_cells,
    panel_cells,
)
from swifttailor.panel_mesh import mesh_pattern
from swifttailor.pattern import Line, Pattern
from swifttailor.pattern.drafts import draft

RESOLUTIONS = st.sampled_from([64, 100, 256])


@given(st.integers(1, 200))
def test_the_grid_has_room_and_no_empty_row(count):
    columns, rows = cell_grid(count)
    assert columns * (rows - 1) < count <= columns * rows
    assert rows <= columns and (columns - 1) ** 2 < count


@given(st.integers(1, 40), st.integers(16, 300))
def test_cells_are_disjoint_and_lie_in_the_square(count, resolution):
    columns = cell_grid(count)[0]
    if resolution // columns < MIN_CELL:
        with pytest.raises(InputError, match=f"{count} panels in {resolution} x {resolution}"):
            panel_cells(count, resolution)
        return
    taken = np.zeros((resolution, resolution), int)
    for x, y, width, height in panel_cells(count, resolution):
        assert min(width, height) >= MIN_CELL
        assert x >= 0 and y >= 0 and x + width <= resolution and y + height <= resolution
        taken[y : y + height, x : x + width] += 1
    assert taken.max() == 1


@settings(max_examples=40, deadline=None)
@given(patterns(), RESOLUTIONS)
def test_every_panel_fills_its_cell_but_for_a_margin(pattern, resolution):
    layout = lay_out_in_cells(pattern, resolution)
    cells = panel_cells(len(pattern.panels), resolution)
    wanted = np.concatenate([cells[:, :2] + 1, cells[:, :2] + cells[:, 2:] - 2], axis=1)
    assert np.array_equal(layout.boxes, wanted)
    raster = layout.raster
    row, column = np.divmod(raster.pixels, resolution)
    left, bottom, right, top = layout.boxes[raster.pixel_panel].T
    assert ((left <= column) & (column <= right) & (bottom <= row) & (row <= top)).all()
    assert set(raster.pixel_panel.tolist()) == set(range(len(pattern.panels)))


@settings(max_examples=40, deadline=None)
@given(patterns(most=4), RESOLUTIONS, st.data())
def test_pixels_and_centimetres_are_inverse(pattern, resolution, data):
    layout = lay_out_in_cells(pattern, resolution)
    index = data.draw(st.integers(0, len(pattern.panels) - 1))
    points = layout.pattern.panels[index].vertices
    pixels = layout.to_pixels(index, points)
    assert np.allclose(layout.to_local(index, pixels), points, rtol=0, atol=1e-9 * np.abs(points).max())
    # A step along x or y has the length that is said of it, along that axis alone.
    away = np.abs(pixels - pixels[0]) * layout.panel_cm_per_pixel[index]
    assert np.allclose(away, np.abs(points - points[0]), rtol=1e-9, atol=1e-9 * np.abs(points).max())
    assert layout.mirrored[index] == (layout.pattern.panels[index].signed_area() < 0)


def test_pixels_of_one_scale_are_as_long_as_wide():
    layout = lay_out(draft("t-shirt"), 64)
    assert (layout.panel_cm_per_pixel == layout.cm_per_pixel).all()


@settings(max_examples=20, deadline=None)
@given(patterns(most=5), st.randoms(use_true_random=False))
def test_the_order_of_panels_does_not_matter(pattern, random):
    shuffled = list(pattern.panels)
    random.shuffle(shuffled)
    one, two = (lay_out_in_cells(p, 100) for p in (pattern, replace(pattern, panels=tuple(shuffled))))
    assert one.pattern == two.pattern
    assert np.array_equal(one.origins, two.origins) and np.array_equal(one.stretch, two.stretch)


@pytest.mark.parametrize("kind", LAYOUT_KINDS)
@pytest.mark.parametrize("case", ["dart", "sliver", "t-shirt", "hoodie"])
def test_flat_panels_are_read_back_where_they_lie(kind, case):
    """Positions that are linear in the panel are the same at the vertices of any mesh, in either layout."""
    pattern = HARD_CASES[case]() if case in HARD_CASES else draft(case)
    layout = lay_out_as(kind, pattern, 128)
    mesh = mesh_pattern(layout.pattern, 3.0)
    panels = layout.pattern.panels

    def placed(panel, local):
        found = np.zeros((len(local), 3))
        for k, p in enumerate(panels):
            found[panel == k] = p.to_world(local[panel == k])
        return found

    seen = placed(layout.raster.pixel_panel, layout.local_points())
    read = outline_sampler(layout, mesh).weights @ seen
    off = np.linalg.norm(read - placed(mesh.flat_panel, mesh.flat_vertices), axis=1)
    inner = np.ones(len(off), bool)
    for runs in mesh.edge_vertices:
        inner[np.concatenate(runs)] = False
    coarsest = layout.panel_cm_per_pixel.max(axis=1)[mesh.flat_panel]
    straight = all(isinstance(e.curve, Line) for p in panels for e in p.edges)
    assert inner.any()
    # On curved edges, between two samples, a chord is read. At one scale, the sliver's two long edges share
    # their pixels; in a cell of its own it is as exact as any rectangle.
    exact = straight and not (kind == "packed" and case == "sliver")
    assert (off <= (1e-6 if exact else 0.3) * coarsest).all()
    assert np.median(off[inner]) < 1e-6


@pytest.mark.parametrize("kind", LAYOUT_KINDS)
def test_a_drape_is_read_back_the_better_the_more_pixels(kind):
    """A smooth drape: the flat shirt bent around the body."""
    pattern = draft("t-shirt").canonical()
    mesh = mesh_pattern(pattern, 3.0)
    flat = np.concatenate(
        [p.to_world(mesh.flat_vertices[mesh.flat_panel == k]) for k, p in enumerate(pattern.panels)]
    )
    vertices = mesh.welded_mean(flat)
    vertices[:, 2] += 8.0 * np.cos(vertices[:, 0] / 12.0)
    errors = []
    for resolution in (64, 256):
        layout = lay_out_as(kind, pattern, resolution)
        values = geometry_raster(layout, mesh).values(vertices)
        read = mesh.welded_mean(outline_sampler(layout, mesh).weights @ values)
        errors.append(np.linalg.norm(read - vertices, axis=1).mean())
    assert errors[1] < 0.5 * errors[0] and errors[1] < 0.2


def test_few_panels_have_large_cells_and_small_panels_as_many_pixels_as_large_ones():
    layout = lay_out_in_cells(dart_pattern(), 128)
    count = np.bincount(layout.raster.pixel_panel)
    band = next(k for k, p in enumerate(layout.pattern.panels) if p.name == "wb_front")
    assert count[band] == count.max()  # a rectangle, a fortieth of the skirt's area
    assert cell_grid(3) == (2, 2)
    packed = np.bincount(lay_out(dart_pattern(), 128).raster.pixel_panel)
    assert packed[band] < 0.1 * packed.max()


@pytest.mark.parametrize(
    ("kind", "pattern", "resolution", "said"),
    [
        ("stacked", dart_pattern(), 64, "no layout 'stacked'"),
        ("per_panel", Pattern(()), 64, "no panels"),
        ("per_panel", dart_pattern(), 8, "resolution is 8"),
        ("per_panel", dart_pattern(), 64.0, "resolution is 64.0"),
        ("per_panel", Pattern(tuple(rectangle(f"p{k}", 9, 9) for k in range(122))), 64, "cells of 5 x 5"),
    ],
)
def test_what_cannot_be_laid_out_is_refused(kind, pattern, resolution, said):
    with pytest.raises(InputError, match=said):
        lay_out_as(kind, pattern, resolution)


@pytest.mark.parametrize("stretch", [np.ones((2, 2)), np.zeros((3, 2)), np.full((3, 2), np.nan)])
def test_a_stretch_that_is_none_is_refused(stretch):
    with pytest.raises(InputError, match="stretch"):
        replace(lay_out(dart_pattern(), 64), stretch=stretch)


def test_the_file_of_one_square_does_not_take_stretched_panels(tmp_path):
    garment = any_garment(dart_pattern())
    images = replace(encode(garment, 64), layout=lay_out_in_cells(garment.pattern, 64))
    with pytest.raises(InputError, match="one scale"):
        write_ggi(images, tmp_path / "ggi.npz")
    assert not (tmp_path / "ggi.npz").exists()
