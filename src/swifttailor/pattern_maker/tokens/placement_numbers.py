"""A panel's placement as the point where its top is, and a quaternion (AIpparel's universal translation)."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from swifttailor.arrays import Floats
from swifttailor.pattern.panel import Placement
from swifttailor.pattern_maker.tokens.normalization import normalize_translation, translation_in_cm
from swifttailor.pattern_maker.tokens.vocabulary import NUMBERS, QUATERNION, TRANSLATION

AS_HIGH = 1.0
"""In cm. Sides this close to the highest count as high: a panel that lies flat has no top, and predicted
corners would decide it by chance."""
SHORTEST_QUATERNION = 1e-3
"""A shorter one, which only a network could give, is taken for no rotation."""


def placement_numbers(placement: Placement, vertices: Floats, first: Floats) -> NDArray[np.float32]:
    """The row of numbers of a panel's placement.

    Args:
        placement: Where the panel stands.
        vertices: (n, 2) cm from its first vertex, as they will be decoded.
        first: (2,) where its first vertex is, cm.

    Returns:
        (8,) normalised translation and quaternion x, y, z, w; the last number is 0.
    """
    row = np.zeros(NUMBERS, np.float32)
    row[QUATERNION] = _one_of_two(Rotation.from_matrix(placement.matrix()).as_quat())
    anchor = _top_middle(vertices, _matrix(row))
    row[TRANSLATION] = normalize_translation(placement.apply(anchor[None] + first)[0])
    return row


def placement_of(row: NDArray[np.float32], vertices: Floats) -> Placement:
    """The inverse of `placement_numbers`.

    Args:
        row: (8,) normalised.
        vertices: (n, 2) cm from the panel's first vertex, which is taken for its origin.
    """
    matrix = _matrix(row)
    anchor = _top_middle(vertices, matrix)
    translation = translation_in_cm(row[TRANSLATION]) - matrix[:, :2] @ anchor
    angles = _angles(matrix)
    return Placement(tuple(translation.tolist()), angles)


def _one_of_two(quaternion: Floats) -> Floats:
    """Of q and -q, which are the same rotation, the one with w > 0; for half turns the first of y, x, z."""
    x, y, z, w = quaternion
    leading = next(c for c in (w, y, x, z) if abs(c) > 1e-6)
    return quaternion if leading > 0 else -quaternion


def _matrix(row: NDArray[np.float32]) -> Floats:
    quaternion = np.asarray(row[QUATERNION], np.float64)
    if np.linalg.norm(quaternion) < SHORTEST_QUATERNION:
        return np.eye(3)
    return Rotation.from_quat(quaternion).as_matrix()


def _angles(matrix: Floats) -> tuple[float, float, float]:
    """Intrinsic angles in degrees, the third 0 where it is not determined, as GarmentCode writes them."""
    if abs(matrix[0, 2]) > 1 - 1e-9:
        a = np.arctan2(matrix[1, 0] * np.sign(matrix[0, 2]), matrix[1, 1])
        return float(np.rad2deg(a)), float(90.0 * np.sign(matrix[0, 2])), 0.0
    a, b, c = Rotation.from_matrix(matrix).as_euler("XYZ", degrees=True).tolist()
    return a, b, c


def _top_middle(vertices: Floats, matrix: Floats) -> Floats:
    """Middle (2,) of that side of the vertices' bounding box which is highest in the world."""
    (left, low), (right, high) = vertices.min(axis=0), vertices.max(axis=0)
    x, y = (left + right) / 2, (low + high) / 2
    middles = np.array([[x, high], [x, low], [right, y], [left, y]])
    heights = middles @ matrix[1, :2]
    return middles[int(np.argmax(heights > heights.max() - AS_HIGH))]
