import numpy as np
import pytest
from ggi_patterns import HARD_CASES, any_garment, dart_pattern, patterns, rectangle
from hypothesis import given, settings
from hypothesis import strategies as st

from swifttailor.ggi import encode, lay_out
from swifttailor.ggi.stitching import stitching_image
from swifttailor.pattern import EdgeRef, Pattern, Stitch
from swifttailor.pattern.drafts import draft, list_drafts

SEWN = [*HARD_CASES.values(), *[lambda name=d.name: draft(name) for d in list_drafts()]]


@settings(max_examples=60, deadline=None)
@given(patterns(), st.sampled_from([32, 100]))
def test_sides_follow_their_edges(pattern, resolution):
    layout = lay_out(pattern, resolution)
    image, drawn = stitching_image(layout), layout.raster
    assert image.stitch_count == len(pattern.stitches)
    for k, stitch in enumerate(layout.pattern.stitches):
        for side, ref in enumerate(stitch.sides):
            number = layout.outlines.number(layout.pattern, ref)
            run = slice(drawn.contour_start[number], drawn.contour_start[number + 1])
            pixels, fraction = image.side(k, side)
            turned = side == 1 and not stitch.right_wrong
            assert np.array_equal(pixels[:: -1 if turned else 1], drawn.contour_pixels[run])
            travelled = 1 - fraction[::-1] if turned else fraction
            assert np.allclose(travelled, drawn.contour_fraction[run], rtol=0, atol=1e-6)
            assert (np.diff(fraction) >= 0).all()
    sewn = np.zeros(resolution**2, bool)
    sewn[image.pixels] = True
    assert np.array_equal(image.ids.ravel() > 0, sewn)
    assert image.ids.max() <= len(pattern.stitches) and image.ids.dtype == np.uint16
    # An id stands only where its stitch runs.
    for pixel in np.flatnonzero(sewn)[::7]:
        stitches = np.repeat(np.arange(len(image.start) - 1) // 2, np.diff(image.start))
        assert image.ids.ravel()[pixel] - 1 in stitches[image.pixels == pixel]


@pytest.mark.parametrize("make", SEWN)
def test_both_sides_of_a_seam_meet_in_space(make):
    """The way round is right: at equal fractions both sides show the same point of the seam.

    The vertices are random, so that nothing but the right vertices can agree.
    """
    garment = any_garment(make(), 2.5)
    images = encode(garment, 256)
    drawn = images.layout.raster
    values = images.geometry.reshape(-1, 3).astype(float)
    numbered = dict(zip(drawn.pixels.tolist(), drawn.edge.tolist(), strict=True))
    compared = 0
    for seam in garment.seams:
        stitch = garment.pattern.stitches[seam.stitch]
        line = garment.vertices[seam.vertices]
        steps = np.linspace(0, 1, len(line))
        for side, ref in enumerate(stitch.sides):
            number = images.layout.outlines.number(garment.pattern, ref)
            pixels, fraction = images.stitching.side(seam.stitch, side)
            own = np.array([numbered[p] == number for p in pixels.tolist()])  # shows this edge's point
            there = np.stack([np.interp(fraction[own], steps, line[:, axis]) for axis in range(3)], axis=1)
            assert np.abs(values[pixels[own]] - there).max(initial=0) < 0.01
            compared += own.sum()
    # What is not compared shows a point of another edge there: corners, and panels thinner than a pixel.
    assert compared > 0.6 * len(images.stitching.pixels)


def test_a_stitch_sewn_the_wrong_way_round_would_be_seen():
    """The test above can fail: turned round, a right_wrong stitch no longer meets."""
    pattern = HARD_CASES["right_wrong"]()
    garment = any_garment(pattern, 2.5)
    images = encode(garment, 256)
    first, _ = images.stitching.side(0, 0)
    second, _ = images.stitching.side(0, 1)
    values = images.geometry.reshape(-1, 3)
    assert np.abs(values[first[5:-5]] - values[second[5:-5]]).max() < 0.01
    assert np.abs(values[first[5:-5]] - values[second[::-1][5:-5]]).max() > 10


def test_partners_are_mutual_where_both_sides_are_of_one_length():
    pattern = Pattern(
        (rectangle("a", 20.0, 50.0), rectangle("b", 31.0, 50.0)),
        (Stitch(EdgeRef("a", 1), EdgeRef("b", 3)),),
    )
    layout = lay_out(pattern, 128)
    image = stitching_image(layout)
    partner = image.partners()
    at = dict(zip(image.pixels.tolist(), partner.tolist(), strict=True))
    assert all(at[p] == q and at[q] == p for p, q in at.items())
    left, right = layout.boxes[0, 1], layout.boxes[1, 1]
    for p, q in at.items():  # at the same height of both rectangles
        assert p // 128 - left == q // 128 - right


@settings(max_examples=30, deadline=None)
@given(patterns(most=5))
def test_partners_are_the_nearest_of_the_other_side(pattern):
    image = stitching_image(lay_out(pattern, 64))
    partner = image.partners()
    offset = 0
    for k in range(image.stitch_count):
        for side in (0, 1):
            pixels, fraction = image.side(k, side)
            others, at = image.side(k, 1 - side)
            for f, found in zip(fraction, partner[offset : offset + len(pixels)], strict=True):
                assert np.isclose(np.abs(at[others == found] - f).min(), np.abs(at - f).min(), atol=1e-6)
            offset += len(pixels)


def test_a_dart_has_two_sides_of_one_panel_that_meet_at_its_tip():
    layout = lay_out(dart_pattern(), 256)
    image = stitching_image(layout)
    dart = next(k for k, s in enumerate(layout.pattern.stitches) if s.first.panel == s.second.panel)
    (first, at_first), (second, at_second) = image.side(dart, 0), image.side(dart, 1)
    assert first[-1] == second[-1] and at_first[-1] == at_second[-1] == 1  # the tip
    assert first[0] != second[0]
    assert layout.raster.panel.ravel()[first[0]] == layout.raster.panel.ravel()[second[0]]


def test_more_stitches_than_a_byte_can_count():
    panels, stitches = [], []
    for k in range(150):
        panels.append(rectangle(f"p{k}", 4.0, 4.0))
        stitches += [Stitch(EdgeRef(f"p{k}", e), EdgeRef(f"p{(k + 1) % 150}", (e + 2) % 4)) for e in (0, 1)]
    image = encode(Pattern(tuple(panels), tuple(stitches)), 512).stitching
    assert image.stitch_count == 300 and len(np.unique(image.ids)) == 301


def test_a_pattern_without_stitches_has_an_empty_image():
    image = encode(Pattern((rectangle("a", 4.0, 4.0),)), 32).stitching
    assert image.stitch_count == 0 and not image.ids.any() and len(image.partners()) == 0
