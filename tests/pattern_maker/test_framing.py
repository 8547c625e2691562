"""Photos with plain backgrounds become pictures like those that networks learn from."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from swifttailor.errors import InputError
from swifttailor.pattern_maker.asking.framing import MARGIN, Framing, frame_figure


def backdrop(height, width, color=(230, 225, 220), slope=(0.0, 0.0), bulge=0.0, noise=0.0, seed=0):
    """(h, w, 3) float: a wall with a gradient, brighter in the middle, and the grain of a camera."""
    y, x = np.mgrid[0:height, 0:width]
    x, y = 2 * x / width - 1, 2 * y / height - 1
    light = slope[0] * x + slope[1] * y - bulge * (x * x + y * y)
    grain = np.random.default_rng(seed).normal(0, noise, (height, width, 3))
    return np.asarray(color, float) + light[..., None] + grain


def photo(height, width, box, cloth=(60, 80, 140), **wall):
    """A bell-shaped dress in a box (left, top, right, bottom), which may leave the picture."""
    made = backdrop(height, width, **wall)
    left, top, right, bottom = box
    y, x = np.mgrid[0:height, 0:width]
    down = (y + 0.5 - top) / (bottom - top)
    across = np.abs((x + 0.5 - (left + right) / 2) / (right - left)) * 2
    dress = (down >= 0) & (down <= 1) & (across <= 0.4 + 0.6 * down)
    made[dress] = cloth + 10 * np.sin(x[dress] / 5)[:, None]
    return made.round().clip(0, 255).astype(np.uint8)


def place_in(framed, box):
    """Of a box (left, top, right, bottom) in the framed square: its extent, and how far off the middle."""
    left, top, right, bottom = framed.box
    side = right - left
    assert side == bottom - top and framed.pixels.shape == (side, side, 3)
    span = max(box[2] - box[0], box[3] - box[1]) / side
    off = [(box[0] + box[2] - left - right) / 2 / side, (box[1] + box[3] - top - bottom) / 2 / side]
    return span, np.abs(off).max()


@given(
    height=st.integers(150, 700),
    width=st.integers(150, 700),
    place=st.tuples(st.floats(0.05, 0.45), st.floats(0.05, 0.45), st.floats(0.2, 0.5), st.floats(0.2, 0.5)),
    color=st.sampled_from([(255, 255, 255), (128, 128, 130), (240, 220, 225), (20, 24, 30)]),
    slope=st.tuples(st.floats(-25, 25), st.floats(-25, 25)),
    noise=st.floats(0, 4),
)
@settings(max_examples=30, deadline=None)
def test_the_figure_comes_to_the_middle_with_space_around_it(height, width, place, color, slope, noise):
    left, top = place[0] * width, place[1] * height
    box = (left, top, left + place[2] * width, top + place[3] * height)
    bend = abs(slope[0]) + abs(slope[1])  # a gradient that is cut off at white is none
    wall = np.clip(color, bend, 255 - bend)
    picture = photo(height, width, box, cloth=(150, 40, 90), color=wall, slope=slope, noise=noise)
    framed = frame_figure(picture)
    if framed.framing is Framing.KEPT:  # by chance a square picture with the dress in its middle
        assert height == pytest.approx(width, rel=0.03)
        return
    assert framed.framing is Framing.CROPPED
    span, off = place_in(framed, box)
    extent = max(box[2] - box[0], box[3] - box[1])
    blur = 3 * max(1.0, max(height, width) / 192) / extent  # the figure is looked for in 192 pixels
    assert 1 / ((1 + 2 * MARGIN) * (1 + 2 * blur)) < span < 1 / (1 + 2 * MARGIN) + 0.02
    assert off < 0.02 + blur


@pytest.mark.parametrize("size", [(400, 300), (300, 400), (64, 200), (1000, 950)])
def test_whatever_the_shape_a_square_comes_out(size):
    height, width = size
    box = (0.3 * width, 0.2 * height, 0.6 * width, 0.9 * height)
    framed = frame_figure(photo(height, width, box))
    side = framed.box[2] - framed.box[0]
    assert framed.pixels.shape == (side, side, 3)
    wall = framed.pixels[:3].reshape(-1, 3)
    assert np.abs(wall - np.array([230, 225, 220])).max() <= 2, "what lies outside is background"


def test_a_background_lit_in_the_middle_is_plain():
    box = (60, 300, 200, 560)
    framed = frame_figure(photo(600, 450, box, bulge=18, noise=2))
    assert framed.framing is Framing.CROPPED
    assert place_in(framed, box)[0] == pytest.approx(0.82, abs=0.05)


def test_what_is_framed_is_left_alone():
    picture = photo(256, 256, (60, 25, 200, 230))
    framed = frame_figure(picture)
    assert framed.framing is Framing.KEPT and framed.pixels is picture and framed.box is None
    small = frame_figure(photo(256, 256, (100, 90, 140, 170)))
    assert small.framing is Framing.CROPPED
    again = frame_figure(small.pixels)
    assert again.framing is Framing.KEPT


def test_a_figure_that_leaves_the_picture_gets_no_space_there():
    """A dress cut off below: the crop ends where the picture does."""
    framed = frame_figure(photo(500, 400, (120, 120, 280, 700), noise=1))
    left, top, right, bottom = framed.box
    assert bottom == pytest.approx(500, abs=3)
    assert 120 - top == pytest.approx(0.11 * 380, abs=12)
    assert (left + right) / 2 == pytest.approx(200, abs=4)
    assert (framed.pixels[-1, framed.pixels.shape[0] // 2] < 160).any(), "the dress goes on to the edge"


def test_specks_and_marks_are_no_part_of_the_figure():
    picture = photo(500, 400, (150, 150, 250, 300))
    picture[480:490, 370:380] = 0
    picture[5:8, 5:8] = 0
    assert place_in(frame_figure(picture), (150, 150, 250, 300))[1] < 0.03


def test_two_pieces_beside_each_other_stay_together():
    picture = photo(400, 700, (100, 100, 250, 300))
    other = photo(400, 700, (420, 120, 560, 290))
    both = np.minimum(picture, other)
    assert place_in(frame_figure(both), (100, 100, 560, 300))[1] < 0.03


@pytest.mark.parametrize(
    ("picture", "framing"),
    [
        (np.full((200, 300, 3), 200, np.uint8), Framing.EMPTY),
        (np.random.default_rng(0).integers(0, 255, (200, 300, 3), np.uint8), Framing.BUSY),
        (np.zeros((1, 1, 3), np.uint8), Framing.BUSY),
        (np.zeros((2, 900, 3), np.uint8), Framing.EMPTY),
    ],
)
def test_pictures_without_a_figure_are_left_alone(picture, framing):
    framed = frame_figure(picture)
    assert framed.framing is framing and framed.pixels is picture


def test_a_street_is_no_plain_background():
    street = np.zeros((300, 300, 3), np.uint8)
    for k in range(0, 300, 30):
        street[:, k : k + 15] = (90, 120, 60)
        street[k : k + 10] //= 2
    street[80:250, 100:200] = (200, 40, 40)
    assert frame_figure(street).framing is Framing.BUSY


@given(
    st.integers(1, 40).flatmap(lambda h: st.tuples(st.just(h), st.integers(1, 40))), st.integers(0, 2**32 - 1)
)
@settings(max_examples=60, deadline=None)
def test_any_picture_gives_a_picture(size, seed):
    chance = np.random.default_rng(seed)
    picture = (chance.integers(0, 255, (*size, 3)) * chance.random()).astype(np.uint8)
    framed = frame_figure(picture)
    assert framed.pixels.dtype == np.uint8 and framed.pixels.ndim == 3 and min(framed.pixels.shape) >= 1


def test_what_is_no_picture_is_refused():
    with pytest.raises(InputError, match="of bytes"):
        frame_figure(np.zeros((4, 4), np.uint8))


def test_a_hand_at_the_border_does_not_push_the_figure_aside():
    picture = photo(500, 300, (90, 60, 210, 440))
    picture[200:230, 150:] = (60, 80, 140)  # an arm that ends outside
    left, _, right, _ = frame_figure(picture).box
    assert (left + right) / 2 == pytest.approx((90 + 300) / 2, abs=0.06 * (right - left))
    half = photo(500, 300, (200, 60, 400, 440))
    left, _, right, _ = frame_figure(half).box
    assert right == pytest.approx(300, abs=3), "half of the dress is outside: no background is put there"
