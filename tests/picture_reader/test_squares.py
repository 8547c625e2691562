"""Squares of pictures, and what was found in one as part of the whole."""

from __future__ import annotations

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from swifttailor.picture_reader.squares import around, box_of, mask_of, scaled

CELLS = 48


def shown(top, left, bottom, right):
    cells = np.zeros((CELLS, CELLS), bool)
    cells[top:bottom, left:right] = True
    return cells


@given(st.integers(2, 30), st.integers(2, 30), st.integers(0, 18), st.integers(0, 18), st.integers(200, 2000))
def test_a_square_around_a_garment_has_it_in_the_middle(height, width, top, left, side):
    square = (-30, 70, side)
    found = around(shown(top, left, top + height, left + width), square)
    cell = side / CELLS
    wide = max(height, width) * cell * 1.7
    if found is None:
        assert wide > 0.84 * side
        return
    x, y, new = found
    assert abs(new - wide) <= 0.5 and new < 0.85 * side
    assert abs(x + new / 2 - (-30 + (left + width / 2) * cell)) <= 1
    assert abs(y + new / 2 - (70 + (top + height / 2) * cell)) <= 1


def test_there_is_no_square_around_nothing_or_around_all():
    assert around(np.zeros((CELLS, CELLS), bool), (0, 0, 480)) is None
    assert around(shown(5, 5, 6, 30), (0, 0, 480)) is None, "a row is no garment"
    assert around(shown(2, 2, 46, 46), (0, 0, 480)) is None, "it fills what was looked at"
    assert around(shown(5, 5, 9, 9), (0, 0, 48)) is None, "too few pixels"


@given(st.integers(-200, 200), st.integers(-200, 200), st.integers(8, 900), st.floats(0.1, 3))
def test_a_scaled_square_has_the_same_middle(left, top, side, scale):
    x, y, new = scaled((left, top, side), scale)
    assert new == max(round(side * scale), 8)
    assert abs(x + new / 2 - left - side / 2) <= 1 and abs(y + new / 2 - top - side / 2) <= 1
    assert box_of((x, y, new)) == (x, y, x + new, y + new)


@given(st.integers(-60, 60), st.integers(-60, 60), st.integers(60, 200))
def test_cells_of_a_square_are_where_it_lies_in_the_picture(left, top, side):
    cells = shown(12, 12, 36, 36).astype(float)
    mask = mask_of(cells, (left, top, side), (120, 150))
    assert mask.shape == (120, 150) and mask.min() >= 0 and mask.max() <= 1
    rows, columns = np.arange(120)[:, None], np.arange(150)
    down, across = (rows + 0.5 - top) / side, (columns + 0.5 - left) / side
    away = np.maximum(abs(down - 0.5), abs(across - 0.5))
    off = 1.5 / CELLS
    assert (mask[np.broadcast_to(away < 0.25 - off, mask.shape)] > 0.5).all()
    assert (mask[np.broadcast_to(away > 0.25 + off, mask.shape)] < 0.5).all()
