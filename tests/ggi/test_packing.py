import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from swifttailor.ggi.packing import pack_rows, pack_skyline

boxes = st.lists(st.tuples(st.integers(1, 60), st.integers(1, 60)), min_size=1, max_size=30)
sides = st.integers(1, 260)
PACKINGS = [pack_rows, pack_skyline]


def by_height(listed):
    return np.array(sorted(listed, key=lambda s: (-s[1], -s[0])))


def area_of_union(sizes, corners):
    covered = np.zeros((400, 400), int)
    for (w, h), (x, y) in zip(sizes, corners, strict=True):
        covered[y : y + h, x : x + w] += 1
    assert covered.max() <= 1
    return covered.sum()


@pytest.mark.parametrize("pack", PACKINGS)
@given(boxes, sides)
def test_boxes_never_overlap_and_stay_inside(pack, listed, side):
    sizes = by_height(listed)
    corners = pack(sizes, side)
    if corners is None:
        return
    assert (corners >= 0).all() and (corners + sizes <= side).all()
    assert area_of_union(sizes, corners) == sizes.prod(axis=1).sum()


@given(boxes, sides, st.integers(0, 60))
def test_rows_that_fit_fit_into_every_larger_square(listed, side, more):
    sizes = by_height(listed)
    if pack_rows(sizes, side) is not None:
        assert pack_rows(sizes, side + more) is not None


@given(boxes, sides, st.floats(1.0, 4.0))
def test_rows_that_fit_fit_at_every_coarser_scale(listed, side, factor):
    """What the binary search over scales rests on."""
    sizes = by_height(listed)
    if pack_rows(sizes, side) is not None:
        assert pack_rows(np.floor(sizes / factor + 0.5).astype(int), side) is not None


@pytest.mark.parametrize("pack", PACKINGS)
def test_everything_fits_into_a_square_of_all_heights_and_the_greatest_width(pack):
    sizes = by_height([(7, 30), (40, 3), (12, 12), (1, 1)])
    assert pack(sizes, 46) is not None
    assert pack(sizes, 39) is None  # narrower than the widest


def test_rows_are_filled_from_left_to_right_and_from_bottom_to_top():
    sizes = np.array([[4, 5], [4, 4], [4, 3], [2, 2]])
    assert pack_rows(sizes, 10).tolist() == [[0, 0], [4, 0], [0, 5], [4, 5]]


def test_the_skyline_uses_the_room_above_low_boxes():
    sizes = np.array([[5, 9], [5, 4], [5, 4]])
    assert pack_skyline(sizes, 10).tolist() == [[0, 0], [5, 0], [5, 4]]
    assert pack_rows(sizes, 10) is None


@settings(max_examples=30)
@given(boxes, st.integers(60, 200))
def test_the_skyline_is_where_plain_search_puts_it(listed, side):
    sizes = by_height(listed)
    skyline, expected = [0] * side, []
    for w, h in sizes.tolist():
        places = [(max(skyline[x : x + w]), x) for x in range(side - w + 1)]
        y, x = min(places)
        if y + h > side:
            expected = None
            break
        skyline[x : x + w] = [y + h] * w
        expected.append([x, y])
    found = pack_skyline(sizes, side)
    assert (None if found is None else found.tolist()) == expected
