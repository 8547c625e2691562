"""Small pictures of flat patterns."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from PIL import ImageColor

from swifttailor.pattern import Edge, Panel, Pattern
from swifttailor.pattern.drafts import draft
from swifttailor.pattern.svg.drawing import PALETTE
from swifttailor.render.pattern_picture import fitting_scale, pattern_picture

SIZE = (300, 240)
CLOTH = ImageColor.getrgb("#f4f1ec")


def pixels(picture) -> np.ndarray:
    return np.asarray(picture).astype(int)


def is_color(picture, color: str) -> np.ndarray:
    return np.abs(pixels(picture) - ImageColor.getrgb(color)).max(axis=-1) < 40


def is_cloth(picture) -> np.ndarray:
    return np.abs(pixels(picture) - CLOTH).max(axis=-1) < 9  # making it smaller rings at its borders


def square(side: float, name: str = "front") -> Pattern:
    corners = [[0.0, 0.0], [side, 0.0], [side, side], [0.0, side]]
    return Pattern((Panel(name, corners, (Edge(),) * 4),))


def test_a_square_is_drawn_at_the_scale():
    picture = pattern_picture(square(40.0), SIZE, scale=3.0)
    assert picture.size == SIZE
    cloth = is_cloth(picture)[:200]  # without the scale bar
    rows, columns = np.flatnonzero(cloth.any(axis=1)), np.flatnonzero(cloth.any(axis=0))
    # Its outline covers a pixel at each side.
    assert len(rows) == pytest.approx(118, abs=3) and len(columns) == pytest.approx(118, abs=3)
    assert cloth[rows[0] : rows[-1], columns[0] : columns[-1]].mean() > 0.9  # but for its name


def test_it_fits_at_the_fitting_scale_and_not_at_more():
    pattern = draft("shirt-dress")
    scale = fitting_scale(pattern, SIZE)
    for factor, cut in ((1.0, False), (1.3, True)):
        picture = pixels(pattern_picture(pattern, SIZE, scale=scale * factor))
        border = np.concatenate([picture[:, -2:].reshape(-1, 3), picture[:, :2].reshape(-1, 3)])
        assert (border.min() < 150) == cut
    assert (pixels(pattern_picture(pattern, SIZE)) == pixels(pattern_picture(pattern, SIZE, scale))).all()


def test_both_edges_of_a_stitch_have_its_color(square_pattern):
    picture = pattern_picture(square_pattern, SIZE)
    middle = SIZE[0] // 2
    for number in range(2):
        found = is_color(picture, PALETTE[number])
        assert found[:, :middle].sum() > 100 and found[:, middle:].sum() > 100
    free = pattern_picture(replace(square_pattern, stitches=()), SIZE)
    assert not any(is_color(free, color).sum() for color in PALETTE[:2])


def test_panels_are_seen_from_the_right_side():
    """A panel whose loop runs clockwise is turned over, so that its notch changes sides."""
    corners = [[0.0, 0.0], [60.0, 0.0], [60.0, 40.0], [20.0, 40.0], [20.0, 20.0], [0.0, 20.0]]
    loop = Panel("", corners, (Edge(),) * 6)
    turned = loop.mirrored()
    assert loop.signed_area() > 0 > turned.signed_area()
    pictures = [pixels(pattern_picture(Pattern((p,)), SIZE)) for p in (loop, turned)]
    assert (pictures[0] == pictures[1]).all()


def test_names_are_written_where_there_is_room():
    named, nameless = (pattern_picture(square(40.0, name), SIZE, scale=3.0) for name in ("front", ""))
    assert (pixels(named) != pixels(nameless)).any()
    small = [pattern_picture(square(4.0, name), SIZE, scale=3.0) for name in ("left_sleeve_f", "")]
    assert (pixels(small[0]) == pixels(small[1])).all()


def test_nothing_and_next_to_nothing_can_be_drawn():
    assert pattern_picture(Pattern(()), SIZE).size == SIZE
    flat = Pattern((Panel("front", [[0.0, 0.0], [0.0, 0.0]], (Edge(), Edge())),))
    assert pattern_picture(flat, SIZE).size == SIZE
    huge = square(30_000.0)
    assert is_cloth(pattern_picture(huge, SIZE)).mean() > 0.4
