import numpy as np
import pytest
import shapely
from ggi_patterns import HARD_CASES, patterns, rectangle
from hypothesis import given, settings
from hypothesis import strategies as st

from swifttailor.errors import InputError
from swifttailor.ggi import lay_out, raster
from swifttailor.ggi.outlines import TOLERANCE
from swifttailor.pattern import Pattern
from swifttailor.pattern import curve as curves
from swifttailor.pattern.drafts import draft

RESOLUTIONS = st.sampled_from([32, 64, 150])


def rows_columns(pixels, size):
    return np.stack([pixels // size, pixels % size], axis=1)


def polygons(layout):
    outlines = layout.outlines
    for k in range(len(layout.pattern.panels)):
        yield k, shapely.Polygon(layout.to_pixels(k, outlines.points[outlines.panel == k]))


def assert_drawn_as_promised(layout):
    drawn, outlines, size = layout.raster, layout.outlines, layout.resolution
    assert (np.diff(drawn.pixels) > 0).all()
    centers = rows_columns(drawn.pixels, size)[:, ::-1] + 0.5
    inside = drawn.edge < 0

    # The inside is the pixels whose centre is enclosed, each standing for its centre.
    assert np.array_equal(drawn.points[inside], centers[inside])
    everywhere = np.stack(np.meshgrid(np.arange(size), np.arange(size)), axis=-1).reshape(-1, 2) + 0.5
    for k, polygon in polygons(layout):
        if not polygon.is_valid:  # a random star may cross itself
            continue
        shapely.prepare(polygon)
        of_panel = drawn.pixels[(drawn.pixel_panel == k) & inside]
        enclosed = shapely.contains_xy(polygon.buffer(1e-9), *everywhere.T)
        safely = shapely.contains_xy(polygon.buffer(-1e-9), *everywhere.T)
        assert enclosed[of_panel].all()
        assert (drawn.panel.ravel()[safely] == k).all()

    # A pixel of the contour stands for a point in it and on its edge.
    off = np.abs(drawn.points - centers)
    assert (off <= 0.5).all()
    for number in np.unique(drawn.edge[~inside]):
        shown = drawn.edge == number
        assert_on_edge(layout, number, drawn.points[shown], drawn.fraction[shown])
        assert (drawn.pixel_panel[shown] == outlines.edge_panel[number]).all()

    # Along every edge the pixels form a chain, one pixel wide, from corner to corner.
    for number in range(len(outlines.edge_panel)):
        run = slice(drawn.contour_start[number], drawn.contour_start[number + 1])
        chain, fraction = drawn.contour_pixels[run], drawn.contour_fraction[run]
        assert len(chain) >= 1 and len(np.unique(chain)) == len(chain)
        assert (np.diff(fraction) >= 0).all() and fraction[0] >= 0 and fraction[-1] <= 1
        place = rows_columns(chain, size)
        assert (np.abs(np.diff(place, axis=0)).max(axis=1, initial=0) == 1).all() or len(chain) == 1
        panel = int(outlines.edge_panel[number])
        ends = layout.pattern.panels[panel].chord(number - outlines.first_edge[panel])
        corners = layout.to_pixels(panel, ends)[:, ::-1]  # one on a border of pixels may be in either
        near = [corners + np.array([row, column]) for row in (-1e-9, 1e-9) for column in (-1e-9, 1e-9)]
        expected = np.floor(np.concatenate(near)).astype(int).tolist()
        # An edge that leaves a pixel and comes back to it has that pixel once.
        back = (np.floor(corners[0]) == np.floor(corners[1])).all()
        reached = [place[k].tolist() in expected for k in (0, -1)]
        assert any(reached) if back else all(reached)
        assert drawn.occupancy.ravel()[chain].all()
    assert len(drawn.contour_pixels) == drawn.contour_start[-1]
    assert np.array_equal(drawn.occupancy, drawn.panel >= 0)
    assert np.array_equal(np.flatnonzero(drawn.occupancy), drawn.pixels)


def assert_on_edge(layout, number, points, fraction):
    """The points are the edge's own, at the fractions of its arc length that are given."""
    panel = int(layout.outlines.edge_panel[number])
    edge = number - layout.outlines.first_edge[panel]
    shape = layout.pattern.panels[panel]
    curve, chord = shape.edges[edge].curve, shape.chord(edge)
    there = curves.evaluate(curve, chord, curves.parameters_by_length(curve, chord, fraction))
    # The polyline is off by TOLERANCE across the edge and by little more along it.
    size = max(np.ptp(p.vertices, axis=0).max() for p in layout.pattern.panels)
    allowed = 20 * TOLERANCE * size / layout.cm_per_pixel
    assert np.abs(layout.to_pixels(panel, there) - points).max() < allowed + 1e-6


@settings(max_examples=60, deadline=None)
@given(patterns(most=5), RESOLUTIONS)
def test_random_patterns_are_drawn_as_promised(pattern, resolution):
    assert_drawn_as_promised(lay_out(pattern, resolution))


@pytest.mark.parametrize("case", HARD_CASES)
@pytest.mark.parametrize("resolution", [16, 128])
def test_hard_cases_are_drawn_as_promised(case, resolution):
    assert_drawn_as_promised(lay_out(HARD_CASES[case](), resolution))


def test_a_draft_is_drawn_as_promised():
    assert_drawn_as_promised(lay_out(draft("shirt-dress"), 200))


@settings(max_examples=60, deadline=None)
@given(patterns(most=6), RESOLUTIONS, st.integers(1, 4))
def test_pixels_of_two_panels_never_come_nearer_than_the_gutter(pattern, resolution, gutter):
    panel = lay_out(pattern, resolution, gutter=gutter).raster.panel
    padded = np.pad(panel, gutter, constant_values=-1)
    for dy in range(-gutter, gutter + 1):
        for dx in range(-gutter, gutter + 1):
            moved = padded[gutter + dy : gutter + dy + len(panel), gutter + dx : gutter + dx + len(panel)]
            assert not ((panel >= 0) & (moved >= 0) & (panel != moved)).any()


def test_the_contour_has_no_spare_corners():
    """Two pixels of an edge that touch have none between them, which would fold the squares of Alg. 5."""
    drawn = lay_out(draft("shirt-dress"), 256).raster
    place = rows_columns(drawn.contour_pixels, 256)
    edge = np.repeat(np.arange(len(drawn.contour_start) - 1), np.diff(drawn.contour_start))
    two_on = np.abs(place[2:] - place[:-2]).max(axis=1)
    assert (two_on[edge[2:] == edge[:-2]] > 1).all()


def test_every_edge_ends_where_the_next_begins():
    layout = lay_out(draft("shirt-dress"), 256)
    drawn, outlines = layout.raster, layout.outlines
    for k in range(len(layout.pattern.panels)):
        numbers = np.arange(outlines.first_edge[k], outlines.first_edge[k + 1])
        last = drawn.contour_pixels[drawn.contour_start[numbers + 1] - 1]
        first = drawn.contour_pixels[drawn.contour_start[numbers]]
        assert np.array_equal(last, np.roll(first, -1))


def test_a_corner_keeps_its_place():
    """Corners are not rounded off: the pixel of each stands for the corner itself."""
    layout = lay_out(draft("fitted-dress"), 256)
    drawn = layout.raster
    of_pixel = dict(zip(drawn.pixels.tolist(), drawn.points, strict=True))
    for k, panel in enumerate(layout.pattern.panels):
        corners = layout.to_pixels(k, panel.vertices)
        pixels = np.floor(corners).astype(int) @ [1, 256]
        alone = [p for p in range(len(corners)) if (pixels == pixels[p]).sum() == 1]
        assert len(alone) > len(corners) / 2
        for p in alone:
            assert np.allclose(of_pixel[pixels[p]], corners[p], rtol=0, atol=1e-9)


def test_a_panel_thinner_than_a_pixel_keeps_all_its_edges():
    layout = lay_out(HARD_CASES["sliver"](), 128)
    drawn = layout.raster
    cuff = layout.pattern.panel_index("sl_left_cuff_f")
    first = layout.outlines.first_edge[cuff]
    bottom, top = (
        drawn.contour_pixels[drawn.contour_start[e] : drawn.contour_start[e + 1]] for e in (first, first + 2)
    )
    assert (drawn.panel == cuff).sum() == len(bottom)
    assert np.array_equal(bottom, top[::-1])


def test_clockwise_panels_are_filled_like_others():
    pattern = Pattern((rectangle("a", 30.0, 20.0), rectangle("b", 30.0, 20.0, clockwise=True)))
    panel = lay_out(pattern, 64).raster.panel
    assert (panel == 0).sum() == (panel == 1).sum() > 500


def test_a_longer_side_drawn_finer_covers_its_area():
    pattern = Pattern((rectangle("a", 33.3, 20.7),))
    for resolution in (64, 256, 1024):
        layout = lay_out(pattern, resolution)
        inside = (layout.raster.edge < 0).sum() * layout.cm_per_pixel**2
        all_of_it = layout.raster.occupancy.sum() * layout.cm_per_pixel**2
        assert inside <= 33.3 * 20.7 <= all_of_it
        assert all_of_it - inside <= 2.1 * (33.3 + 20.7) * layout.cm_per_pixel


def test_absurdly_long_outlines_are_refused(monkeypatch):
    monkeypatch.setattr(raster, "MAX_CROSSINGS", 100)
    with pytest.raises(InputError, match=r"cross .* rows and columns .* at most 100"):
        _ = lay_out(draft("shirt-dress")).raster
