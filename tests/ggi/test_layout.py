from dataclasses import replace

import numpy as np
import pytest
from ggi_patterns import HARD_CASES, dart_pattern, patterns, rectangle
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from swifttailor.errors import InputError
from swifttailor.ggi import Layout, lay_out
from swifttailor.ggi.layout import SCALE_STEP
from swifttailor.ggi.outlines import TOLERANCE, trace_outlines
from swifttailor.pattern import EdgeRef, Pattern, Stitch
from swifttailor.pattern.drafts import draft, list_drafts

RESOLUTIONS = st.sampled_from([64, 100, 256])


def assert_apart(layout, gutter):
    """No two boxes come nearer than the gutter, and none leaves the image."""
    boxes = layout.boxes
    assert boxes.min() >= 1 and boxes.max() <= layout.resolution - 2
    for k, (left, bottom, right, top) in enumerate(boxes):
        others = np.delete(boxes, k, axis=0)
        beside = (others[:, 0] - right > gutter) | (left - others[:, 2] > gutter)
        above = (others[:, 1] - top > gutter) | (bottom - others[:, 3] > gutter)
        assert (beside | above).all()


@settings(max_examples=60, deadline=None)
@given(patterns(), RESOLUTIONS, st.integers(1, 5), st.sampled_from(["rows", "skyline"]))
def test_panels_never_come_nearer_than_the_gutter(pattern, resolution, gutter, packing):
    assert_apart(lay_out(pattern, resolution, gutter=gutter, packing=packing), gutter)


@pytest.mark.parametrize("name", [d.name for d in list_drafts()])
@pytest.mark.parametrize("packing", ["rows", "skyline"])
def test_every_draft_is_laid_out(name, packing):
    layout = lay_out(draft(name), packing=packing)
    assert_apart(layout, 2)
    assert layout.raster.occupancy.mean() > 0.3


@settings(max_examples=40, deadline=None)
@given(patterns(), RESOLUTIONS, st.floats(1.0, 20.0), st.sampled_from(["rows", "skyline"]))
def test_what_fits_at_a_scale_fits_at_every_coarser_one(pattern, resolution, factor, packing):
    finest = lay_out(pattern, resolution, packing=packing)
    coarser = lay_out(pattern, resolution, packing=packing, cm_per_pixel=factor * finest.cm_per_pixel)
    assert coarser.cm_per_pixel == factor * finest.cm_per_pixel
    assert_apart(coarser, 2)


@settings(max_examples=40, deadline=None)
@given(patterns(), RESOLUTIONS)
def test_rows_find_the_finest_scale_of_the_ladder(pattern, resolution):
    layout = lay_out(pattern, resolution, packing="rows")
    low, high = layout.outlines.bounds
    area = float((high - low).prod(axis=1).sum())
    if layout.cm_per_pixel * resolution > 1.001 * max(np.sqrt(area), (high - low).max()):
        with pytest.raises(InputError, match="do not fit into"):
            lay_out(pattern, resolution, packing="rows", cm_per_pixel=layout.cm_per_pixel / SCALE_STEP)


@settings(max_examples=40, deadline=None)
@given(patterns(), RESOLUTIONS)
def test_the_skyline_is_never_coarser_than_rows(pattern, resolution):
    rows = lay_out(pattern, resolution, packing="rows").cm_per_pixel
    assert lay_out(pattern, resolution, packing="skyline").cm_per_pixel <= rows


@settings(max_examples=40, deadline=None)
@given(patterns(most=4), RESOLUTIONS, st.data())
def test_pixels_and_centimetres_are_inverse_and_keep_lengths(pattern, resolution, data):
    layout = lay_out(pattern, resolution)
    index = data.draw(st.integers(0, len(pattern.panels) - 1))
    points = layout.pattern.panels[index].vertices
    pixels = layout.to_pixels(index, points)
    assert np.allclose(layout.to_local(index, pixels), points, rtol=0, atol=1e-9 * np.abs(points).max())
    lengths = np.linalg.norm(pixels - pixels[0], axis=1) * layout.cm_per_pixel
    assert np.allclose(lengths, np.linalg.norm(points - points[0], axis=1), rtol=1e-9, atol=1e-9)
    # Seen from the right side, every loop runs anticlockwise.
    area = layout.pattern.panels[index].signed_area()
    assume(abs(area) > 1e-6)
    moved = pixels - pixels.mean(axis=0)
    chords = np.sum(moved[:, 0] * np.roll(moved[:, 1], -1) - moved[:, 1] * np.roll(moved[:, 0], -1))
    unmoved = points - points.mean(axis=0)
    local = np.sum(unmoved[:, 0] * np.roll(unmoved[:, 1], -1) - unmoved[:, 1] * np.roll(unmoved[:, 0], -1))
    assume(abs(local) > 1e-9 * np.abs(points).max() ** 2)  # of slivers rounding decides
    assert np.sign(chords) == np.sign(local) * np.sign(area)
    assert layout.mirrored[index] == (area < 0)


def test_one_transform_serves_many_panels():
    layout = lay_out(dart_pattern())
    index = np.array([0, 1, 2, 1])
    points = np.array([[1.0, 2.0], [3.0, 4.0], [5.0, 6.0], [7.0, 8.0]])
    each = [layout.to_pixels(int(k), p[None])[0] for k, p in zip(index, points, strict=True)]
    assert np.array_equal(layout.to_pixels(index, points), each)
    assert np.allclose(layout.to_local(index, layout.to_pixels(index, points)), points)


def test_equal_patterns_are_laid_out_alike_whatever_their_order():
    pattern = draft("shirt-dress")
    shuffled = Pattern(
        pattern.panels[::-1],
        tuple(Stitch(s.second, s.first, s.right_wrong) for s in pattern.stitches[::-1]),
    )
    one, two = lay_out(pattern), lay_out(shuffled)
    assert one.pattern == two.pattern and one.cm_per_pixel == two.cm_per_pixel
    assert np.array_equal(one.origins, two.origins)
    assert np.array_equal(one.raster.panel, two.raster.panel)


def test_a_clockwise_panel_is_mirrored_and_its_first_pixel_is_at_its_corner():
    layout = lay_out(
        Pattern((rectangle("a", 30.0, 40.0, 5.0, 7.0), rectangle("b", 30.0, 39.0, 5.0, 7.0, True)))
    )
    assert layout.mirrored.tolist() == [False, True]
    left, bottom = layout.boxes[0, :2]
    assert np.allclose(layout.to_pixels(0, [[5.0, 7.0]]), [[left + 0.5, bottom + 0.5]])
    left, bottom = layout.boxes[1, :2]
    assert np.allclose(layout.to_pixels(1, [[35.0, 7.0]]), [[left + 0.5, bottom + 0.5]])


@pytest.mark.parametrize("case", HARD_CASES)
@pytest.mark.parametrize("resolution", [16, 64, 512])
def test_hard_cases_are_laid_out(case, resolution):
    assert_apart(lay_out(HARD_CASES[case](), resolution), 2)


@pytest.mark.parametrize(
    ("options", "says"),
    [
        ({"resolution": 8}, "resolution is 8; from 16 to 4096"),
        ({"resolution": 5000}, "resolution is 5000"),
        ({"resolution": 256.0}, r"resolution is 256\.0"),
        ({"gutter": 1.5}, r"gutter is 1\.5"),
        ({"gutter": 0}, "gutter is 0; from 1 to 64"),
        ({"packing": "magic"}, "no packing 'magic'. Known ones: skyline, rows"),
        ({"cm_per_pixel": 0.0}, "scale is 0.0"),
        ({"cm_per_pixel": float("nan")}, "scale is nan"),
        ({"cm_per_pixel": float("inf")}, "scale is inf"),
        ({"cm_per_pixel": 0.01}, r"At 0.01 cm per pixel the 3 panels do not fit .* from 0\.\d+"),
    ],
)
def test_what_cannot_be_laid_out_is_refused(options, says):
    with pytest.raises(InputError, match=says):
        lay_out(dart_pattern(), **options)


def test_the_scale_that_a_refusal_names_is_accepted():
    with pytest.raises(InputError) as refused:
        lay_out(dart_pattern(), cm_per_pixel=0.01)
    named = float(str(refused.value).split("from ")[-1].split(" on")[0])
    assert lay_out(dart_pattern(), cm_per_pixel=named).cm_per_pixel == named


def test_more_panels_than_the_image_has_room_for_are_refused():
    many = Pattern(tuple(rectangle(f"p{k}", 1.0, 1.0) for k in range(100)))
    with pytest.raises(InputError, match="100 panels do not fit into 16 x 16 pixels, however small"):
        lay_out(many, 16)
    assert_apart(lay_out(many, 64), 2)


def test_a_pattern_without_panels_is_refused():
    with pytest.raises(InputError, match="no panels"):
        lay_out(Pattern(()))


def test_layouts_check_themselves():
    layout = lay_out(dart_pattern())
    with pytest.raises(InputError, match="origins of shape"):
        replace(layout, origins=np.zeros((2, 2)))
    with pytest.raises(InputError, match="finite"):
        replace(layout, origins=np.full((3, 2), np.nan))
    with pytest.raises(InputError, match=r"scale is 0\.0; from 1e-06 to 1e\+08"):
        replace(layout, cm_per_pixel=0.0)
    with pytest.raises(ValueError, match="read-only"):
        layout.origins[0] = 0.0
    moved = Layout(layout.pattern, 256, layout.cm_per_pixel, layout.origins + 300.0, layout.mirrored)
    with pytest.raises(InputError, match="does not fit its image"):
        _ = moved.raster
    origins = layout.origins.copy()
    origins[1] += layout.boxes[0, :2] - layout.boxes[1, :2]
    with pytest.raises(InputError, match="boxes of 'skirt_front' and 'skirt_back' overlap"):
        _ = replace(layout, origins=origins).raster


@settings(max_examples=40, deadline=None)
@given(patterns(most=3))
def test_outlines_follow_the_edges(pattern):
    outlines = trace_outlines(pattern)
    size = max(np.ptp(p.vertices, axis=0).max() for p in pattern.panels)
    for k, panel in enumerate(pattern.panels):
        for e in range(len(panel.edges)):
            number = outlines.number(pattern, EdgeRef(panel.name, e))
            assert outlines.edge_panel[number] == k
            of_edge = outlines.edge == number
            points, fraction = outlines.points[of_edge], outlines.fraction[of_edge]
            assert np.array_equal(points[[0, -1]], panel.chord(e))
            assert fraction[0] == 0.0 and fraction[-1] == 1.0 and (np.diff(fraction) >= 0).all()
            # Points at even steps of arc length lie on the polyline, at those fractions of it.
            true = panel.sample_edge(e, 11)
            on_polyline = np.stack(
                [np.interp(np.linspace(0, 1, 11), fraction, points[:, axis]) for axis in (0, 1)], axis=1
            )
            assert np.abs(true - on_polyline).max() < 10 * TOLERANCE * size
        off = (0.001 + TOLERANCE * size) * panel.perimeter()  # signed_area() is good to 0.001 cm
        assert np.isclose(outlines.signed_area[k], panel.signed_area(), rtol=1e-6, atol=off)
        box = panel.bounding_box()
        assert np.abs(np.stack(outlines.bounds, axis=1)[k] - box).max() <= TOLERANCE * size
