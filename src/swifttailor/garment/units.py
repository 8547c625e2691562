"""The one place where centimetres become metres and back."""

from __future__ import annotations

import numpy as np

from swifttailor.arrays import Array

CM_PER_METRE = 100.0


def to_metres(lengths: Array) -> Array:
    """Metres of lengths in cm, any shape."""
    return np.asarray(lengths, np.float64) / CM_PER_METRE


def from_metres(lengths: Array) -> Array:
    """Centimetres of lengths in metres, any shape."""
    return np.asarray(lengths, np.float64) * CM_PER_METRE
