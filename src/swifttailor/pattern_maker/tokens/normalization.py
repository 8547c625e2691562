"""From centimetres to numbers of about unit size, and back.

The constants are means and standard deviations over the training split, by
``scripts/measure_token_statistics.py``. They are part of trained weights: they do not change.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

POINT_SHIFT = np.array([10.6235, 18.7962])
POINT_SCALE = np.array([27.5288, 26.6479])
"""Of points of a panel, cm from its first vertex."""
TRANSLATION_SHIFT = np.array([-0.1439, 110.1215, 2.6745])
TRANSLATION_SCALE = np.array([25.626, 36.4017, 25.5975])
"""Of the points in the world that placements name, cm."""
WIDEST_MEASURED = 250.0
"""Panels wider or higher than this, cm, were left out: a few tiered skirts of up to 28 m would decide the
scale for all others."""


def normalize_points(points: ArrayLike) -> NDArray[np.float32]:
    """Points (..., 2) in cm from the panel's first vertex, as the network has them."""
    return ((np.asarray(points, np.float64) - POINT_SHIFT) / POINT_SCALE).astype(np.float32)


def points_in_cm(numbers: ArrayLike) -> NDArray[np.float64]:
    """The inverse of `normalize_points`."""
    return np.asarray(numbers, np.float64) * POINT_SCALE + POINT_SHIFT


def normalize_translation(translation: ArrayLike) -> NDArray[np.float32]:
    """A point of the world (..., 3) in cm, as the network has it."""
    numbers = (np.asarray(translation, np.float64) - TRANSLATION_SHIFT) / TRANSLATION_SCALE
    return numbers.astype(np.float32)


def translation_in_cm(numbers: ArrayLike) -> NDArray[np.float64]:
    """The inverse of `normalize_translation`."""
    return np.asarray(numbers, np.float64) * TRANSLATION_SCALE + TRANSLATION_SHIFT
