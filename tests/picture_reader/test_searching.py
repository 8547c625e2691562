"""Somebody small in a picture is looked for in parts of it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from swifttailor.picture_reader.figures import FIGURES
from swifttailor.picture_reader.reader import PictureReader
from swifttailor.picture_reader.squares import halves

SEEN = 0.15
"""Of a square's side somebody has to be high to be seen by the reader here."""


@dataclass(frozen=True, eq=False)
class Glance(PictureReader):
    """Sees what is white, where that is large enough; several where there is red."""

    def _look(self, pixels, square, view):
        left, top, side = square
        shown = pixels[max(top, 0) : top + side, max(left, 0) : left + side]
        high = (shown.min(axis=2) > 200).any(axis=1).sum() / side
        red = (shown[:, :, 0] > 200).sum() > (shown[:, :, 1] > 200).sum()
        figures = "several" if red else "one" if high > SEEN else "none"
        certain = np.array([6.0 if name == figures else -6.0 for name in FIGURES])
        present = 20 * (high - SEEN) if figures == "one" else -9.0
        return {"figures": certain, "present": np.array([present, -9.0])}


def searched(pixels):
    reader = Glance(None, 8, np.zeros((0, 2), np.float32), {})
    height, width = pixels.shape[:2]
    side = max(height, width)
    whole = ((width - side) // 2, (height - side) // 2, side)
    return whole, *reader._searched(pixels, whole, reader._look(pixels, whole, None))


def street(high):
    pixels = np.zeros((300, 200, 3), np.uint8)
    pixels[240 - high : 240, 140:150] = 255
    return pixels


def test_a_small_person_is_found_in_a_part():
    whole, square, look = searched(street(40))
    assert square != whole and square[2] == 150 and FIGURES[int(look["figures"].argmax())] == "one"
    left, top, side = square
    assert left <= 140 and left + side >= 150 and top <= 200 and top + side >= 240


@pytest.mark.parametrize("high", [0, 10, 120])
def test_nobody_and_somebody_large_are_left_as_they_are(high):
    whole, square, _ = searched(street(high))
    assert square == whole


def test_of_several_nobody_is_chosen():
    pixels = street(40)
    pixels[0, 0] = (255, 0, 0)
    whole, square, _ = searched(pixels)
    assert square == whole


@given(st.tuples(st.integers(1, 60), st.integers(1, 60)))
def test_halves_cover_all_of_a_picture(shape):
    covered = np.zeros(shape, bool)
    squares = halves(shape)
    for left, top, side in squares:
        assert side == max(max(shape) // 2, 1)
        covered[max(top, 0) : top + side, max(left, 0) : left + side] = True
    assert covered.all() or max(shape) % 2, "but for a line in the middle of odd sides"
    assert len(squares) <= 9
