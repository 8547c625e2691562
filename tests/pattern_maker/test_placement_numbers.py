"""A placement as the point where a panel's top is."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from swifttailor.pattern import Placement
from swifttailor.pattern_maker.tokens.normalization import normalize_translation, translation_in_cm
from swifttailor.pattern_maker.tokens.placement_numbers import placement_numbers, placement_of
from swifttailor.pattern_maker.tokens.vocabulary import NUMBERS, QUATERNION, TRANSLATION

SQUARE = np.array([[0.0, 0.0], [40.0, 0.0], [40.0, 30.0], [0.0, 30.0]])
ORIGIN = np.zeros(2)


@pytest.mark.parametrize(
    ("rotation", "top"),
    [((0, 0, 0), (20, 30)), ((0, 0, 180), (20, 0)), ((0, 0, 90), (40, 15)), ((0, 0, -90), (0, 15))],
)
def test_the_translation_is_where_the_highest_side_is(rotation, top):
    placement = Placement((3.0, 100.0, -7.0), rotation)
    row = placement_numbers(placement, SQUARE, ORIGIN)
    expected = placement.apply([top])[0]
    np.testing.assert_allclose(translation_in_cm(row[TRANSLATION]), expected, atol=1e-4)


@pytest.mark.parametrize("rotation", [(90, 0, 0), (-90, 30, 0), (90, 45, 0), (0, 0, 45), (0, 180, 45)])
def test_predicted_corners_a_little_off_do_not_move_a_panel_far(rotation):
    """Two of its sides are equally high: the noise must not choose between them."""
    size = np.array([[0.0, 0.0], [40.0, 0.0], [40.0, 40.0], [0.0, 40.0]])
    placement, random = Placement((0.0, 100.0, 0.0), rotation), np.random.default_rng(1)
    row = placement_numbers(placement, size, ORIGIN)
    for _ in range(50):
        moved = placement_of(row, size + random.uniform(-0.3, 0.3, size.shape))
        assert np.linalg.norm(np.subtract(moved.translation, placement.translation)) < 2.0


def test_a_rotation_has_one_quaternion_whatever_its_angles():
    """Half turns too, whose w is 0 or, by rounding, on either side of it."""
    for angles in [(-180, 20, 180), (180, 20, -180), (0, 160, 0), (0, -200, 0), (0, 180, 0), (0, -180, 0)]:
        row = placement_numbers(Placement((0, 0, 0), angles), SQUARE, ORIGIN)
        assert row[QUATERNION][3] > -1e-6
        same = placement_numbers(Placement((0, 0, 0), tuple(a + 360 for a in angles)), SQUARE, ORIGIN)
        np.testing.assert_allclose(same[QUATERNION], row[QUATERNION], atol=1e-6)
    assert placement_numbers(Placement((0, 0, 0), (0, -180, 0)), SQUARE, ORIGIN)[QUATERNION][1] > 0.999


def test_angles_come_back_as_one_matrix_even_where_they_are_not_determined():
    for angles in [(10, 90, 20), (10, -90, 20), (0, 89.9999, 5), (90, 45, 0)]:
        placement = Placement((1.0, 2.0, 3.0), angles)
        again = placement_of(placement_numbers(placement, SQUARE, ORIGIN), SQUARE)
        np.testing.assert_allclose(again.matrix(), placement.matrix(), atol=1e-4)
        np.testing.assert_allclose(again.apply(SQUARE), placement.apply(SQUARE), atol=1e-2)


def test_numbers_of_a_network_need_not_be_a_unit_quaternion():
    row = np.zeros(NUMBERS, np.float32)
    row[TRANSLATION] = normalize_translation([0.0, 100.0, 0.0])
    np.testing.assert_array_equal(placement_of(row, SQUARE).matrix(), np.eye(3))
    half = Rotation.from_euler("y", 50, degrees=True)
    row[QUATERNION] = 0.3 * half.as_quat()
    np.testing.assert_allclose(placement_of(row, SQUARE).matrix(), half.as_matrix(), atol=1e-6)
